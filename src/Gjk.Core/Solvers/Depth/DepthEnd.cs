namespace Gjk.Core;

/// <summary>Where the way out ends, for a search that knows its direction and its length but has no face.</summary>
/// <remarks>Moved out along the way and a little more, B is that little apart from A, and the points where they are
/// closest are those that touch at the end of the way. So the distance solvers find them.</remarks>
internal static class DepthEnd
{
    /// <summary>Length, as a fraction of the size: how far apart they are then. A way that is longer than the shortest
    /// by e may end beside their points by the root of 2 e times this. Much less would count as touching. Pinned by
    /// CoaxialDepthTests.</summary>
    private const double Beyond = 1.0 / (1 << 20);

    /// <summary>Writes the bounds and the points into the state.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="frame">Where B is, seen from A.</param>
    /// <param name="depth">What was found.</param>
    /// <param name="verdict">How the search ended.</param>
    /// <param name="state">Gets a feature of negative height, and the simplex that holds the points.</param>
    /// <returns>The verdict; Contradiction where the supports contradict themselves now.</returns>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static DepthVerdict Settle<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in DepthBounds depth, DepthVerdict verdict, ref SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (verdict == DepthVerdict.Found || verdict == DepthVerdict.Undecided)
        {
            PairFrame apart = frame;
            apart.Translation += depth.Normal * (depth.Above + Beyond * state.Size.Value);
            state.Simplex.Clear();
            state.Feature.Normal = -depth.Normal;
            NoTrace untold = default;
            ProvedDistance.Solve(ref a, ref b, apart, double.PositiveInfinity, false, ref state, ref untold);
            if (state.Verdict != Verdict.Apart) return DepthVerdict.Contradiction;
            MinkowskiDifference.Move(frame, ref state.Simplex);
        }

        depth.Store(ref state, verdict == DepthVerdict.Undecided ? Math.Max(depth.Below, 0) : depth.Above);
        return verdict;
    }
}
