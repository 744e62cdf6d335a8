namespace Gjk.Core;

/// <summary>How deep two hulls overlap, by the facets of their Minkowski difference (Gottschalk, Lin and Manocha 1996):
/// the shortest way out is across a facet of A, a facet of B, or an edge of each.</summary>
/// <remarks>
/// <para>For hulls that have outgrown the general search (<see cref="GjkDepth"/>): nearly round ones about one centre,
/// where all ways out are nearly equally long. Nothing is built. A facet's way out costs its height and the other
/// hull's extent against it, one support. An edge of A is across all directions of an arc, from the normal of the facet
/// on its one side to that on its other side, and <see cref="HullArc"/> walks it.</para>
/// <para>Most facets need no support: with a ball in the other hull, no way near a facet is shorter than the facet's
/// height and that ball's radius. Along an arc the height is no less than at one of its ends; so an arc is walked from
/// its lower end only, until what is left of it has two high ends.</para>
/// <para>The poles of a sphere from sine and cosine are copies 1e-17 apart, and facets between them have no normal but
/// rounding. Facets so thin that the depth is the same without them are left out, and so are corners on the line of an
/// edge, which is walked from both sides then.</para>
/// <para>It terminates because looks are counted. Verdicts: Found when every facet and arc was proved to be no cheaper
/// than the cheapest way out, which a support of both hulls has confirmed; Apart as those of the general search;
/// Undecided when the looks are spent, or rounding has led a walk astray.</para>
/// </remarks>
internal static class HullDepth
{
    /// <summary>Count: triangles of both hulls; reading those of two spheres of 4,096 corners takes a fifth of a
    /// millisecond.</summary>
    private const int MostTriangles = 1 << 14;

    /// <summary>Count: facets and changes along arcs that may be looked at; three milliseconds. Pinned by
    /// HullDepthTests.</summary>
    private const int MostLooks = 1 << 14;

    /// <summary>Ratio: the part of B's facets that tells how many looks all of them will take.</summary>
    private const int Sample = 8;

    /// <summary>Finds the depth from what the general search has left in the state.</summary>
    public static DepthVerdict Solve<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in PairForm form, ref SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (!form.AreFaceted || form.A.TriangleCount + form.B.TriangleCount > MostTriangles)
            return DepthVerdict.Undecided;
        var search = new FacetSearch(form, state, MostLooks);
        bool isProved = TryFacetsOfB(ref a, ref b, frame, form, ref search)
            && TryFacetsOfA(ref a, ref b, frame, form, ref search);
        state.Iterations += search.Supports;
        search.Depth.Below = Math.Max(
            search.Depth.Below, search.InnerA + search.InnerB - frame.Translation.Length);
        DepthVerdict verdict = search.Depth.IsApart(state) ? DepthVerdict.Apart
            : isProved ? DepthVerdict.Found : DepthVerdict.Undecided;
        return DepthEnd.Settle(ref a, ref b, frame, search.Depth, verdict, ref state);
    }

    private static bool TryFacetsOfB<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in PairForm form, ref FacetSearch search)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Double3 offset = frame.Rotation.InverseRotate(frame.Translation);
        int count = form.B.TriangleCount, lines = 0;
        for (int i = 0; i < count; i++)
        {
            // Not worth to begin: the looks will not do for all of B's facets and as many at A's.
            if (i == count / Sample && search.Supports * Sample * 2 > MostLooks * 5 / 8) return false;
            HullFacet.Get(ref b, form.B, i, out HullFacet facet);
            if (facet.HasNoArea)
            {
                lines++;
                continue;
            }

            if (facet.IsAbove(-offset, search.Limit - search.InnerA)) continue;
            Double3 outward = facet.Normal * (1 / facet.Normal.Length), normal = frame.Rotation.Rotate(-outward);
            a.Support(normal, out Double3 onA);
            double height = Double3.Dot(normal, onA) + Double3.Dot(outward, facet.P + offset);
            if (!search.TryLook(ref a, ref b, frame, normal, height)) return false;
        }

        return IsLeft(count, lines);
    }

    private static bool TryFacetsOfA<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in PairForm form, ref FacetSearch search)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        int count = form.A.TriangleCount, lines = 0;
        for (int i = 0; i < count; i++)
        {
            HullFacet.Get(ref a, form.A, i, out HullFacet facet);
            if (facet.HasNoArea)
            {
                lines++;
                continue;
            }

            if (facet.IsAbove(frame.Translation, search.Limit - search.InnerB)) continue;
            Double3 normal = facet.Normal * (1 / facet.Normal.Length), inB = frame.Rotation.InverseRotate(normal);
            int id = b.Support(-inB, out Double3 onB);
            double height = Double3.Dot(normal, facet.P - frame.Translation) - Double3.Dot(inB, onB);
            if (!search.TryLook(ref a, ref b, frame, normal, height)) return false;
            if (form.B.Hull is null) continue;
            for (int k = 0; k < 3; k++, facet.Turn())
            {
                var arc = new HullArc(facet, normal, frame, id);
                if (!arc.TryWalk(facet, ref a, ref b, frame, form, ref search)) return false;
            }
        }

        return IsLeft(count, lines);
    }

    /// <summary>Whether facets are left; a hull whose facets are all lines is none without them.</summary>
    private static bool IsLeft(int count, int lines) => lines < count || count == 0;
}
