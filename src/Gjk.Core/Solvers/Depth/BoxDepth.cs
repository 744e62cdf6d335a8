namespace Gjk.Core;

/// <summary>How deep two boxes overlap, by separating axes (Gottschalk, Lin and Manocha 1996): the shortest way out is
/// across a face of A, across a face of B, or across an edge of each.</summary>
/// <remarks>
/// <para>The Minkowski difference of two boxes has no other facets, so the least of 15 costs is the depth; nothing is
/// walked. A cost is what is left of both extents along an axis when the centres' distance along it is taken away. It
/// is computed from the axis as it is, with no use of what its products should be: so an axis that rounding has turned
/// still is a way out that costs what is computed, and nearly parallel edges need no tolerance. Only edges that are
/// parallel to the last bit have no axis.</para>
/// <para>Two things differ from the source. Edges are compared without a root: the square of the cost, with its sign,
/// and the squared length of the axis. And faces come first: an edge pair is taken only where it is cheaper by more
/// than rounding, so that a resting box keeps its face. Of equal faces the first is taken, A's before B's, x before y
/// before z; where the centres are level along an axis, its positive direction.</para>
/// <para>Verdicts: Enclosed, or Apart when an axis separates the boxes by more than rounding could.</para>
/// </remarks>
internal static unsafe class BoxDepth
{
    /// <summary>Finds the depth; the state gets the deepest points as a simplex of one vertex without ids.</summary>
    /// <param name="halfA">Half of A's sides.</param>
    /// <param name="halfB">Half of B's sides.</param>
    /// <param name="frame">Of the pair.</param>
    /// <param name="state">With the size.</param>
    public static DepthVerdict Solve(
        in Double3 halfA, in Double3 halfB, in PairFrame frame, ref SolverState state)
    {
        double* costs = stackalloc double[BoxAxes.Lanes], squares = stackalloc double[BoxAxes.Lanes];
        BoxAxes.Find(halfA, halfB, frame, costs, squares);
        double noise = GjkTolerances.Noise * state.Size.Value, scale = 1;
        int best = BoxAxes.LeastFace(costs, noise);
        double above = costs[best];
        int below = BoxAxes.EdgesBelow(costs, squares, above - noise);
        for (int i = BoxAxes.Edges; below >> i != 0; i++)
        {
            double limit = above - noise;
            if ((below >> i & 1) == 0 || !BoxAxes.IsBelow(costs[i], squares[i], limit * Math.Abs(limit))) continue;
            scale = 1 / Math.Sqrt(squares[i]);
            above = costs[i] * scale;
            best = i;
        }

        var pair = new BoxPair(halfA, halfB, frame, BoxAxes.AxisOf(best));
        DepthBounds depth = default;
        depth.Settle(pair.Outward * scale, above);
        depth.Store(ref state, above);
        if (depth.IsApart(state)) return DepthVerdict.Apart;
        BoxDepthPoints.Find(pair, depth, state.Size.Value, out Double3 onA, out Double3 inB);
        state.Simplex.Fill(0, depth.Normal * above, onA, inB, -1, -1);
        state.Simplex.Select(1, 0, 0, 0, 0);
        return DepthVerdict.Found;
    }
}
