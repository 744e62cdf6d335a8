using System;

namespace Gjk.Core;

/// <summary>
/// The corners of a pair's nearest feature and how they move, in A's axes at one fraction: what the rates of a
/// <see cref="TurningPlane"/> are chosen by.
/// </summary>
/// <remarks>
/// Seen from a plane with the normal n that turns at u, the corner a - b of the difference nears or leaves it by
/// (wA - u) · (a × n) - (wB - u) · (b × n) - n · d' + u · (d × n), with a and b from the pivots and d from pivot to
/// pivot.
/// </remarks>
internal readonly struct MovingCorners
{
    /// <summary>
    /// Ratio to the pair's size: corners of a feature that are nearer to each other say nothing of how it turns. Four
    /// times more or less is as good: it only chooses a plane, and a step is proved along whatever plane it takes.
    /// </summary>
    private const double LeastEdge = 1e-5;

    /// <summary>
    /// Ratio: edges whose sine is smaller are parallel, and one of them is kept level. Four times more or less is as
    /// good, as above.
    /// </summary>
    private const double LeastSine = 1e-6;

    /// <summary>From B to A, of unit length.</summary>
    public readonly Vector3D Normal;

    /// <summary>The bodies' rates.</summary>
    public readonly Vector3D TurnA, TurnB;

    /// <summary>How many corners the feature has: 1 to 3.</summary>
    public readonly int Count;

    private readonly Vector3D _velocity, _between, _betweenAtEnd;
    private readonly Vector3D _a0, _a1, _a2, _b0, _b1, _b2;
    private readonly double _reachA, _reachB, _reachAcrossA, _reachAcrossB, _span;

    public MovingCorners(
        in SolverState state, in PairFrame frame, in PairMotion motion, in Vector3D normal, double start, double end)
        : this()
    {
        Normal = normal;
        TurnA = frame.RotationA.InverseRotate(motion.A.Turn);
        TurnB = frame.RotationA.InverseRotate(motion.B.Turn);
        _velocity = frame.RotationA.InverseRotate(motion.Velocity);
        _between = frame.RotationA.InverseRotate(motion.Between(start));
        _betweenAtEnd = _between + _velocity * (end - start);
        (_reachA, _reachAcrossA) = (motion.A.Reach, motion.A.ReachAcross);
        (_reachB, _reachAcrossB) = (motion.B.Reach, motion.B.ReachAcross);
        _span = end - start;
        Count = Math.Min(state.Simplex.Count, 3);
        Set(state.Simplex, state.Simplex.A, frame, motion, out _a0, out _b0);
        if (Count > 1) Set(state.Simplex, state.Simplex.B, frame, motion, out _a1, out _b1);
        if (Count > 2) Set(state.Simplex, state.Simplex.C, frame, motion, out _a2, out _b2);
    }

    /// <summary>
    /// How the gap along a plane that turns at a rate changes at first: by the corner that nears most.
    /// </summary>
    public double Rate(in Vector3D turn)
    {
        Vector3D a = TurnA - turn, b = TurnB - turn;
        double least = Vector3D.Dot(a, _a0) - Vector3D.Dot(b, _b0);
        if (Count > 1) least = Math.Min(least, Vector3D.Dot(a, _a1) - Vector3D.Dot(b, _b1));
        if (Count > 2) least = Math.Min(least, Vector3D.Dot(a, _a2) - Vector3D.Dot(b, _b2));
        return least - Vector3D.Dot(Normal, _velocity) + Vector3D.Dot(turn, Vector3D.Cross(_between, Normal));
    }

    /// <summary>
    /// Upper bound of the second derivative of the gap between any two points along a plane that turns at a rate.
    /// </summary>
    public double Curvature(in Vector3D turn)
    {
        double rate = turn.Length;
        if (rate == 0)
        {
            return TurnA.Length * Vector3D.Cross(TurnA, Normal).Length * _reachAcrossA
                + TurnB.Length * Vector3D.Cross(TurnB, Normal).Length * _reachAcrossB;
        }

        // The way between the pivots is straight, so it is furthest from the axis at one of its ends.
        double across = Math.Max(
            Vector3D.Cross(turn, _between).LengthSquared, Vector3D.Cross(turn, _betweenAtEnd).LengthSquared);
        return rate * Math.Sqrt(across) + 2 * Vector3D.Cross(turn, _velocity).Length
            + OfBody(TurnA, turn) * _reachA + OfBody(TurnB, turn) * _reachB;
    }

    /// <summary>
    /// The rate at which a plane stays level with the feature's corners: each edge e asks for u · (e × n) = wA · (eA ×
    /// n) - wB · (eB × n).
    /// </summary>
    /// <param name="size">The pair's.</param>
    /// <returns>The shortest one; 0 where the corners do not ask for any.</returns>
    public Vector3D Level(double size)
    {
        Vector3D a = _a1 - _a0, b = _b1 - _b0, first = a - b;
        double rate = Vector3D.Dot(TurnA, a) - Vector3D.Dot(TurnB, b), least = LeastEdge * size;
        Vector3D level = default;
        double firstSquared = first.LengthSquared;
        if (firstSquared > least * least) level = first * (rate / firstSquared);
        if (Count == 3)
        {
            a = _a2 - _a0;
            b = _b2 - _b0;
            Vector3D second = a - b;
            double other = Vector3D.Dot(TurnA, a) - Vector3D.Dot(TurnB, b), secondSquared = second.LengthSquared;
            double area = Vector3D.Dot(Normal, Vector3D.Cross(first, second));
            if (secondSquared > least * least && secondSquared > firstSquared) level = second * (other / secondSquared);
            if (Math.Min(firstSquared, secondSquared) > least * least
                && area * area > LeastSine * LeastSine * firstSquared * secondSquared)
            {
                level = (Vector3D.Cross(second, Normal) * rate + Vector3D.Cross(Normal, first) * other) * (1 / area);
            }
        }

        return level.Length * _span <= SineCosine.MaxAngle ? level : default;
    }

    private static double OfBody(in Vector3D own, in Vector3D turn) =>
        (own - turn).LengthSquared + Vector3D.Cross(own, turn).Length;

    private void Set(
        in Simplex simplex, int slot, in PairFrame frame, in PairMotion motion, out Vector3D a, out Vector3D b)
    {
        a = Vector3D.Cross(simplex.OnA(slot) + motion.A.Offset, Normal);
        b = Vector3D.Cross(frame.Rotation.Rotate(simplex.OnB(slot) + motion.B.Offset), Normal);
    }
}
