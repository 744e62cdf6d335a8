using Gjk.Core;

namespace Gjk.Exact.Fuzz.Promises;

/// <summary>
/// A warm start changes a cast by no more than the accuracy: an empty one, what the cast itself left, and what the
/// distance did.
/// </summary>
internal sealed class WarmCastsAreCold : IPromise
{
    public string Name => "a warm start does not change a cast";

    public string? Broken(FuzzPair pair)
    {
        WarmStart own = default, ofDistance = default;
        ConvexQuery.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB, ref ofDistance);
        return Problem(pair, ref own, "first, empty")
            ?? Problem(pair, ref own, "its own")
            ?? Problem(pair, ref ofDistance, "the distance's");
    }

    private static string? Problem(FuzzPair pair, ref WarmStart warm, string name)
    {
        CastResult s = ConvexQuery.Cast(
            pair.A, pair.PoseA, pair.Motion.A, pair.B, pair.PoseB, pair.Motion.B, 1, ref warm);
        return SameCast.Problem(pair, s, name);
    }
}
