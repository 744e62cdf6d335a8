namespace Gjk.Core;

/// <summary>What is known of the depth.</summary>
internal struct DepthBounds(in Double3 normal, double upper, double lower)
{
    /// <summary>Length, as a fraction of the size: how far apart shapes are moved where a way out ends. A way that is
    /// longer than the shortest by e may end beside their points by the root of 2 e times this. Much less would count
    /// as touching. Pinned by CoaxialDepthTests.</summary>
    private const double Beyond = 1.0 / (1 << 20);

    /// <summary>The direction of the cheapest way out that was seen, of unit length.</summary>
    public Double3 Normal = normal;

    /// <summary>What it costs: the depth is not more.</summary>
    public double Upper = upper;

    /// <summary>The depth is not less.</summary>
    public double Lower = lower;

    /// <summary>Nothing is known.</summary>
    public static DepthBounds None =>
        new(new Double3(1, 0, 0), double.PositiveInfinity, double.NegativeInfinity);

    /// <summary>What a search has left in a state.</summary>
    public static DepthBounds FromState(in SolverState state) =>
        new(-state.Feature.Normal, -state.Plane.Value, -state.Feature.Height);

    /// <summary>Takes note of what a direction costs; the first of equally cheap ones stays.</summary>
    public void TightenUpper(in Double3 normal, double height)
    {
        if (!(height < Upper)) return;
        Upper = height;
        Normal = normal;
    }

    /// <summary>Whether a plane separates the shapes by more than rounding could.</summary>
    public readonly bool IsApart(in SolverState state) =>
        Upper < -GjkTolerances.SeparatedBandOf(state.IsCurved) * state.Size.Value;

    /// <summary>What a search without a surface says that was not ended on the way.</summary>
    public readonly Verdict VerdictOr(in SolverState state, Verdict verdict) =>
        !(Upper <= double.MaxValue) ? Verdict.Contradiction : IsApart(state) ? Verdict.Apart : verdict;

    /// <summary>Writes the bounds as a feature of negative distance: as if a plane at minus the depth separated the
    /// shapes.</summary>
    /// <param name="state">Gets it.</param>
    /// <param name="depth">What to call the depth.</param>
    public readonly void Store(ref SolverState state, double depth)
    {
        state.Feature.Normal = -Normal;
        state.Feature.NormalSquared = 1;
        state.Feature.Height = -depth;
        state.Plane.Set(state.Feature, -Upper);
    }

    /// <summary>Writes the bounds and the points into the state where the direction is known but no face.</summary>
    /// <remarks>Moved out along the way and a little more, B is that little apart from A, and the points where they are
    /// closest are those that touch at the end of the way. So the distance solvers find them.</remarks>
    /// <param name="a">The first shape.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="frame">Where B is, seen from A.</param>
    /// <param name="verdict">How the search ended.</param>
    /// <param name="state">Gets a feature of negative height, and the simplex that holds the points.</param>
    /// <returns>The verdict; Contradiction where the supports contradict themselves now.</returns>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public readonly Verdict StoreWithPoints<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, Verdict verdict, ref SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (verdict == Verdict.Enclosed || verdict == Verdict.Undecided)
        {
            PairFrame apart = frame;
            apart.Translation += Normal * (Upper + Beyond * state.Size.Value);
            state.Simplex.Clear();
            state.Feature.Normal = -Normal;
            NoTrace untold = default;
            GjkDistance.Solve(ref a, ref b, apart, double.PositiveInfinity, ref state, ref untold);
            GjkExtendedPrecision.Settle(ref a, ref b, apart, double.PositiveInfinity, false, ref state, ref untold);
            if (state.Verdict != Verdict.Apart) return Verdict.Contradiction;
            MinkowskiDifference.Retranslate(frame, ref state.Simplex);
        }

        Store(ref state, verdict == Verdict.Undecided ? Math.Max(Lower, 0) : Upper);
        return verdict;
    }
}
