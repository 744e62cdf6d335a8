namespace Gjk.Core;

/// <summary>What becomes of a contact of two cores that move and turn: it ends, it gets deeper than is allowed, or it
/// lasts. Conservative advancement as in <see cref="AdvancementSolver{TA, TB}"/>, of bodies that are shrunk by what is
/// allowed.</summary>
/// <remarks>
/// <para>Each round asks for the signed distance at the fraction reached. Its plane, moved back by what is allowed,
/// separates the shrunk bodies, and the same chord with its sag proves a step of it. So nothing gets deeper between the
/// rounds, and bodies that slide or roll on each other go on, with the allowed depth for a gap.</para>
/// <para>A signed distance of curved bodies costs hundreds of supports. So after some rounds the plane, as it has
/// turned by then, stands in for the next query: two supports tell the gap along it, and as long as half of the gap
/// that was asked for last is left, the next step is proved from there.</para>
/// <para>A contact ends where the plane proves a gap of twice the tolerance. It is looked for before each step, four
/// times further each time, since a body may leave, turn, and come back with its other end within one step.</para>
/// <para>It terminates as the advancement does: what is allowed is several floors.</para>
/// <para>Verdicts. Hit: the contact gets deeper than is allowed. Over: it ends at the fraction, and the bodies are
/// apart there. Miss: neither, up to the end. Undecided: the steps ran out; up to the fraction it is no deeper.
/// Contradiction: that of the signed distance.</para>
/// </remarks>
internal static class ContactFollower<TA, TB>
    where TA : struct, ISupportMap
    where TB : struct, ISupportMap
{
    /// <summary>Ratio to the tolerance: the gap at which a contact is over. Pinned by TouchingImpactTests.</summary>
    private const double Ended = 2;

    /// <summary>Ratio and count: how much further each look for the end goes, and how many there are; the last goes
    /// 2^62 times as far as the first. Pinned by TouchingImpactTests.</summary>
    private const double Further = 4;

    private const int MaxLooks = 32;

    /// <summary>Ratio to what the search for a depth leaves open: room for it. Pinned by TouchingImpactTests.</summary>
    private const double DepthRoom = 4;

    /// <summary>Count: directions in which the bodies' reach from their axes is measured, so that a wheel can roll in
    /// few steps: the reach is up to 0.1% too large. Pinned by TouchingImpactTests.</summary>
    private const int MeasuredDirections = 64;

    /// <summary>Counts: rounds after which planes are kept, for how many rounds each, and ratio to the gap asked for:
    /// what must be left of it. They change the cost alone. Pinned by TouchingImpactTests.</summary>
    private const int KeepAfter = 2, MostKept = 16;

    private const double LeastKept = 0.5;

    /// <summary>Follows the contact; the frame is that of the fraction reached.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">The pair at the begin.</param>
    /// <param name="motion">How it moves.</param>
    /// <param name="interval">From which fraction to which.</param>
    /// <param name="tolerance">The largest gap of a hit, in solver units.</param>
    /// <param name="allowed">In solver units: how deep they may get, if they are not deeper at the fraction 0
    /// already.</param>
    /// <param name="impact">Gets the end; its steps and iterations are counted on.</param>
    public static void Solve(
        ref TA a, ref TB b, ref PairFrame frame, ref PairMotion motion, in FractionInterval interval, double tolerance,
        double allowed, ref Impact impact)
    {
        double floor = Impact.FloorRatio * tolerance, accepted = Impact.MostAccepted * tolerance;
        double margin = frame.MarginA, shrunk = 0;
        impact.Fraction = interval.Begin;
        motion.A.Measure(ref a, MeasuredDirections);
        motion.B.Measure(ref b, MeasuredDirections);
        TurningPlane plane = default;
        double asked = 0;
        int kept = MostKept;
        while (true)
        {
            if (kept == MostKept || !TryKeep(
                ref a, ref b, frame, plane, impact.Fraction, Math.Max(accepted, LeastKept * asked) - shrunk,
                out SolverState state, out double gap))
            {
                if (!TryMeasure(ref a, ref b, frame, ref impact, out state, out gap)) return;
                if (shrunk == 0)
                {
                    double depth = interval.Begin > 0 ? 0 : -gap;

                    // No depth is above the radii; beside far more than that the gaps would be lost.
                    shrunk = Math.Max(Math.Min(allowed, frame.Radius), depth) + tolerance + accepted
                        + DepthRoom * state.DepthNoise;
                }

                asked = gap + shrunk;
                kept = impact.Steps < KeepAfter ? MostKept - 1 : -1;
            }

            kept++;
            impact.Outcome = gap > 0 ? MotionVerdict.Over : MotionVerdict.Hit;
            if (gap + shrunk <= accepted || gap >= Ended * tolerance) return;
            frame.MarginA = margin - shrunk;
            TurningPlane.Choose(state, frame, motion, impact.Fraction, interval.End, 0.5 * accepted, out plane);
            double next;
            bool isOver = TryEnd(
                ref a, ref b, ref frame, motion, plane, interval.End, shrunk + Ended * tolerance, floor, out next);
            if (!isOver && !AdvancementSolver<TA, TB>.TrySweep(
                ref a, ref b, ref frame, motion, plane, interval.End, floor, true, out next))
            {
                next = AdvancementSolver<TA, TB>.Advance(ref a, ref b, ref frame, motion, plane, interval.End, floor);
            }

            frame.MarginA = margin;
            bool goesOn = impact.TryGoTo(next, interval.End);
            if (isOver && impact.Outcome != MotionVerdict.Miss) impact.Outcome = MotionVerdict.Over;
            if (isOver || !goesOn) return;
        }
    }

    /// <summary>Looks for a proved gap; the frame is moved there, or left as it was.</summary>
    private static bool TryEnd(
        ref TA a, ref TB b, ref PairFrame frame, in PairMotion motion, in TurningPlane plane, double end,
        double outside, double floor, out double next)
    {
        PairFrame here = frame;
        next = plane.Start;
        double step = (outside - plane.Gap) / motion.Speed;
        for (int look = 0; look < MaxLooks && next < end; look++, step *= Further)
        {
            next = Math.Min(plane.Start + step, end);
            motion.MoveTo(next, ref frame);
            double gap = plane.GapAt(ref a, ref b, frame, next);
            if (!plane.IsProved(next - plane.Start, gap, floor)) break;
            if (gap >= outside) return true;
        }

        frame = here;
        return false;
    }

    /// <summary>The gap along the last plane, as it has turned, in place of a signed distance.</summary>
    /// <returns>False where it is no more than the least.</returns>
    private static bool TryKeep(
        ref TA a, ref TB b, in PairFrame frame, in TurningPlane plane, double fraction, double least,
        out SolverState state, out double gap)
    {
        SolverState.Make<TA, TB>(frame, out state);
        state.Feature.Normal = plane.NormalAt(frame, fraction);
        state.Feature.NormalSquared = state.Feature.Normal.LengthSquared;
        MinkowskiDifference.Support(ref a, ref b, frame, state.Feature.Normal, ref state.Simplex.At(0), out Double3 w);
        state.Simplex.Select(1, 0, 0, 0, 0);
        state.Plane.Set(state.Feature, Double3.Dot(state.Feature.Normal, w));
        gap = state.Plane.Value / Math.Sqrt(state.Plane.NormalSquared) - frame.Margins;
        return gap > least;
    }

    /// <summary>The signed distance where the pair is now, and the plane that bounds it from below.</summary>
    private static bool TryMeasure(
        ref TA a, ref TB b, in PairFrame frame, ref Impact impact, out SolverState state, out double gap)
    {
        SolverState.Make<TA, TB>(frame, out state);
        WarmStart unused = default;
        NoPolytopeTrace trace = default;
        if (frame.ArePoints) GjkDistance.SolvePoints(frame, ref state, isSigned: true);
        else SignedSolver<TA, TB, NoPolytopeTrace>.Solve(ref a, ref b, frame, ref unused, false, ref state, ref trace);
        impact.Iterations += state.Iterations;
        impact.Steps++;
        impact.Outcome = (MotionVerdict)state.Verdict;
        gap = 0;
        if (state.Verdict == Verdict.Contradiction) return false;
        gap = state.Plane.Value / Math.Sqrt(state.Plane.NormalSquared) - frame.Margins;
        return true;
    }
}
