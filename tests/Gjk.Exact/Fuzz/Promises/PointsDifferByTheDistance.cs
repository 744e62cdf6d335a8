namespace Gjk.Exact.Fuzz.Promises;

/// <summary>From one closest point to the other is normal times distance, in the world and through the local frames; of
/// overlapping shapes both are one.</summary>
internal static class PointsDifferByTheDistance
{
    /// <summary>Ratio to the distance: the rounding of the distance and of the normal's three components.</summary>
    private const double Product = 4 * Accuracy.HalfFloat;

    public static string? Broken(FuzzPair pair)
    {
        DistanceResult r = pair.Answer;
        if (r.Status is not (GjkStatus.Separated or GjkStatus.Overlapping)) return null;
        return r.IsOverlapping && r.PointA != r.PointB
            ? Say.Line($"overlapping with the points {r.PointA} and {r.PointB}")
            : Problem(pair, r);
    }

    /// <summary>How an answer for the pair, signed or not, breaks the promise, or null.</summary>
    public static string? Problem(FuzzPair pair, in DistanceResult r)
    {
        Double3 step = (Double3)r.Normal * r.Distance;
        double slack = pair.DifferenceSlack + Product * Math.Abs(r.Distance) + pair.Noise;
        double world = ((Double3)r.PointB - r.PointA - step).Length;
        if (!(world <= slack + PointsLieOnTheShapes.Rounded(r.PointA) + PointsLieOnTheShapes.Rounded(r.PointB)))
            return Say.Line($"in the world they are {world} off that");

        double local = (pair.Between(r.LocalPointA, r.LocalPointB) - step).Length;
        return local <= slack + PointsLieOnTheShapes.Rounded(r.LocalPointA)
            + PointsLieOnTheShapes.Rounded(r.LocalPointB)
            ? null
            : Say.Line($"the local ones are {local} off that");
    }
}
