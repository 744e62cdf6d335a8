namespace Gjk.Core;

/// <summary>Bodies along an edge: a capsule, a cylinder's side or a rounded edge beside an edge of a face touches that
/// edge, not the face. Which of the two faces at an edge a shape shows is a last bit; so the edge is what is shared
/// (<see cref="SharedLength"/>), unless the body crosses it onto a face that is level to it: that is under it
/// then.</summary>
internal static class MeetingEdges
{
    /// <summary>Slope: faces whose gap opens faster meet in an edge. Steeper than any body rocks on its face; pinned by
    /// AlongEdgeTests.</summary>
    private const double Steep = 0.1;

    /// <summary>Leaves of two features the edges in which they meet, if both have one at the deepest point, and one is
    /// round.</summary>
    /// <param name="a">What A shows; the deepest point is the origin of its plane.</param>
    /// <param name="b">What B shows.</param>
    /// <param name="size">Of the pair.</param>
    public static void Keep(ref FlatFeature a, ref FlatFeature b, double size)
    {
        double opensU = a.OpensTo(b, 1, 0), opensV = a.OpensTo(b, 0, 1);
        bool isSteep = opensU * opensU + opensV * opensV > Steep * Steep;
        bool mayShareFaces = a.Count > 2 && b.Count > 2 && !isSteep;
        if ((a.Count == 2 && b.Count == 2) || a.IsDisc || b.IsDisc) return;
        double round = Roundness(a) + Roundness(b);
        if (!(round > 0)) return;

        // Between edges that are this near the surfaces lie no deeper than contacts tell apart.
        double within = 2 * Math.Sqrt(2 * ContactBuilder.AsDeep * size * round), least = ContactPlaces.Parallel;
        int edgeA = -1, edgeB = -1;
        for (int i = 0; i < a.EdgeCount; i++)
        {
            if (a.Count > 2 && !(Math.Abs(a.Inside(i, 0, 0)) <= within)) continue;
            for (int k = 0; k < b.EdgeCount; k++)
            {
                if (b.Count > 2 && !(Math.Abs(b.Inside(k, 0, 0)) <= within)) continue;
                double sine = Math.Abs(a[i].InwardU * b[k].InwardV - a[i].InwardV * b[k].InwardU);
                double cosine = a[i].InwardU * b[k].InwardU + a[i].InwardV * b[k].InwardV;

                // Faces on one side of their edges share an area, unless they are steep to each other.
                if (!(sine <= least) || (mayShareFaces && cosine > 0)) continue;
                (least, edgeA, edgeB) = (sine, i, k);
            }
        }

        if (edgeA < 0) return;
        bool isALine = a.Count == 2 || (b.Count > 2 && a.Secant > b.Secant);
        if (isALine) a.KeepEdge(edgeA, size);
        else b.KeepEdge(edgeB, size);
        (edgeA, edgeB) = isALine ? (0, edgeB) : (edgeA, 0);
        if (!mayShareFaces && IsOverFace(a, edgeA, b, edgeB, isALine, round, size)) return;
        a.KeepEdge(edgeA, size);
        b.KeepEdge(edgeB, size);
    }

    /// <summary>Whether a line lies over the face beside an edge, at an end of what it shares with that: nearer to the
    /// face than to the edge. It crosses the edge then, or runs along within it.</summary>
    private static bool IsOverFace(
        in FlatFeature a, int edgeA, in FlatFeature b, int edgeB, bool isALine, double round, double size)
    {
        double slack = ContactPlaces.Slack * size;
        var shared = new SharedLength(a, edgeA, b, edgeB, slack);
        ref FlatCorner edge = ref isALine ? ref b[edgeB] : ref a[edgeA];
        double u = edge.InwardU, v = edge.InwardV, sign = isALine ? 1 : -1;
        double atBegin = sign * shared.ApartTowards(shared.Begin, u, v);
        double inside = Math.Max(atBegin, sign * shared.ApartTowards(shared.End, u, v));

        // A face that falls away by a slope is touched as far within the edge as the round side leans towards that.
        return shared.IsThere && inside > Math.Max(slack, 2 * round * a.OpensTo(b, u, v));
    }

    private static double Roundness(in FlatFeature feature) =>
        feature.Count > 2 ? feature.Margin : Math.Max(feature.RoundnessAt(0), feature.RoundnessAt(1));
}
