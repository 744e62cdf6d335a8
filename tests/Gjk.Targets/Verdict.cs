using System;
using Gjk.Core;
using Gjk.Exact.Answers;
using Gjk.Exact.Cases;

namespace Gjk.Targets;

/// <summary>Checks that an answer has the promised accuracy.</summary>
internal static class Verdict
{
    /// <summary>Ratio. The files' answers have 20 digits, a double has 16.</summary>
    private const double FileRounding = 2.3e-16;

    /// <summary>Ratio of a cast to the size or the way, whichever is larger.</summary>
    private const double CastAccuracy = 1e-7;

    /// <summary>What is wrong with the answer. Null if nothing is wrong.</summary>
    public static string? Problem(CaseKind kind, CasePair c) => kind switch
    {
        CaseKind.Distance => OfDistance(c),
        CaseKind.Depth => OfDepth(c),
        _ => OfCast(c),
    };

    private static string? OfDistance(CasePair c)
    {
        DistanceResult r = ConvexQuery.Distance(c.A.Shape, c.A.Pose, c.B.Shape, c.B.Pose);
        bool isOverlap = bool.Parse(c["overlap"]);
        double distance = c.Number("distance"), band = Accuracy.Band(distance, c.Scale);
        if (r.Status is not (GjkStatus.Separated or GjkStatus.Overlapping))
            return FormattableString.Invariant($"status {r.Status} after {r.Iterations} iterations");
        if (r.IsOverlapping != isOverlap && Math.Max(distance, c.Number("depth")) > Accuracy.FlagScale * c.Scale)
            return FormattableString.Invariant($"overlap {r.IsOverlapping}, truly {isOverlap}");
        if (!(Math.Abs(r.Distance - distance) <= band))
            return FormattableString.Invariant($"distance {r.Distance:R}, truly {distance:R}");
        if (!(r.LowerBound <= distance * (1 + FileRounding)))
            return FormattableString.Invariant($"lower bound {r.LowerBound:R}, truly {distance:R}");
        if (!(r.LowerBound >= r.Distance - band))
            return FormattableString.Invariant($"lower bound {r.LowerBound:R} far below the distance {r.Distance:R}");
        bool overlaps = ConvexQuery.Overlaps(c.A.Shape, c.A.Pose, c.B.Shape, c.B.Pose);
        return overlaps == r.IsOverlapping
            ? null
            : FormattableString.Invariant($"Overlaps {overlaps}, Distance {r.Status}");
    }

    private static string? OfDepth(CasePair c)
    {
        DistanceResult r = ConvexQuery.SignedDistance(c.A.Shape, c.A.Pose, c.B.Shape, c.B.Pose);
        double truth = -c.Number("depth"), band = Accuracy.Band(Math.Abs(truth), c.Scale);
        return Math.Abs(r.Distance - truth) <= band
            ? null
            : FormattableString.Invariant($"signed distance {r.Distance:R}, truly {truth:R}, status {r.Status}");
    }

    private static string? OfCast(CasePair c)
    {
        CastResult r = ConvexQuery.Cast(
            c.A.Shape, c.A.Pose, c.A.Velocity, c.B.Shape, c.B.Pose, c.B.Velocity);
        CastStatus outcome = c["outcome"] switch
        {
            "hit" => CastStatus.Hit,
            "miss" => CastStatus.Miss,
            _ => CastStatus.OverlappingAtStart,
        };
        if (r.Status != outcome) return FormattableString.Invariant($"{r.Status}, truly {outcome}");
        if (outcome != CastStatus.Hit) return null;
        double fraction = c.Number("fraction"), way = (c.B.Velocity - c.A.Velocity).Length();
        return Math.Abs(r.Fraction - fraction) * way <= CastAccuracy * Math.Max(c.Scale, fraction * way)
            ? null
            : FormattableString.Invariant($"fraction {r.Fraction:R}, truly {fraction:R}");
    }
}
