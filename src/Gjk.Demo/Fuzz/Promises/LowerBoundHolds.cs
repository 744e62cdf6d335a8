using Gjk.Core;

namespace Gjk.Demo.Fuzz.Promises;

/// <summary>The lower bound is below the true distance, without a band, and close to the distance.</summary>
internal sealed class LowerBoundHolds : IPromise
{
    public string Name => "the lower bound is below the distance and closes the gap";

    public string? Broken(FuzzPair pair)
    {
        DistanceResult r = pair.Answer;
        if (r.Status == GjkStatus.Overlapping) return r.Distance == 0 && r.LowerBound == 0 ? null : Say.Line($"overlapping with distance {r.Distance}, bound {r.LowerBound}");
        if (r.Status != GjkStatus.Separated) return null;
        if (!(r.LowerBound <= pair.Truth.AtMost)) return Say.Line($"the bound {r.LowerBound:R} is above the true distance, at most {pair.Truth.AtMost:R}");
        return r.LowerBound <= r.Distance && r.LowerBound >= r.Distance - pair.Band(r.Distance) ? null : Say.Line($"the bound is {r.LowerBound}, the distance {r.Distance}");
    }
}
