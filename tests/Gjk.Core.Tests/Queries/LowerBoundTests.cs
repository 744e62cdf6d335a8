namespace Gjk.Core.Tests.Queries;

/// <summary>Contract 6: the lower bound never exceeds the true distance, and is as near it as the distance is promised
/// to be.</summary>
public class LowerBoundTests
{
    /// <summary>From distances where a float's last place is far below the noise of double arithmetic to those where it
    /// is far above.</summary>
    [Fact]
    public void ItIsProvedAndClosed()
    {
        int apart = 0;
        for (ulong seed = 0; seed < (ulong)Budget.Count(4000); seed++)
        {
            TestPair pair = Generators.NearPair(
                95_000 + seed, Generators.PolytopeKinds, new Rng(seed).LogFloat(1e-9, 1));
            DistanceResult r = pair.Distance();
            if (r.Status != GjkStatus.Separated) continue;
            apart++;
            double truth = pair.Exact().Distance;
            Assert.True(r.LowerBound <= truth, $"bound {r.LowerBound:R}, truly {truth:R}\n{pair}");
            Assert.True(
                r.Distance - (double)r.LowerBound <= Accuracy.Band(r.Distance, pair.Scale),
                $"bound {r.LowerBound:R}, distance {r.Distance:R}\n{pair}");
        }

        Assert.True(apart > 1000);
    }

    /// <summary>Points of contact but for a tilt, found by fuzz. The first one's bound was two places of a float below
    /// the distance, where 1e-14 of the scale is less than that; the second walk ended a step early, since measured
    /// from a far corner the next triangle's distance differed from the last one's by less than 106 bits.</summary>
    [Theory]
    [InlineData(
        "gjk1 triangle 0 0 0.6 0 0 0 -0 0 -0 @ 0 0 0 1 0 0 0 triangle -0.49 0.601445 0.584888 0 0 0 -0 0 -0 "
        + "@ 0 0.000809799996 0 1 -5.17561993E-08 -2.30400001E-08 -2.71837468E-08", 0.6014)]
    [InlineData(
        "gjk1 mesh 3 0 0 0 0 0 -1 -0.200000003 0.200000003 1 @ 0 0 0 1 0 0 0 mesh 4 0 0 0 0 1 -0.25 0 0.5 0.5 0.5 "
        + "-1 1 @ 1.67049151E-07 -1.67049151E-07 1.67049151E-07 1 5.83000011E-13 0 0", 2)]
    public void ItIsClosedWhereAFloatsLastPlaceIsAsSmallAsRounding(string text, double scale)
    {
        Assert.True(QueryRecord.TryParse(text, out QueryRecord record, out string? reason), reason);
        DistanceResult r = ConvexQuery.Distance(record.A, record.PoseA, record.B, record.PoseB);
        Assert.Equal(GjkStatus.Separated, r.Status);
        Assert.True(
            r.Distance - (double)r.LowerBound <= Accuracy.Band(r.Distance, scale),
            $"bound {r.LowerBound:R}, distance {r.Distance:R}");
    }
}
