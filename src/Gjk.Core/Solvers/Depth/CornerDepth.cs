namespace Gjk.Core;

/// <summary>How deep a round body and a body with corners overlap, by the ways out across each corner, edge and facet:
/// the separating axes of Gottschalk, Lin and Manocha (1996) for a pair of which only one has facets.</summary>
/// <remarks>
/// <para>Where a corner lies on the axis of a round body, or in the middle of a ball, many ways out are equally long or
/// nearly so, and the general search (<c>GjkDepth</c>) needs a face for each part of them. But they differ in
/// little. In the shortest way out one corner alone is furthest, or the two ends of an edge, or those of a facet. Where
/// it is a corner, the way is one of that point out of the round body, and points around have none that is shorter: so
/// it lies in the plane of the point and the axis, or is one of two normals of an ellipsoid. Where it is an edge, the
/// way is across it: on a circle of directions, or again one of two, since along the edge an ellipsoid looks like an
/// ellipse and the edge like a point. A circle is searched in two halves, each like that of a pin in its hole
/// (<c>AxialDepth</c>), and holds the directions across the facets beside the edge.</para>
/// <para>All of a circle is searched, and of a point all of its ways. What is not its own is a way out as well, only a
/// longer one than need be. So it does no harm that corners without an edge between them may be taken for its
/// ends.</para>
/// <para>It terminates because there are so many corners and neighbours only, and a half circle has its own end.
/// Verdicts: Enclosed when all was seen; Apart and Contradiction as those of the general search; Undecided, as before,
/// when there are too many corners, the supports are spent, or an ellipsoid is flat.</para>
/// </remarks>
internal static class CornerDepth<TA, TB>
    where TA : struct, ISupportMap
    where TB : struct, ISupportMap
{
    /// <summary>Count: corners at most about an ellipsoid; a quarter of them where circles are searched. More would
    /// take longer than <c>DepthCells</c>. Pinned by CornerDepthTests; four times more only takes
    /// longer.</summary>
    private const int MostCorners = 256;

    /// <summary>Count: a circle that takes more supports, as that across the sides of a prism about a pin, is searched
    /// once. Only time depends on it.</summary>
    private const int Dear = 64;

    /// <summary>Finds the depth from what the general search has left in the state.</summary>
    public static Verdict Solve(ref TA a, ref TB b, in PairFrame frame, in PairForm form, ref SolverState state)
    {
        int count = form.A.CornerCount + form.B.CornerCount, most = MostCorners / (form.HasEllipsoid ? 1 : 4);
        if (!form.AreRoundAndCornered || count > most) return Verdict.Undecided;
        int before = state.Iterations;
        var depth = DepthBounds.FromState(state);
        int limit = before + AxialDepth<TA, TB>.MostSupports;
        Double3 dear = default;
        var verdict = Verdict.Enclosed;
        for (int i = 0; i < count && verdict == Verdict.Enclosed; i++)
            verdict = SearchCorner(ref a, ref b, frame, form, i, limit, ref state, ref depth, ref dear);
        if (depth.IsApart(state)) verdict = Verdict.Apart;
        if (verdict == Verdict.Undecided) state.Iterations = before;
        else verdict = depth.StoreWithPoints(ref a, ref b, frame, verdict, ref state);
        return verdict;
    }

    /// <summary>All ways around a corner, those across an edge or a facet at the last of its corners, and not across an
    /// edge along a dear one: the circle is the same.</summary>
    private static Verdict SearchCorner(
        ref TA a, ref TB b, in PairFrame frame, in PairForm form, int id, int limit, ref SolverState state,
        ref DepthBounds depth, ref Double3 dear)
    {
        ref readonly BodyForm body = ref (form.A.CornerCount > 0 ? ref form.A : ref form.B);
        Double3 corner = Offset(ref a, ref b, frame, form, id);
        Verdict verdict = ProbeAcross(ref a, ref b, frame, form, corner, default, limit, ref state, ref depth);
        if (body.IsBox && id < body.CornerCount - 1 && !form.HasEllipsoid) return verdict;
        for (int i = 0; i < body.NeighborCount(id) && body.Neighbor(id, i) < id; i++)
        {
            Double3 edge = Offset(ref a, ref b, frame, form, body.Neighbor(id, i)) - corner;
            if (!(edge.LengthSquared > 0)) continue;
            if (verdict != Verdict.Enclosed) return verdict;
            edge *= 1 / edge.Length;
            double same = Double3.Dot(edge, dear);
            if (same * same >= 1 - PairForm.Parallel * PairForm.Parallel) continue;
            int before = state.Iterations;
            verdict = ProbeAcross(ref a, ref b, frame, form, corner, edge, limit, ref state, ref depth);
            if (state.Iterations - before > Dear) dear = edge;
            for (int k = 0; k < i && form.HasEllipsoid; k++)
            {
                Double3 other = Offset(ref a, ref b, frame, form, body.Neighbor(id, k)) - corner;
                Double3 normal = Double3.Cross(edge, other);
                if (!(normal.LengthSquared > 0)) continue;
                normal *= 1 / normal.Length;
                AxialDepth<TA, TB>.Probe(ref a, ref b, frame, WayOut.In(normal), limit, ref state, ref depth);
                AxialDepth<TA, TB>.Probe(ref a, ref b, frame, WayOut.In(-normal), limit, ref state, ref depth);
            }
        }

        return verdict;
    }

    /// <summary>The ways across a corner or an edge.</summary>
    private static Verdict ProbeAcross(
        ref TA a, ref TB b, in PairFrame frame, in PairForm form, in Double3 corner, in Double3 edge, int limit,
        ref SolverState state, ref DepthBounds depth)
    {
        WayOut way = form.WayAcross(frame, corner, edge, false), other = form.WayAcross(frame, corner, edge, true);
        if (!way.IsKnown) return Verdict.Undecided;
        Verdict verdict = AxialDepth<TA, TB>.Probe(ref a, ref b, frame, way, limit, ref state, ref depth);
        return verdict == Verdict.Enclosed
            ? AxialDepth<TA, TB>.Probe(ref a, ref b, frame, other, limit, ref state, ref depth)
            : verdict;
    }

    /// <summary>From A's centre to a corner of B, or from a corner of A to B's centre.</summary>
    private static Double3 Offset(ref TA a, ref TB b, in PairFrame frame, in PairForm form, int id)
    {
        bool isOfA = form.A.CornerCount > 0;
        Double3 corner;
        if (isOfA) a.TryGetVertex(id, out corner);
        else b.TryGetVertex(id, out corner);
        return frame.Translation + (isOfA ? -corner : frame.Rotation.Rotate(corner));
    }
}
