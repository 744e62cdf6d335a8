namespace Gjk.Core.Tests.Regression;

/// <summary>Up to 7 % of the pairs of hulls ended at the iteration cap, without an answer, because the loop waited for
/// v to repeat to the last bit. It ends here when the bounds meet.</summary>
public class IterationCapTests
{
    [Theory]
    [InlineData(8)]
    [InlineData(32)]
    [InlineData(128)]
    [InlineData(512)]
    [InlineData(2048)]
    [InlineData(4096)]
    public void RandomHullsEndLongBeforeIt(int vertices)
    {
        var rng = new Rng((ulong)vertices);
        ConvexShape[] hulls =
        [
            .. Enumerable.Range(0, 4).Select(
                _ => ConvexShape.Mesh([.. Enumerable.Range(0, vertices).Select(_ => rng.UnitVector() * 0.5f)]))
        ];
        int overlaps = 0, most = 0, count = Budget.Count(1000);
        for (int i = 0; i < count; i++)
        {
            RigidPose a = Generators.Pose(rng, default);
            RigidPose b = Generators.Pose(rng, rng.UnitVector() * rng.Float(0.2, 1.6));
            DistanceResult r = ConvexQuery.Distance(hulls[i % 4], a, hulls[i / 4 % 4], b);
            Assert.True(r.Status is GjkStatus.Separated or GjkStatus.Overlapping, $"pair {i}: {r.Status}");
            most = Math.Max(most, r.Iterations);
            overlaps += r.IsOverlapping ? 1 : 0;
        }

        Assert.InRange(most, 3, 40);
        Assert.InRange(overlaps, 0.3 * count, 0.8 * count);
    }

    /// <summary>A needle of one to a million beside spheres of many corners: long thin simplices all the way.</summary>
    [Theory]
    [InlineData(1e-3f)]
    [InlineData(1e-4f)]
    [InlineData(1e-6f)]
    public void NeedlesEndToo(float thin)
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(300); seed++)
        {
            var rng = new Rng(seed);
            TestShape needle = TestShape.Mesh(Clouds.InBox(rng, 4 + rng.Below(9), new Vector3(1, thin, thin)));
            TestShape other = seed % 2 == 0 ? needle : TestShape.Mesh(Clouds.InBox(rng, 12, Vector3.One));
            var pair = new TestPair(
                $"seed {seed}", needle, Generators.Pose(rng, default), other,
                Generators.Pose(rng, rng.Vector(-0.5, 0.5)));
            string? problem = OracleVerdict.Problem(pair, out _);
            Assert.True(problem is null, $"{problem}\n{pair}");
            Assert.InRange(pair.Distance().Iterations, 1, 64);
        }
    }
}
