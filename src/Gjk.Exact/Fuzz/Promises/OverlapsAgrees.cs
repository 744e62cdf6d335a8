using Gjk.Core;

namespace Gjk.Exact.Fuzz.Promises;

/// <summary>The boolean query says what the distance query says, touching included.</summary>
internal sealed class OverlapsAgrees : IPromise
{
    public string Name => "Overlaps says what Distance says";

    public string? Broken(FuzzPair pair)
    {
        bool overlaps = ConvexQuery.Overlaps(pair.A, pair.PoseA, pair.B, pair.PoseB, out GjkStatus status);
        DistanceResult r = pair.Answer;
        return overlaps == r.IsOverlapping && status == r.Status
            ? null
            : Say.Line($"Overlaps says {overlaps} ({status}), Distance {r.Status}, {r.Distance}");
    }
}
