namespace Gjk.Exact.Fuzz.Promises;

/// <summary>The same question again, or in other words, has the same answer.</summary>
internal static class SamePromises
{
    /// <summary>A pure number: the roundings of four weights.</summary>
    private const double WeightSum = 1e-12;

    /// <summary>Building hulls of more corners costs more than all the other promises.</summary>
    private const int MostCorners = 40;

    /// <summary>The boolean query says what the distance query says, touching included.</summary>
    public static string? OverlapsAgrees(FuzzPair pair)
    {
        bool overlaps = ConvexQuery.Overlaps(pair.A, pair.PoseA, pair.B, pair.PoseB, out GjkStatus status);
        DistanceResult r = pair.Answer;
        return overlaps == r.IsOverlapping && status == r.Status
            ? null
            : Say.Line($"Overlaps says {overlaps} ({status}), Distance {r.Status}, {r.Distance}");
    }

    /// <summary>With A and B exchanged the answer is the same, mirrored, within the accuracy. Where the search for a
    /// depth outgrew its room either way, there are only bounds.</summary>
    public static string? SwappingMirrors(FuzzPair pair)
    {
        DistanceResult r = ConvexQuery.Distance(pair.B, pair.PoseB, pair.A, pair.PoseA);
        if (Same.Problem(pair, r, "exchanged") is { } problem) return problem;
        DistanceResult s = ConvexQuery.SignedDistance(pair.B, pair.PoseB, pair.A, pair.PoseA);
        return pair.Signed.Status == GjkStatus.IterationLimit || s.Status == GjkStatus.IterationLimit
            ? null
            : Same.Problem(pair, pair.Signed, s, "the signed distance, exchanged");
    }

    /// <summary>A query depends on its arguments alone: asked again it gives the same bits, and so does the overload
    /// with the final simplex, whose weights are those of points.</summary>
    public static string? TheSameBitsAgain(FuzzPair pair)
    {
        DistanceResult again = ConvexQuery.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB);
        DistanceResult whole = ConvexQuery.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB, out FinalSimplex simplex);
        return Same.BitProblem(pair.Answer, again, "asked again")
            ?? Same.BitProblem(pair.Answer, whole, "with the simplex")
            ?? Weights(simplex);
    }

    /// <summary>Vertices that are given twice, and in another order, change nothing.</summary>
    public static string? RepeatsChangeNothing(FuzzPair pair) =>
        TryRepeat(pair.A, out ConvexShape a) & TryRepeat(pair.B, out ConvexShape b)
            ? Same.Problem(pair, ConvexQuery.Distance(a, pair.PoseA, b, pair.PoseB), "with repeats")
            : null;

    private static string? Weights(in FinalSimplex simplex)
    {
        double sum = 0, least = 1;
        for (int i = 0; i < simplex.Count; i++)
        {
            double weight = simplex.Weight(i);
            sum += weight;
            least = Math.Min(least, weight);
        }

        return simplex.Count >= 1 && Math.Abs(sum - 1) <= WeightSum && least >= 0
            ? null
            : Say.Line($"{simplex.Count} weights, the least {least}, the sum {sum}");
    }

    /// <summary>False when the shape cannot be made again; what is no mesh stays as it is.</summary>
    private static bool TryRepeat(in ConvexShape shape, out ConvexShape repeated)
    {
        repeated = shape;
        if (shape.Hull is not { } hull) return true;
        if (hull.VertexCount > MostCorners) return false;
        var points = new List<Vector3>();
        for (int i = hull.VertexCount - 1; i >= 0; i--)
        {
            points.Add(hull.GetVertex(i));
            points.Add(hull.GetVertex(i / 2));
        }

        repeated = ConvexShape.Mesh(points);
        if (shape.Scale != Vector3.One) repeated = repeated.Scaled(shape.Scale);
        return true;
    }
}
