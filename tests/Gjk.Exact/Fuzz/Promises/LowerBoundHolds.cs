namespace Gjk.Exact.Fuzz.Promises;

/// <summary>The lower bound is below the true distance, without a band, and as near it as the distance is promised to
/// be.</summary>
internal static class LowerBoundHolds
{
    public static string? Broken(FuzzPair pair) => Problem(pair, pair.Answer);

    /// <summary>How an answer for the pair breaks the promise, or null.</summary>
    public static string? Problem(FuzzPair pair, in DistanceResult r)
    {
        if (r.Status == GjkStatus.Overlapping)
            return r.Distance == 0 && r.LowerBound == 0
                ? null
                : Say.Line($"overlapping with distance {r.Distance}, bound {r.LowerBound}");
        if (r.Status != GjkStatus.Separated) return null;
        double most = pair.Truth.AtMost, distance = pair.Truth.IsKnown ? most : r.Distance;
        if (!(r.LowerBound <= most))
            return Say.Line($"the bound {r.LowerBound:R} is above the true distance, at most {most:R}");
        return r.LowerBound <= r.Distance && r.LowerBound >= distance - pair.Band(distance)
            ? null
            : Say.Line($"the bound is {r.LowerBound:R}, the distance {r.Distance:R}, truly {most:R} or less");
    }
}
