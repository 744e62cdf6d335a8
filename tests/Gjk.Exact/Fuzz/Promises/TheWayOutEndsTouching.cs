namespace Gjk.Exact.Fuzz.Promises;

/// <summary>Moved along the normal by the depth, B only touches A: a plane stands between them, and the deepest points,
/// which are points of the shapes, have met.</summary>
internal static class TheWayOutEndsTouching
{
    public static string? Broken(FuzzPair pair)
    {
        DistanceResult s = pair.Signed;
        if (!s.IsOverlapping) return null;
        if (!(s.Distance <= 0)) return Say.Line($"overlapping with the signed distance {s.Distance:R}");
        return NormalSeparates.Problem(pair, s)
            ?? PointsLieOnTheShapes.Problem(pair, s)
            ?? PointsDifferByTheDistance.Problem(pair, s)
            ?? Bound(pair, s);
    }

    private static string? Bound(FuzzPair pair, in DistanceResult s)
    {
        double least = s.Distance - pair.Band(-s.Distance) - pair.Noise;
        return s.LowerBound <= s.Distance && s.LowerBound >= least
            ? null
            : Say.Line($"the bound is {s.LowerBound:R}, the signed distance {s.Distance:R}");
    }
}
