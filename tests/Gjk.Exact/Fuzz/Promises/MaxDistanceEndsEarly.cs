namespace Gjk.Exact.Fuzz.Promises;

/// <summary>With a maximum distance the answer is the full one where that is nearer, to the last bit; beyond, a plane
/// proves it.</summary>
internal static class MaxDistanceEndsEarly
{
    public static string? Broken(FuzzPair pair)
    {
        DistanceResult full = pair.Answer;
        if (full.Status is not (GjkStatus.Separated or GjkStatus.Overlapping)) return null;
        float d = full.Distance;
        foreach (float limit in (ReadOnlySpan<float>)[0, -1, d * 0.5f, d * 0.999f, d, d * 1.001f, float.MaxValue])
        {
            string? problem = Problem(pair, full, limit);
            if (problem is not null) return Say.Line($"limit {limit:R}: {problem}");
        }

        return ConvexQuery.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB, float.NaN).Status == GjkStatus.InvalidInput
            ? null
            : "a limit that is NaN is taken";
    }

    private static string? Problem(FuzzPair pair, in DistanceResult full, float limit)
    {
        DistanceResult r = ConvexQuery.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB, limit);
        double reach = Math.Max(limit, 0), band = pair.Band(reach);
        if (r.Status != GjkStatus.BeyondMaxDistance)
        {
            if (full.Distance - band > reach && !full.IsOverlapping)
                return Say.Line($"{r.Status}, the distance is {full.Distance:R}");
            return Same.BitProblem(full, r, "with the limit");
        }

        if (full.IsOverlapping || full.Distance + band < reach)
            return Say.Line($"{r.Status}, but without it {full.Status}, {full.Distance:R}");
        if (!float.IsPositiveInfinity(r.Distance) || !float.IsNaN(r.PointA.X) || !float.IsNaN(r.PointB.X))
            return Say.Line($"a distance or points: {r.Distance}, {r.PointA}");
        if (!(r.LowerBound <= pair.Truth.AtMost))
            return Say.Line($"the bound {r.LowerBound:R} exceeds the true distance {pair.Truth.AtMost:R}");
        if (!(r.LowerBound >= reach - band)) return Say.Line($"the bound {r.LowerBound:R} does not prove it");
        Double3 n = r.Normal;
        double length = n.Length;
        if (!(Math.Abs(length - 1) <= Accuracy.UnitLength)) return Say.Line($"the normal's length is {length}");
        double gap = pair.Gap(n * (1 / length));
        double lever = pair.BodyA.LongestSide + pair.BodyB.LongestSide + pair.Centers.Length;
        double turned = 2 * Accuracy.NormalTurn * lever;
        return gap >= r.LowerBound - turned - pair.Noise
            ? null
            : Say.Line($"the plane leaves {gap}, the bound says {r.LowerBound}");
    }
}
