using Gjk.Core;

namespace Gjk.Demo.Fuzz.Promises;

/// <summary>
/// A cast says that shapes overlap at its start exactly where the distance says so, touching included.
/// </summary>
internal sealed class CastsBeginAsOverlapsSays : IPromise
{
    public string Name => "a cast begins as Overlaps says";

    public string? Broken(FuzzPair pair)
    {
        CastResult r = pair.Cast;
        DistanceResult start = pair.Answer;
        return r.Status == CastStatus.OverlappingAtStart == start.IsOverlapping
            ? null
            : Say.Line($"the cast says {r.Status}, {r.Fraction:R}, Distance {start.Status}, {start.Distance:R}");
    }
}
