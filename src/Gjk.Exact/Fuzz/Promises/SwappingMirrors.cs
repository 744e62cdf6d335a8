using Gjk.Core;

namespace Gjk.Exact.Fuzz.Promises;

/// <summary>With A and B exchanged the answer is the same, mirrored, within the accuracy.</summary>
internal sealed class SwappingMirrors : IPromise
{
    public string Name => "exchanging A and B mirrors the answer";

    public string? Broken(FuzzPair pair)
    {
        DistanceResult s = ConvexQuery.Distance(pair.B, pair.PoseB, pair.A, pair.PoseA);
        return Same.Problem(pair, s, "exchanged") ?? Depth(pair);
    }

    /// <summary>Where the search outgrew its room either way, there are only bounds.</summary>
    private static string? Depth(FuzzPair pair)
    {
        DistanceResult s = ConvexQuery.SignedDistance(pair.B, pair.PoseB, pair.A, pair.PoseA);
        return pair.Signed.Status == GjkStatus.IterationLimit || s.Status == GjkStatus.IterationLimit
            ? null
            : Same.Problem(pair, pair.Signed, s, "the signed distance, exchanged");
    }
}
