namespace Gjk.Core;

/// <summary>A plane that separates a pair and turns at a rate of its own while the pair moves, with a proved lower
/// bound of the gap along it.</summary>
/// <remarks>
/// <para>Seen from the plane, every point of a body that turns moves with a bounded second derivative. The gap is the
/// least of the differences of such points, so gap(s) - K s²/2 is concave, and between two fractions the gap is at
/// least its chord less K/2 (s - s0)(s1 - s). Two supports, at s0 and s1, prove the whole step.</para>
/// <para>K, in the plane's axes, which turn at u (w the bodies' rates, d from pivot to pivot, R the reach): the pivots
/// give |u| |u × d| + 2 |u × d'|, a body (|w - u|² + |w × u|) R, since x'' = ((W - U)² + (WU - UW)) x with W and U the
/// cross products' matrices; and where u is 0 it is |w| |w × n| R, as only what the axis turns counts.</para>
/// <para>The rate is free. A fixed normal cuts into a face or an edge as soon as that tilts; one that keeps the corners
/// of the nearest feature level has the true distance's own derivative, and the steps are Newton's. Catto ("Continuous
/// Collision", 2013) fixes the axis to one body, which does that for faces only.</para>
/// </remarks>
internal struct TurningPlane
{
    /// <summary>The fraction at which it was put.</summary>
    public double Start;

    /// <summary>The gap between the shapes along it at the start.</summary>
    public double Gap;

    /// <summary>How that changes at first, per fraction 1: at most, for the corners known.</summary>
    public double Rate;

    /// <summary>Upper bound of the gap's second derivative along any pair of points.</summary>
    public double Curvature;

    /// <summary>The step that promises to be the longest proved one.</summary>
    public double Step;

    /// <summary>From B to A, of unit length, in the world's axes, at the start.</summary>
    public Double3 Normal;

    /// <summary>How the normal turns, radians per fraction 1.</summary>
    private Double3 _turn;

    /// <summary>The plane with the longest step that the pair's nearest feature promises.</summary>
    /// <param name="state">The solved distance.</param>
    /// <param name="frame">The pair at the fraction.</param>
    /// <param name="motion">How it moves.</param>
    /// <param name="start">The fraction.</param>
    /// <param name="end">The last fraction of interest.</param>
    /// <param name="aim">The gap that the step shall leave.</param>
    /// <param name="plane">Gets the plane.</param>
    public static void Choose(
        in SolverState state, in PairFrame frame, in PairMotion motion, double start, double end, double aim,
        out TurningPlane plane)
    {
        double scale = 1 / Math.Sqrt(state.Plane.NormalSquared);
        var corners = new MovingCorners(state, frame, motion, state.Plane.Normal * scale, start, end);
        plane = default;
        plane.Start = start;
        plane.Gap = state.Plane.Value * scale - frame.Margins;
        plane.Step = -1;
        double above = Math.Max(plane.Gap - aim, 0);
        Double3 best = default;
        bool isNewton = corners.Count > 1 && plane.Try(corners, corners.LevelRate(state.Size.Value), above, ref best);
        if (!isNewton) isNewton = plane.Try(corners, default, above, ref best);
        if (!isNewton && motion.A.IsTurning) isNewton = plane.Try(corners, corners.TurnA, above, ref best);
        if (!isNewton && motion.B.IsTurning) plane.Try(corners, corners.TurnB, above, ref best);
        plane.Normal = frame.RotationA.Rotate(corners.Normal);
        plane._turn = frame.RotationA.Rotate(best);
    }

    /// <summary>The gap along the plane at a later fraction.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">The pair at that fraction.</param>
    /// <param name="fraction">The fraction.</param>
    public readonly double GapAt<TA, TB>(ref TA a, ref TB b, in PairFrame frame, double fraction)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Double3 normal = NormalAt(frame, fraction);
        a.Support(-normal, out Double3 onA);
        b.Support(frame.Rotation.InverseRotate(normal), out Double3 onB);
        return Double3.Dot(normal, onA - frame.Rotation.Rotate(onB) - frame.Translation) - frame.Margins;
    }

    /// <summary>The normal at a later fraction, in A's axes.</summary>
    /// <param name="frame">The pair at that fraction.</param>
    /// <param name="fraction">The fraction.</param>
    public readonly Double3 NormalAt(in PairFrame frame, double fraction)
    {
        Double3 world = Normal;
        double rate = _turn.Length;
        if (rate > 0) world = QuaternionD.About(_turn * (1 / rate), rate * (fraction - Start)).Rotate(world);
        return frame.RotationA.InverseRotate(world);
    }

    /// <summary>Whether the gap is proved to stay above a floor from the start to a later fraction.</summary>
    /// <param name="step">How much later.</param>
    /// <param name="gap">The gap there.</param>
    /// <param name="floor">The floor.</param>
    public readonly bool IsProved(double step, double gap, double floor) =>
        gap >= floor
        && step * Math.Sqrt(0.5 * Curvature) <= Math.Sqrt(Math.Max(Gap - floor, 0)) + Math.Sqrt(gap - floor);

    /// <summary>The part of a step up to which it is proved, at least 0 and below 1.</summary>
    /// <inheritdoc cref="IsProved"/>
    public readonly double ProvedPart(double step, double gap, double floor)
    {
        // The first root of above (1 - t) + below t - bend t (1 - t), in the form that does not cancel.
        double above = Math.Max(Gap - floor, 0), bend = 0.5 * Curvature * step * step, b = bend + Gap - gap;
        return 2 * above / (b + Math.Sqrt(Math.Max(b * b - 4 * bend * above, 0)));
    }

    /// <summary>Takes a rate if its step is longer.</summary>
    /// <returns>Whether the step ends where the gap does, so that no other rate is worth a look.</returns>
    private bool Try(in MovingCorners corners, in Double3 turn, double above, ref Double3 best)
    {
        double rate = corners.Rate(turn), curvature = corners.Curvature(turn);
        double bend = Math.Sqrt(0.5 * curvature), root = Math.Sqrt(above);
        bool isNewton = rate < 0 && rate <= -bend * root;
        double step = isNewton ? above / -rate
            : curvature > 0 ? (2 * bend * root + rate) / (bend * bend) : double.PositiveInfinity;
        if (!(step > Step)) return false;
        Step = step;
        Rate = rate;
        Curvature = curvature;
        best = turn;
        return isNewton;
    }
}
