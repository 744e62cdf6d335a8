namespace Gjk.Exact.Fuzz.Promises;

/// <summary>No direction parts overlapping shapes at a lower cost than the depth. The shortest way out of polytopes is
/// across a face of their difference: a face of either, or two edges. Of small ones all of these are tried, of larger
/// ones some. Shapes that overlap by their margins alone have a depth that is known exactly.</summary>
internal static class NoWayOutIsShorter
{
    /// <summary>Dot products to spend on the faces of a difference.</summary>
    private const int MostWork = 200_000;

    /// <summary>Ratio to the scale: how far the best of all faces may be off the truth, where nearly parallel edges
    /// span them.</summary>
    private const double Slivers = 1e-7;

    /// <summary>A sine: edges that are more parallel span no face.</summary>
    private const double Parallel = 1e-12;

    public static string? Broken(FuzzPair pair)
    {
        DistanceResult s = pair.Signed;
        if (!s.IsOverlapping) return null;
        double size = Math.Abs(s.Distance), band = pair.Band(size) + pair.Noise;
        if (pair.Truth.SignedByMargins() is { } truth)
        {
            return Math.Abs(s.Distance - truth) <= band && s.LowerBound <= truth + Accuracy.Rounding * pair.Scale
                ? null
                : Say.Line($"the signed distance is {s.Distance:R}, truly {truth:R}; the bound {s.LowerBound:R}");
        }

        double widest = NoPlaneSeparatesAnOverlap.Widest(pair);
        bool isWhole = TryFaces(pair, ref widest);
        if (!(widest <= s.Distance + band))
            return Say.Line($"the depth is {size:R}, but a direction costs {-widest:R}");
        if (!isWhole) return null;
        double allowed = band + Slivers * pair.Scale;
        return s.Distance <= widest + allowed && s.LowerBound <= widest + allowed
            ? null
            : Say.Line($"the depth is {size:R}, at most {-s.LowerBound:R}, but every way out costs {-widest:R}");
    }

    /// <summary>Tries all faces that the difference of the cores can have; false where they are too many.</summary>
    private static bool TryFaces(FuzzPair pair, ref double widest)
    {
        PosedShape a = pair.BodyA, b = pair.BodyB;
        double edgeCount = a.EdgeCount + b.EdgeCount;
        if (pair.IsCurved || edgeCount * edgeCount * (a.Vertices.Length + b.Vertices.Length) > MostWork) return false;
        List<Double3> edges =
            [.. a.EdgeDirections().ConvertAll(e => a.Rotate(e)), .. b.EdgeDirections().ConvertAll(e => b.Rotate(e))];
        bool isSolid = false;
        for (int i = 0; i < edges.Count; i++)
        {
            for (int j = i + 1; j < edges.Count; j++)
            {
                Double3 n = Double3.Cross(edges[i], edges[j]);
                double length = n.Length;
                if (!(length > Parallel * edges[i].Length * edges[j].Length)) continue;
                n *= 1 / length;
                widest = Math.Max(widest, Math.Max(pair.Gap(n), pair.Gap(-n)));
                isSolid = true;
            }
        }

        return isSolid;
    }
}
