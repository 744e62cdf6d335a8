namespace Gjk.Core.Tests.Regression;

/// <summary>1e5 from the world's origin distances were wrong by more than the gap, because world coordinates were
/// rounded to float (a unit in the last place is 0.008 there) before they were subtracted. Here the difference of the
/// positions is taken first, in double.</summary>
public class FarFromTheOriginTests
{
    [Theory]
    [InlineData(1e3f)]
    [InlineData(1e4f)]
    [InlineData(1e5f)]
    [InlineData(1e7f)]
    public void BoxesHaveTheGapOfTheirPositions(float away)
    {
        var a = new RigidPose(new Vector3(away, -away, away * 0.5f));
        for (int i = 0; i < 20; i++)
        {
            // The position that a float can hold nearest to the wanted gap: its own distance is exact.
            float x = away + 1 + i * 0.01f, gap = (float)Math.Max(0, (double)x - away - 1);
            DistanceResult r = ConvexQuery.Distance(
                new BoxShape(new Vector3(0.5f)), a, new BoxShape(new Vector3(0.5f)),
                new RigidPose(new Vector3(x, -away, away * 0.5f)));
            Assert.Equal(gap, r.Distance);
            Assert.Equal(gap == 0, r.IsOverlapping);
        }
    }

    [Fact]
    public void TurnedHullsHaveTheExactAnswer()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(200); seed++)
        {
            TestPair near = Generators.Pair(210_000 + seed, ["hull", "box", "capsule", "needle"]);
            Vector3 away = new Rng(seed).UnitVector() * 1e5f;
            var far = near with
            {
                PoseA = new RigidPose(near.PoseA.Rotation, near.PoseA.Position + away),
                PoseB = new RigidPose(near.PoseB.Rotation, near.PoseB.Position + away),
            };
            string? problem = OracleVerdict.Problem(far, out _);
            Assert.True(problem is null, $"{problem}\n{far}");
        }
    }

    /// <summary>There a float holds the world's points to 0.008 only; in the shapes' own frames they are as good as
    /// anywhere.</summary>
    [Fact]
    public void TheLocalPointsKeepTheirDigits()
    {
        var away = new Vector3(1e5f, 2e5f, -1e5f);
        DistanceResult r = ConvexQuery.Distance(
            new SphereShape(0.125f), new RigidPose(away), new BoxShape(new Vector3(0.25f)),
            new RigidPose(away + new Vector3(1, 0, 0)));
        Assert.Equal(0.625f, r.Distance);
        Assert.Equal(new Vector3(0.125f, 0, 0), r.LocalPointA);
        Assert.Equal(-0.25f, r.LocalPointB.X);
    }
}
