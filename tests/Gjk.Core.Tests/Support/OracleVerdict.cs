namespace Gjk.Core.Tests.Support;

/// <summary>Holds a pair to the exact oracle.</summary>
internal static class OracleVerdict
{
    /// <summary>What is wrong with the library's answer for a pair of polytopes, or null.</summary>
    public static string? Problem(TestPair pair, out ExactAnswer exact) => Problem(pair, pair.Distance(), out exact);

    public static string? Problem(TestPair pair, in DistanceResult r, out ExactAnswer exact)
    {
        exact = pair.Exact();
        double scale = pair.Scale == 0 ? exact.Distance : pair.Scale;
        if (r.Status is not (GjkStatus.Separated or GjkStatus.Overlapping))
            return $"status {r.Status} after {r.Iterations} iterations";
        if (!(Math.Abs(r.Distance - exact.Distance) <= Accuracy.Band(exact.Distance, scale) + HalfLeastFloat))
            return $"distance {r.Distance:R}, truly {exact.Distance:R}";
        if (!(r.LowerBound <= exact.Distance))
            return $"lower bound {r.LowerBound:R} above the true distance {exact.Distance:R}";
        if (r.IsOverlapping == exact.Overlap) return null;
        double least = exact.Overlap ? Depth(pair) : exact.Distance;
        return least > Accuracy.FlagScale * scale
            ? $"status {r.Status}, truly overlap {exact.Overlap} by {least:R}"
            : null;
    }

    /// <summary>The rounding of a distance to the smallest floats.</summary>
    private const double HalfLeastFloat = 0.5 * float.Epsilon;

    private static double Depth(TestPair pair) => CloudDepth.Of(pair) + pair.A.Margin + pair.B.Margin;
}
