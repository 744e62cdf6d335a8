namespace Gjk.Core;

/// <summary>Bodies along an edge: a capsule, a cylinder's side or a rounded edge beside an edge of a face touches that
/// edge, not the face. Which of the two faces at an edge a shape shows is a last bit, and a body that crosses the edge
/// at a small angle lies half beside either; so the edge is what is shared (<see cref="SharedLength"/>).</summary>
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
        bool mayShareFaces = a.Count > 2 && b.Count > 2 && !a.IsSteepTo(b, Steep);
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
        a.KeepEdge(edgeA, size);
        b.KeepEdge(edgeB, size);
    }

    private static double Roundness(in FlatFeature feature) =>
        feature.Count > 2 ? feature.Margin : Math.Max(feature.RoundnessAt(0), feature.RoundnessAt(1));
}
