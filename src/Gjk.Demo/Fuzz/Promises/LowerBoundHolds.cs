using Gjk.Core;

namespace Gjk.Demo.Fuzz.Promises;

/// <summary>The lower bound is below the distance, and close to it.</summary>
internal sealed class LowerBoundHolds : IPromise
{
    public string Name => "the lower bound is below the distance and closes the gap";

    public string? Broken(FuzzPair pair)
    {
        DistanceResult r = pair.Answer;
        if (r.Status == GjkStatus.Overlapping) return r.Distance == 0 && r.LowerBound == 0 ? null : Say.Line($"overlapping with distance {r.Distance}, bound {r.LowerBound}");
        if (r.Status != GjkStatus.Separated) return null;
        return r.LowerBound <= r.Distance && r.LowerBound >= r.Distance - pair.Band(r.Distance) ? null : Say.Line($"the bound is {r.LowerBound}, the distance {r.Distance}");
    }
}
