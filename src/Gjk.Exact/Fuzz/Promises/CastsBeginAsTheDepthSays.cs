using System;
using Gjk.Core;

namespace Gjk.Exact.Fuzz.Promises;

/// <summary>
/// A cast says that shapes overlap at its start exactly where the signed distance says so, with its depth and normal.
/// Shapes that only touch there are a hit at 0 or a miss.
/// </summary>
internal sealed class CastsBeginAsTheDepthSays : IPromise
{
    public string Name => "a cast begins as the depth says";

    public string? Broken(FuzzPair pair)
    {
        CastResult r = pair.Cast;
        DistanceResult start = pair.Signed;
        bool isLimit = start.Status == GjkStatus.IterationLimit;
        double depth = isLimit ? -start.LowerBound : -start.Distance;
        if (r.Status == CastStatus.OverlappingAtStart)
        {
            return pair.Answer.IsOverlapping && r.Normal.Equals(start.Normal) && r.Depth == Math.Max(depth, 0)
                ? null
                : Say.Line($"the cast says {r}, the signed distance {start.Status}, {start.Distance:R}");
        }

        if (!pair.Answer.IsOverlapping) return null;
        if (IsDeep(pair)) return Say.Line($"the cast says {r}, but the depth is {depth:R}");
        bool isTouch = r.Status == CastStatus.Miss || (r.Status == CastStatus.Hit && r.Fraction == 0);
        return isTouch ? null : Say.Line($"the cast says {r.Status}, {r.Fraction:R}, but they touch at the start");
    }

    /// <summary>Whether the shapes overlap at the start by more than what may be called touching.</summary>
    public static bool IsDeep(FuzzPair pair)
    {
        DistanceResult start = pair.Signed;
        if (start.Status == GjkStatus.IterationLimit) return true;
        return pair.Answer.IsOverlapping
            && -start.Distance > (pair.IsCurved ? Accuracy.CurvedRatio * pair.Scale : 0);
    }
}
