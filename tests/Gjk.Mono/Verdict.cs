using System;
using Gjk.Core;
using Gjk.Exact.Answers;

namespace Gjk.Mono;

/// <summary>Checks that an answer has the promised accuracy.</summary>
internal static class Verdict
{
    /// <summary>Ratio. The file's answers have 20 digits, a double has 16.</summary>
    private const double FileRounding = 2.3e-16;

    /// <summary>What is wrong with the answer. Null if nothing is wrong.</summary>
    public static string? Problem(HardCase c, in DistanceResult r)
    {
        if (r.Status is not (GjkStatus.Separated or GjkStatus.Overlapping))
            return FormattableString.Invariant($"status {r.Status} after {r.Iterations} iterations");
        if (r.IsOverlapping != c.Overlap && Math.Max(c.Distance, c.Depth) > Accuracy.FlagScale * c.Scale)
            return FormattableString.Invariant($"overlap {r.IsOverlapping}, truly {c.Overlap}");
        double band = Accuracy.Band(c.Distance, c.Scale);
        if (!(Math.Abs(r.Distance - c.Distance) <= band))
            return FormattableString.Invariant($"distance {r.Distance:R}, truly {c.Distance:R}");
        if (!(r.LowerBound <= c.Distance * (1 + FileRounding)))
            return FormattableString.Invariant($"lower bound {r.LowerBound:R}, truly {c.Distance:R}");
        if (!(r.LowerBound >= r.Distance - band))
            return FormattableString.Invariant($"lower bound {r.LowerBound:R} far below the distance {r.Distance:R}");
        bool overlaps = ConvexQuery.Overlaps(c.A.Shape, c.A.Pose, c.B.Shape, c.B.Pose);
        return overlaps == r.IsOverlapping
            ? null
            : FormattableString.Invariant($"Overlaps {overlaps}, Distance {r.Status}");
    }
}
