using System;
using Gjk.Core;

namespace Gjk.Exact.Fuzz.Promises;

/// <summary>
/// A largest fraction cuts a cast off: before it nothing changes, to the last bit, and what comes after it is a miss.
/// </summary>
internal sealed class CastsEndAtTheLargestFraction : IPromise
{
    public string Name => "a largest fraction changes nothing before it";

    public string? Broken(FuzzPair pair)
    {
        CastResult r = pair.Cast;
        float f = r.Status == CastStatus.Hit ? r.Fraction : 1;
        foreach (float most in (ReadOnlySpan<float>)[-1, 0, f * 0.5f, f * 0.999f, f, f * 1.001f, 2])
        {
            CastResult s = ConvexQuery.Cast(
                pair.A, pair.PoseA, pair.Motion.A, pair.B, pair.PoseB, pair.Motion.B, most);
            if (Problem(pair, s, Math.Max(most, 0)) is { } problem) return Say.Line($"up to {most:R}: {problem}");
        }

        CastStatus ofNaN = ConvexQuery.Cast(
            pair.A, pair.PoseA, pair.Motion.A, pair.B, pair.PoseB, pair.Motion.B, float.NaN).Status;
        return ofNaN == CastStatus.InvalidInput ? null : "a largest fraction that is NaN is taken";
    }

    private static string? Problem(FuzzPair pair, in CastResult s, float most)
    {
        CastResult r = pair.Cast;
        if (r.Status == CastStatus.IterationLimit || s.Status == CastStatus.IterationLimit) return null;
        if (r.Status == CastStatus.OverlappingAtStart || (r.Status == CastStatus.Hit && r.Fraction < most))
            return SameCast.BitProblem(r, s, "with the limit");
        if (most > 1) return CastProof.Problem(pair, s, most);

        // A fraction that was rounded down to the limit is beyond it.
        if (r.Status == CastStatus.Hit && r.Fraction == most && s.Status == CastStatus.Hit)
            return SameCast.BitProblem(r, s, "with the limit");
        return s.Status == CastStatus.Miss && s.Fraction == most
            ? null
            : Say.Line($"{s.Status}, {s.Fraction:R}; without it {r.Status}, {r.Fraction:R}");
    }
}
