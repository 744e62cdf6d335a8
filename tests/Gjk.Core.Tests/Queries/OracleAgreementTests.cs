namespace Gjk.Core.Tests.Queries;

/// <summary>Random pairs of polytopes against the exact oracle.</summary>
public class OracleAgreementTests
{
    [Theory]
    [InlineData(1000)]
    [InlineData(2000)]
    public void RandomPairsAgree(ulong seed)
    {
        int count = Budget.Count(150), hits = 0;
        for (ulong i = 0; i < (ulong)count; i++)
        {
            TestPair pair = Generators.Pair(seed + i, [.. Generators.PolytopeKinds, "bigHull", "hull", "hull"], 0.8);
            string? problem = OracleVerdict.Problem(pair, out ExactAnswer exact);
            Assert.True(problem is null, $"{problem}\n{pair}");
            if (exact.Overlap) hits++;
        }

        Assert.InRange(hits, 0.3 * count, 0.7 * count);
    }

    [Theory]
    [InlineData(1e-3)]
    [InlineData(1e-5)]
    [InlineData(1e-7)]
    [InlineData(0)]
    [InlineData(-1e-7)]
    [InlineData(-1e-5)]
    [InlineData(-1e-3)]
    public void NearlyTouchingPairs(double gap)
    {
        for (ulong i = 0; i < (ulong)Budget.Count(60); i++)
        {
            TestPair pair = Generators.NearPair(5000 + i, [.. Generators.PolytopeKinds, "bigHull"], gap);
            string? problem = OracleVerdict.Problem(pair, out _);
            Assert.True(problem is null, $"{problem}\n{pair}");
        }
    }

    /// <summary>Each against its like and against random hulls: overlapping, apart, and a gap of any size.</summary>
    [Theory]
    [InlineData(21_000)]
    [InlineData(22_000)]
    public void MeshesAsPeopleMakeThem(ulong seed)
    {
        int count = Budget.Count(200), hits = 0;
        for (ulong i = 0; i < (ulong)count; i++)
        {
            TestPair pair = Generators.MadePair(seed + i, i % 3 == 0 ? new Rng(i).LogFloat(1e-9, 10) : null);
            string? problem = OracleVerdict.Problem(pair, out ExactAnswer exact);
            Assert.True(problem is null, $"{problem}\n{pair}");
            if (exact.Overlap) hits++;
        }

        Assert.InRange(hits, 0.2 * count, 0.6 * count);
    }

    [Theory]
    [InlineData(1e-15)]
    [InlineData(1e-6)]
    [InlineData(1e6)]
    [InlineData(1e15)]
    public void PairsOfAnySizeAgree(double size)
    {
        for (ulong i = 0; i < (ulong)Budget.Count(40); i++)
        {
            TestPair pair = Generators.Pair(
                7000 + i, ["hull", "flat", "needle", "segment", "box"], 1.5).Resized((float)size);
            string? problem = OracleVerdict.Problem(pair, out _);
            Assert.True(problem is null, $"{problem}\n{pair}");
        }
    }

    [Theory]
    [InlineData(1e3)]
    [InlineData(1e6)]
    public void PairsOfVeryDifferentSizeAgree(double ratio)
    {
        for (ulong i = 0; i < (ulong)Budget.Count(60); i++)
        {
            var rng = new Rng(8000 + i);
            TestShape large = Generators.Shape(rng, "hull").Scaled(new((float)ratio));
            TestShape small = Generators.Shape(rng, "hull");
            RigidPose poseA = Generators.Pose(rng, rng.Vector(-1, 1)), turned = Generators.Pose(rng, default);
            Double3 n = rng.UnitVector();
            double reach = new Body<ConvexShape>(large.Shape, poseA).Height(n) + rng.Range(-1, 1);
            var pair = new TestPair(
                $"seed {8000 + i}", large, poseA, small,
                new RigidPose(turned.Rotation, (System.Numerics.Vector3)(n * reach)));
            string? problem = OracleVerdict.Problem(pair, out _);
            Assert.True(problem is null, $"{problem}\n{pair}");
        }
    }
}
