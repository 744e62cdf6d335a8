namespace Gjk.Core.Tests.Regression;

/// <summary>Absolute epsilons made small shapes overlap at a distance and large ones miss contact. Every tolerance is a
/// fraction of the pair here, from 1e-15 to 1e15 in size and a million to one.</summary>
public class SizeRatioTests
{
    [Theory]
    [InlineData(1e-15f)]
    [InlineData(1e-6f)]
    [InlineData(1f)]
    [InlineData(1e6f)]
    [InlineData(1e15f)]
    public void TheUnitOfLengthDoesNotMatter(float size)
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(60); seed++)
        {
            TestPair pair = Generators.Pair(
                220_000 + seed, ["hull", "box", "triangle", "sphere", "needle", "mirroredCapsule"]);
            if (pair.A.Text.Contains("Scaled") || pair.B.Text.Contains("Scaled")) continue;
            string? problem = OracleVerdict.Problem(pair.Resized(size), out _);
            Assert.True(problem is null, $"{problem}\n{pair.Resized(size)}");
        }
    }

    [Theory]
    [InlineData(1e-3f)]
    [InlineData(1e-6f)]
    public void AGrainBesideAMountainIsAnsweredExactly(float grain)
    {
        TestShape small = TestShape.Box(new Vector3(0.5f * grain));
        TestShape large = TestShape.Mesh(
            new(-1, 0, -1), new(1, 0, -1), new(-1, 0, 1), new(1, 0, 1), new(-1, -1, -1), new(1, -1, -1), new(-1, -1, 1),
            new(1, -1, 1));
        foreach (float gap in new[] { -0.25f, 0.5f, 1, 1000 })
        {
            for (ulong seed = 0; seed < (ulong)Budget.Count(30); seed++)
            {
                var rng = new Rng(seed);
                var pair = new TestPair(
                    $"seed {seed}, gap {gap}", large, RigidPose.Identity, small,
                    new RigidPose(new Vector3(rng.Float(-0.9, 0.9), grain * (0.5f + gap), rng.Float(-0.9, 0.9))));
                string? problem = OracleVerdict.Problem(pair, out ExactAnswer exact);
                Assert.True(problem is null, $"{problem}\n{pair}");
                Assert.Equal(gap < 0, exact.Overlap);
                Assert.Equal(gap < 0, pair.Distance().IsOverlapping);
            }
        }
    }
}
