namespace Gjk.Core.Tests.Queries;

/// <summary>Contract 3: what a query says that was told how far to look.</summary>
public class MaxDistanceTests
{
    [Fact]
    public void BeyondItOnlyAPlaneIsGiven() => Each((pair, full) =>
    {
        float limit = full.Distance * 0.75f;
        DistanceResult r = pair.Distance(limit);
        if (r.Status != GjkStatus.BeyondMaxDistance)
            return $"limit {limit:R}: status {r.Status}, distance {full.Distance:R}";
        if (!float.IsPositiveInfinity(r.Distance)) return $"distance {r.Distance:R}";
        if (!IsNaN(r.PointA) || !IsNaN(r.PointB) || !IsNaN(r.LocalPointA) || !IsNaN(r.LocalPointB))
            return "points that are not NaN";
        if (!(r.LowerBound <= full.Distance * (1 + Accuracy.DistanceRatio)))
            return $"lower bound {r.LowerBound:R} above the distance {full.Distance:R}";
        if (!(r.LowerBound >= limit * (1 - Accuracy.DistanceRatio)))
            return $"lower bound {r.LowerBound:R} does not prove the limit {limit:R}";
        Double3 n = r.Normal;
        if (Math.Abs(n.Length - 1) > 1e-6) return $"normal {r.Normal}";
        var a = new Body<ConvexShape>(pair.A.Shape, pair.PoseA);
        var b = new Body<ConvexShape>(pair.B.Shape, pair.PoseB);
        double gap = Certificate.Gap(a, b, n * (1 / n.Length));
        return gap >= r.LowerBound - 2e-7 * (a.Radius + b.Radius + full.Distance)
            ? null
            : $"the plane separates by {gap:R}, the bound says {r.LowerBound:R}";
    });

    [Fact]
    public void WithinItTheAnswerIsTheFullOne() => Each((pair, full) =>
    {
        foreach (float limit
            in new[] { full.Distance * 1.001f, full.Distance * 4, float.MaxValue, float.PositiveInfinity })
        {
            DistanceResult r = pair.Distance(limit);
            if (r.Status != GjkStatus.Separated || r.Distance != full.Distance || r.PointA != full.PointA
                || r.Normal != full.Normal)
                return $"limit {limit:R}: {r.Status} {r.Distance:R}, without {full.Status} {full.Distance:R}";
        }

        return null;
    });

    [Fact]
    public void OverlapIsNeverBeyond()
    {
        for (ulong i = 0; i < (ulong)Budget.Count(200); i++)
        {
            TestPair pair = Generators.Pair(90_000 + i, Generators.AllKinds, 0.4);
            if (!pair.Distance().IsOverlapping) continue;
            foreach (float limit in new[] { 0f, -1f, float.NegativeInfinity, 1f })
                Assert.True(
                    pair.Distance(limit).IsOverlapping, $"limit {limit}: {pair.Distance(limit).Status}: {pair}");
        }
    }

    [Fact]
    public void BelowZeroCountsAsZero() => Each((pair, full) =>
    {
        GjkStatus zero = pair.Distance(0).Status, negative = pair.Distance(-5).Status;
        return zero == GjkStatus.BeyondMaxDistance && negative == zero
            ? null
            : $"{zero} at 0, {negative} at -5, distance {full.Distance:R}";
    });

    [Fact]
    public void NaNIsRefused()
    {
        DistanceResult r = ConvexQuery.Distance(
            new PointShape(), RigidPose.Identity, new PointShape(), new RigidPose(Vector3.One), float.NaN);
        Assert.Equal(GjkStatus.InvalidInput, r.Status);
    }

    private static bool IsNaN(Vector3 v) => float.IsNaN(v.X) && float.IsNaN(v.Y) && float.IsNaN(v.Z);

    private static void Each(Func<TestPair, DistanceResult, string?> examine)
    {
        int tried = 0;
        for (ulong i = 0; i < (ulong)Budget.Count(400); i++)
        {
            TestPair pair = Generators.Pair(91_000 + i, Generators.AllKinds, 1.5);
            DistanceResult full = pair.Distance();
            if (full.IsOverlapping || full.Distance < 1e-3f) continue;
            tried++;
            string? problem = examine(pair, full);
            Assert.True(problem is null, $"{problem}\n{pair}");
        }

        Assert.True(tried > 100);
    }
}
