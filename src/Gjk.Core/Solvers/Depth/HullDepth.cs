namespace Gjk.Core;

/// <summary>How deep two hulls overlap, by the facets of their Minkowski difference (Gottschalk, Lin and Manocha 1996):
/// the shortest way out is across a facet of A, a facet of B, or an edge of each.</summary>
/// <remarks>
/// <para>For hulls that have outgrown the general search (<c>GjkDepth</c>): nearly round ones about one centre,
/// where all ways out are nearly equally long. Nothing is built. A facet's way out costs its height and the other
/// hull's extent against it, one support. An edge of A is across all directions of an arc, from the normal of the facet
/// on its one side to that on its other side, and <see cref="HullArc"/> walks it.</para>
/// <para>Most facets need no support: with a ball in the other hull, no way near a facet is shorter than the facet's
/// height and that ball's radius. Along an arc the height is no less than at one of its ends; so an arc is walked from
/// its lower end only, until what is left of it has two high ends.</para>
/// <para>The poles of a sphere from sine and cosine are copies 1e-17 apart, and facets between them have no normal but
/// rounding. Facets so thin that the depth is the same without them are left out, and so are corners on the line of an
/// edge, which is walked from both sides then.</para>
/// <para>It terminates because probes are counted. Verdicts: Enclosed when every facet and arc was proved to be no
/// cheaper than the cheapest way out, which a support of both hulls has confirmed; Apart as those of the general
/// search; Undecided when the probes are spent, or rounding has led a walk astray.</para>
/// </remarks>
internal static class HullDepth<TA, TB>
    where TA : struct, ISupportMap
    where TB : struct, ISupportMap
{
    /// <summary>Count: triangles of both hulls; reading those of two spheres of 4,096 corners takes a fifth of a
    /// millisecond.</summary>
    private const int MostTriangles = 1 << 14;

    /// <summary>Count: probes, one for each facet and for each change along an arc; all of them take three
    /// milliseconds. Pinned by HullDepthTests.</summary>
    private const int MostProbes = 1 << 14;

    /// <summary>Ratio: after one facet of B in so many it is judged how many probes all of them will take.</summary>
    private const int Sample = 8;

    /// <summary>Finds the depth from what the general search has left in the state.</summary>
    public static Verdict Solve(ref TA a, ref TB b, in PairFrame frame, in PairForm form, ref SolverState state)
    {
        if (!form.AreFaceted || form.A.TriangleCount + form.B.TriangleCount > MostTriangles)
            return Verdict.Undecided;
        var search = new FacetSearch(form, state, MostProbes);
        bool isProved = TryFacetsOfB(ref a, ref b, frame, form, ref search)
            && TryFacetsOfA(ref a, ref b, frame, form, ref search);
        state.Iterations += search.Supports;
        search.Depth.Lower = Math.Max(search.Depth.Lower, search.InnerA + search.InnerB - frame.Translation.Length);
        Verdict verdict = search.Depth.IsApart(state) ? Verdict.Apart
            : isProved ? Verdict.Enclosed : Verdict.Undecided;
        return search.Depth.StoreWithPoints(ref a, ref b, frame, verdict, ref state);
    }

    private static bool TryFacetsOfB(ref TA a, ref TB b, in PairFrame frame, in PairForm form, ref FacetSearch search)
    {
        Double3 offset = frame.Rotation.InverseRotate(frame.Translation);
        int count = form.B.TriangleCount, lines = 0;
        for (int i = 0; i < count; i++)
        {
            // Not worth going on: the probes will not do for all of B's facets and as many of A's.
            if (i == count / Sample && search.Supports * Sample * 2 > MostProbes * 5 / 8) return false;
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
            if (!search.TryProbe(ref a, ref b, frame, normal, height)) return false;
        }

        return IsLeft(count, lines);
    }

    private static bool TryFacetsOfA(ref TA a, ref TB b, in PairFrame frame, in PairForm form, ref FacetSearch search)
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
            if (!search.TryProbe(ref a, ref b, frame, normal, height)) return false;
            if (form.B.Hull is null) continue;
            for (int k = 0; k < 3; k++, facet.NextEdge())
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

/// <summary>What a search over facets knows, and how much it may still do.</summary>
internal struct FacetSearch(in PairForm form, in SolverState state, int mostProbes)
{
    /// <summary>The cheapest way out.</summary>
    public DepthBounds Depth = DepthBounds.FromState(state);

    /// <summary>Supports asked.</summary>
    public int Supports = 0;

    /// <summary>Balls of these radii about their centres are inside the shapes.</summary>
    public readonly double InnerA = form.A.InnerRadius, InnerB = form.B.InnerRadius;

    /// <summary>Length: what rounding does to a height.</summary>
    public readonly double Noise = state.DepthNoise;

    private int _probesLeft = mostProbes;

    /// <summary>Whether no probe is left.</summary>
    public readonly bool AreSpent => _probesLeft < 0;

    /// <summary>A facet as high as this is no cheaper than the cheapest way out, but for rounding.</summary>
    public readonly double Limit => Depth.Upper - Noise;

    /// <summary>Counts a direction whose way out costs at least a height. Where that would be the cheapest, supports of
    /// both shapes say what it does cost.</summary>
    /// <returns>False when the probes are spent, or the supports do not agree.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool TryProbe<TA, TB>(ref TA a, ref TB b, in PairFrame frame, in Double3 normal, double height)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (--_probesLeft < 0) return false;
        Supports++;
        if (height >= Depth.Upper) return true;
        Double3 unit = normal * (1 / normal.Length);
        MinkowskiDifference.Support(ref a, ref b, frame, -unit, out Double3 w);
        Depth.TightenUpper(unit, Double3.Dot(unit, w));
        return height >= Limit;
    }
}

