namespace Gjk.Core;

/// <summary>The corners of a pair's nearest feature and how they move, in A's axes at one fraction: what the rates of a
/// <see cref="TurningPlane"/> are chosen by.</summary>
/// <remarks>Seen from a plane with the normal n that turns at u, the corner a - b of the difference nears or leaves it
/// by (wA - u) · (a × n) - (wB - u) · (b × n) - n · d' + u · (d × n), with a and b from the pivots and d from pivot to
/// pivot.</remarks>
internal readonly struct MovingCorners
{
    /// <summary>Ratio to the pair's size: corners of a feature that are nearer to each other say nothing of how it
    /// turns. Four times more or less is as good: it only chooses a plane, and a step is proved along whatever plane it
    /// takes.</summary>
    private const double LeastEdge = 1e-5;

    /// <summary>Ratio: edges whose sine is smaller are parallel, and one of them is kept level. Four times more or less
    /// is as good, as above.</summary>
    private const double LeastSine = 1e-6;

    /// <summary>From B to A, of unit length.</summary>
    public readonly Double3 Normal;

    /// <summary>The bodies' rates.</summary>
    public readonly Double3 TurnA, TurnB;

    /// <summary>How many corners the feature has: 1 to 3.</summary>
    public readonly int Count;

    private readonly Double3 _velocity, _between, _betweenAtEnd;
    private readonly Double3 _a0, _a1, _a2, _b0, _b1, _b2;
    private readonly double _reachA, _reachB, _reachAcrossA, _reachAcrossB, _span;

    public MovingCorners(
        in SolverState state, in PairFrame frame, in PairMotion motion, in Double3 normal, double start, double end)
        : this()
    {
        Normal = normal;
        TurnA = frame.RotationA.InverseRotate(motion.A.AngularVelocity);
        TurnB = frame.RotationA.InverseRotate(motion.B.AngularVelocity);
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

    /// <summary>How the gap along a plane that turns at a rate changes at first: by the corner that nears
    /// most.</summary>
    public double Rate(in Double3 turn)
    {
        Double3 a = TurnA - turn, b = TurnB - turn;
        double least = Double3.Dot(a, _a0) - Double3.Dot(b, _b0);
        if (Count > 1) least = Math.Min(least, Double3.Dot(a, _a1) - Double3.Dot(b, _b1));
        if (Count > 2) least = Math.Min(least, Double3.Dot(a, _a2) - Double3.Dot(b, _b2));
        return least - Double3.Dot(Normal, _velocity) + Double3.Dot(turn, Double3.Cross(_between, Normal));
    }

    /// <summary>Upper bound of the second derivative of the gap between any two points along a plane that turns at a
    /// rate.</summary>
    public double Curvature(in Double3 turn)
    {
        double rate = turn.Length;
        if (rate == 0)
        {
            return TurnA.Length * Double3.Cross(TurnA, Normal).Length * _reachAcrossA
                + TurnB.Length * Double3.Cross(TurnB, Normal).Length * _reachAcrossB;
        }

        // The way between the pivots is straight, so it is furthest from the axis at one of its ends.
        double across = Math.Max(
            Double3.Cross(turn, _between).LengthSquared, Double3.Cross(turn, _betweenAtEnd).LengthSquared);
        return rate * Math.Sqrt(across) + 2 * Double3.Cross(turn, _velocity).Length
            + OfBody(TurnA, turn) * _reachA + OfBody(TurnB, turn) * _reachB;
    }

    /// <summary>The rate at which a plane stays level with the feature's corners: each edge e asks for u · (e × n) = wA
    /// · (eA × n) - wB · (eB × n).</summary>
    /// <param name="size">The pair's.</param>
    /// <returns>The shortest one; 0 where the corners do not ask for any.</returns>
    public Double3 LevelRate(double size)
    {
        Double3 a = _a1 - _a0, b = _b1 - _b0, first = a - b;
        double rate = Double3.Dot(TurnA, a) - Double3.Dot(TurnB, b), least = LeastEdge * size;
        Double3 level = default;
        double firstSquared = first.LengthSquared;
        if (firstSquared > least * least) level = first * (rate / firstSquared);
        if (Count == 3)
        {
            a = _a2 - _a0;
            b = _b2 - _b0;
            Double3 second = a - b;
            double other = Double3.Dot(TurnA, a) - Double3.Dot(TurnB, b), secondSquared = second.LengthSquared;
            double area = Double3.Dot(Normal, Double3.Cross(first, second));
            if (secondSquared > least * least && secondSquared > firstSquared) level = second * (other / secondSquared);
            if (Math.Min(firstSquared, secondSquared) > least * least
                && area * area > LeastSine * LeastSine * firstSquared * secondSquared)
            {
                level = (Double3.Cross(second, Normal) * rate + Double3.Cross(Normal, first) * other) * (1 / area);
            }
        }

        return level.Length * _span <= SineCosine.MaxAngle ? level : default;
    }

    private static double OfBody(in Double3 own, in Double3 turn) =>
        (own - turn).LengthSquared + Double3.Cross(own, turn).Length;

    private void Set(
        in Simplex simplex, int slot, in PairFrame frame, in PairMotion motion, out Double3 a, out Double3 b)
    {
        a = Double3.Cross(simplex.OnA(slot) + motion.A.Offset, Normal);
        b = Double3.Cross(frame.Rotation.Rotate(simplex.OnB(slot) + motion.B.Offset), Normal);
    }
}
