namespace Gjk.Exact.Fuzz.Promises;

/// <summary>The certificate of a distance: the planes across the normal that touch the shapes stand the distance apart.
/// From above that proves the distance by itself (no gap between planes can exceed it); from below as far as a normal
/// rounded to float can tell.</summary>
internal static class NormalSeparates
{
    public static string? Broken(FuzzPair pair)
    {
        DistanceResult r = pair.Answer;
        if (r.Status == GjkStatus.Overlapping)
            return r.Normal == default ? null : Say.Line($"overlapping with the normal {r.Normal}");
        return r.Status == GjkStatus.Separated ? Problem(pair, r) : null;
    }

    /// <summary>How the normal of an answer for the pair, of either sign, breaks the promise, or null.</summary>
    public static string? Problem(FuzzPair pair, in DistanceResult r)
    {
        Double3 n = r.Normal;
        double length = n.Length;
        if (!(Math.Abs(length - 1) <= Accuracy.UnitLength)) return Say.Line($"the normal's length is {length}");
        double d = r.Distance, size = Math.Abs(d), gap = pair.Gap(n * (1 / length));
        double band = pair.Band(size) + pair.Noise;
        if (!(gap <= d + band)) return Say.Line($"they are {gap} apart, the distance is said to be {d}");

        // A plane that is turned by an angle loses at most that part of the circle that its point of contact may lie
        // away.
        double turned = Accuracy.NormalTurn * (pair.BodyA.LongestSide + pair.BodyB.LongestSide + size) * Math.Sqrt(3);
        double tilt = pair.IsCurved ? Math.Max(turned, pair.Band(size)) : turned;
        return gap >= d - band - tilt ? null : Say.Line($"they are only {gap} apart, the distance is said to be {d}");
    }
}
