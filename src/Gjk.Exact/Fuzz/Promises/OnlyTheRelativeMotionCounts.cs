using System;
using System.Numerics;
using Gjk.Core;

namespace Gjk.Exact.Fuzz.Promises;

/// <summary>
/// Moving both shapes by one more vector over the cast changes neither the fraction nor the normal, where the sums of
/// floats are exact.
/// </summary>
internal sealed class OnlyTheRelativeMotionCounts : IPromise
{
    public string Name => "a motion that both shapes share changes no cast";

    public string? Broken(FuzzPair pair)
    {
        Vector3 a = pair.Motion.A, b = pair.Motion.B;
        foreach (Vector3 shared in (ReadOnlySpan<Vector3>)[-a, -b, new(1024, -2048, 512), a - b])
        {
            if (!ExactSums.TryAdd(a, shared, out Vector3 withA) || !ExactSums.TryAdd(b, shared, out Vector3 withB))
                continue;
            CastResult r = pair.Cast, s = ConvexQuery.Cast(pair.A, pair.PoseA, withA, pair.B, pair.PoseB, withB);
            if (r.Status != s.Status || !r.Fraction.Equals(s.Fraction) || !r.Normal.Equals(s.Normal))
                return Say.Line($"{shared} more: {s.Status}, {s.Fraction:R}; as given: {r.Status}, {r.Fraction:R}");
        }

        return null;
    }
}
