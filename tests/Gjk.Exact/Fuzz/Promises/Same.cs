namespace Gjk.Exact.Fuzz.Promises;

/// <summary>Comparisons with the cold answer.</summary>
internal static class Same
{
    /// <summary>How an answer to the same question differs from the cold one by more than the accuracy, or
    /// null.</summary>
    /// <param name="pair">The pair with its cold answer.</param>
    /// <param name="other">The other answer.</param>
    /// <param name="name">What the other one is.</param>
    /// <param name="unit">The length of the other answer's unit, in the pair's.</param>
    public static string? Problem(FuzzPair pair, in DistanceResult other, string name, double unit = 1) =>
        Problem(pair, pair.Answer, other, name, unit);

    /// <summary>How two answers of either sign differ by more than the accuracy, or null.</summary>
    /// <inheritdoc cref="Problem(FuzzPair, in DistanceResult, string, double)"/>
    public static string? Problem(
        FuzzPair pair, in DistanceResult r, in DistanceResult other, string name, double unit = 1)
    {
        double distance = other.Distance * unit;
        double band = 2 * pair.Band(Math.Abs(r.Distance)) + Accuracy.LeastFloat * unit;
        bool answered = other.Status is GjkStatus.Separated or GjkStatus.Overlapping;
        return answered && Math.Abs(distance - r.Distance) <= band
            ? null
            : Say.Line($"{name}: {other.Status}, {distance}; as given: {r.Status}, {r.Distance}");
    }

    /// <summary>How two answers differ in any bit, or null; iterations do not count.</summary>
    public static string? BitProblem(in DistanceResult r, in DistanceResult s, string name) =>
        BitProblem(r, s, name, r.LowerBound);

    /// <summary>The same, of an answer whose lower bound is known to be another.</summary>
    public static string? BitProblem(in DistanceResult r, in DistanceResult s, string name, float lowerBound)
    {
        bool same = r.Status == s.Status && Bits(r.Distance, s.Distance) && Bits(lowerBound, s.LowerBound)
            && Bits(r.PointA, s.PointA) && Bits(r.PointB, s.PointB)
            && Bits(r.Normal, s.Normal) && Bits(r.LocalPointA, s.LocalPointA) && Bits(r.LocalPointB, s.LocalPointB);
        return same
            ? null
            : Say.Line(
                $"{name}: {s.Status}, {s.Distance:R}, {s.PointA}; as given: {r.Status}, {r.Distance:R}, {r.PointA}");
    }

    private static bool Bits(float a, float b) => a.Equals(b);

    private static bool Bits(Vector3 a, Vector3 b) => a.Equals(b);
}