/// <summary>A triangle of a hull, as a shape scales it: wound so that its normal points outward.</summary>
internal struct HullFacet
{
    /// <summary>Squared sine of the angle between two edges: a thinner triangle's normal is computed in 106 bits. Above
    /// it, double turns a normal by less than 1e-13, and a height by less than that times the size. Four times more or
    /// less only moves triangles from one to the other.</summary>
    private const double Thin = 1e-4;

    /// <summary>Ratio to a height: more than rounding does to it. A facet that clears a height by less is probed in
    /// vain.</summary>
    public const double Slack = 1e-11;

    /// <summary>Squared ratio of lengths: a triangle that is thinner than that part of its distance from the shape's
    /// centre is none. Its normal is the rounding of its corners, 1e-16, and may point anywhere; without it the depth
    /// changes by no more. Four times more or less only moves triangles between the two. Pinned by
    /// HullDepthTests.</summary>
    private const double Line = 1e-24;

    /// <summary>The corners, measured from the shape's centre.</summary>
    public Double3 P, Q, R;

    /// <summary>Outward, of any length.</summary>
    public Double3 Normal;

    /// <summary>The corners' ids.</summary>
    public int IdP, IdQ, IdR;

    /// <summary>Whether its corners are on a line, but for rounding.</summary>
    public readonly bool HasNoArea =>
        !(Normal.LengthSquared > LineSquared * Math.Max((Q - P).LengthSquared, (R - P).LengthSquared));

    /// <summary>A square of a length: of what a corner's distance from a line has to be more than.</summary>
    public readonly double LineSquared => Line * Math.Max(P.LengthSquared, (Q - P).LengthSquared);

    /// <summary>Reads a triangle of a shape that is a hull.</summary>
    public static void Get<T>(ref T shape, in BodyForm form, int index, out HullFacet facet)
        where T : struct, ISupportMap
    {
        int[] triangles = form.Hull!.Triangles;
        facet.IdP = triangles[3 * index];
        facet.IdQ = triangles[3 * index + (form.IsMirrored ? 2 : 1)];
        facet.IdR = triangles[3 * index + (form.IsMirrored ? 1 : 2)];
        shape.TryGetVertex(facet.IdP, out facet.P);
        shape.TryGetVertex(facet.IdQ, out facet.Q);
        shape.TryGetVertex(facet.IdR, out facet.R);
        Double3 e = facet.Q - facet.P, f = facet.R - facet.P;
        facet.Normal = Double3.Cross(e, f);
        if (facet.Normal.LengthSquared > Thin * (e.LengthSquared * f.LengthSquared)) return;
        facet.Normal = VectorDD.Normal(facet.P, facet.Q, facet.R);
    }

    /// <summary>Whether its plane is certainly as high as that, measured from a point along the normal.</summary>
    public readonly bool IsAbove(in Double3 point, double height)
    {
        double over = Double3.Dot(Normal, P - point);
        return height > 0 && over > 0 && over * over >= height * height * (1 + 2 * Slack) * Normal.LengthSquared;
    }

    /// <summary>Makes the second corner the first.</summary>
    public void NextEdge()
    {
        (P, Q, R) = (Q, R, P);
        (IdP, IdQ, IdR) = (IdQ, IdR, IdP);
    }
}
