using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests.Queries;

/// <summary>Contract 6: the lower bound never exceeds the true distance, and is as near it as the distance is promised to be.</summary>
public class LowerBoundTests
{
    /// <summary>From distances where a float's last place is far below the noise of double arithmetic to those where it is far above.</summary>
    [Fact]
    public void ItIsProvedAndClosed()
    {
        int apart = 0;
        for (ulong seed = 0; seed < (ulong)Budget.Count(4000); seed++)
        {
            TestPair pair = Generators.NearPair(95_000 + seed, Generators.PolytopeKinds, new Rng(seed).LogFloat(1e-9, 1));
            DistanceResult r = pair.Distance();
            if (r.Status != GjkStatus.Separated) continue;
            apart++;
            double truth = pair.Exact().Distance;
            Assert.True(r.LowerBound <= truth, $"bound {r.LowerBound:R}, truly {truth:R}\n{pair}");
            Assert.True(r.Distance - (double)r.LowerBound <= Tolerance.Band(r.Distance, pair.Scale), $"bound {r.LowerBound:R}, distance {r.Distance:R}\n{pair}");
        }

        Assert.True(apart > 1000);
    }

    /// <summary>The bound of these two, a point of contact but for a tilt, was two places of a float below the distance, where 1e-14 of the scale is less than that. Found by fuzz.</summary>
    [Fact]
    public void ItIsClosedWhereAFloatsLastPlaceIsAsSmallAsRounding()
    {
        Assert.True(QueryRecord.TryParse(
            "gjk1 triangle 0 0 0.6 0 0 0 -0 0 -0 @ 0 0 0 1 0 0 0 triangle -0.49 0.601445 0.584888 0 0 0 -0 0 -0 @ 0 0.000809799996 0 1 -5.17561993E-08 -2.30400001E-08 -2.71837468E-08",
            out QueryRecord record, out string? reason), reason);
        DistanceResult r = ConvexQuery.Distance(record.A, record.PoseA, record.B, record.PoseB);
        Assert.Equal(GjkStatus.Separated, r.Status);
        Assert.True(r.Distance - (double)r.LowerBound <= Tolerance.Band(r.Distance, 0.6014), $"bound {r.LowerBound:R}, distance {r.Distance:R}");
    }
}
