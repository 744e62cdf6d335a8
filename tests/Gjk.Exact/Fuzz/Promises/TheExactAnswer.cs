namespace Gjk.Exact.Fuzz.Promises;

/// <summary>Every pair without a curved core is solved again in integers of any size: flag and distance are held to the
/// true answer within the accuracy.</summary>
internal static class TheExactAnswer
{
    public static string? Broken(FuzzPair pair)
    {
        DistanceResult r = pair.Answer;
        if (!pair.Truth.IsKnown || r.Status is not (GjkStatus.Separated or GjkStatus.Overlapping)) return null;
        ExactAnswer exact = pair.Truth.Answer;
        if (!(Math.Abs(r.Distance - exact.Distance) <= pair.Band(exact.Distance)))
            return Say.Line($"{r.Status}, distance {r.Distance:R}, truly {exact.Distance:R}");
        return r.IsOverlapping || !exact.Overlap || Parts(pair)
            ? null
            : Say.Line($"{r.Status}, {r.Distance:R}, but they overlap by more than {Accuracy.FlagScale} of the scale");
    }

    /// <summary>Whether the shapes part when B moves along the normal by what a flag may be wrong by.</summary>
    private static bool Parts(FuzzPair pair) =>
        pair.Truth.PartsWith((Double3)pair.Answer.Normal * (Accuracy.FlagScale * pair.Scale));
}
