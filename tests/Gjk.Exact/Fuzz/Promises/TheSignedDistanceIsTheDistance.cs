namespace Gjk.Exact.Fuzz.Promises;

/// <summary>The signed distance overlaps where the distance does, and is the distance bit for bit elsewhere. Only
/// curved shapes and large hulls may outgrow the room of its search, and then the truth is between its
/// bounds.</summary>
internal static class TheSignedDistanceIsTheDistance
{
    /// <summary>Hulls with no more vertices always get an answer.</summary>
    private const int MostVertices = 512;

    public static string? Broken(FuzzPair pair)
    {
        DistanceResult r = pair.Answer, s = pair.Signed;
        if (s.Status == GjkStatus.IterationLimit && r.IsOverlapping) return Limit(pair, s);
        if (s.Status != r.Status) return Say.Line($"it says {s.Status}, {s.Distance:R}, the distance {r.Status}");
        return r.IsOverlapping ? null : Same.BitProblem(r, s, "the signed distance");
    }

    private static string? Limit(FuzzPair pair, in DistanceResult s)
    {
        if (!pair.IsCurved && !IsLarge(pair.A) && !IsLarge(pair.B))
            return Say.Line($"{s.Status} after {s.Iterations} iterations, between {s.LowerBound:R} and {s.Distance:R}");
        if (!(s.LowerBound <= s.Distance && s.Distance <= 0))
            return Say.Line($"the bounds are {s.LowerBound:R} and {s.Distance:R}");

        // The true signed distance is the widest gap of all, so no gap may be wider than the upper bound.
        double widest = NoPlaneSeparatesAnOverlap.Widest(pair), band = pair.Band(-s.Distance) + pair.Noise;
        return widest <= s.Distance + band
            ? null
            : Say.Line($"the upper bound is {s.Distance:R}, but a plane leaves {widest:R}");
    }

    private static bool IsLarge(in ConvexShape shape) => shape.Hull is { VertexCount: > MostVertices };
}
