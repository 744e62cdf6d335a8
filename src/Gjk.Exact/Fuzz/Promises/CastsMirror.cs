using Gjk.Core;

namespace Gjk.Exact.Fuzz.Promises;

/// <summary>With A and B exchanged the cast is the same, mirrored, within the accuracy.</summary>
internal sealed class CastsMirror : IPromise
{
    public string Name => "exchanging A and B mirrors the cast";

    public string? Broken(FuzzPair pair)
    {
        CastResult s = ConvexQuery.Cast(pair.B, pair.PoseB, pair.Motion.B, pair.A, pair.PoseA, pair.Motion.A);
        return SameCast.Problem(pair, s.Swapped, "exchanged");
    }
}
