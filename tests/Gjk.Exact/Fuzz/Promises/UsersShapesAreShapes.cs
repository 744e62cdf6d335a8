namespace Gjk.Exact.Fuzz.Promises;

/// <summary>A user's own shape with the same supports gets an answer that is as exact, however generous its bounding
/// radius is: flag, distance and bound.</summary>
internal static class UsersShapesAreShapes
{
    public static string? Broken(FuzzPair pair)
    {
        foreach (double factor in (ReadOnlySpan<double>)[1, 2, 1e4, 1e12])
        {
            DistanceResult r = Ask(pair, factor);
            string name = Say.Line($"with a radius {factor} times as large");
            string? problem = Same.Problem(pair, r, name);
            if (problem is not null) return problem;
            if (LowerBoundHolds.Problem(pair, r) is { } bound) return Say.Line($"{name}: {bound}");
            if (Overlaps(pair, factor) != r.IsOverlapping)
                return Say.Line($"{name}: Overlaps says {!r.IsOverlapping}, Distance {r.Status}, {r.Distance}");
        }

        return null;
    }

    private static bool Overlaps(FuzzPair pair, double factor) =>
        ConvexQuery.Overlaps(new Generous(pair.A, factor), pair.PoseA, new Generous(pair.B, 1), pair.PoseB);

    private static DistanceResult Ask(FuzzPair pair, double factor) =>
        ConvexQuery.Distance(new Generous(pair.A, factor), pair.PoseA, new Generous(pair.B, 1), pair.PoseB);
}
