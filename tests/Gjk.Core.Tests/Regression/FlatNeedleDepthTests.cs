namespace Gjk.Core.Tests.Regression;

/// <summary>Two equal segments that cross at a tiny angle have a difference that is flat, and a needle. The normal of a
/// triangle of it leaned along the needle, whose far corner was called the depth, up to 2e-9 of the size. Found by
/// fuzz.</summary>
public class FlatNeedleDepthTests
{
    private const string Mesh =
        "gjk1 mesh 6 0.208919361 -0.187607527 -0.537612975 0.313482851 -0.281504482 -0.806686521 0.319051713 "
        + "-0.286505282 -0.821016908 -0.0650214031 0.0583885759 0.167319804 0.331627369 -0.297798097 -0.853377879 "
        + "-0.0977668762 0.0877936855 0.251583844 @ 1.05250746E-10 0 0 1 0 3.66195096E-09 -1.4879058E-08 point 0 @ 0 "
        + "0 0 1 0.116930246 -0.105002202 -0.300897032";

    private const string Segments =
        "gjk1 segment -0.47777107357978821 -0.97365808486938477 0.34704557061195374 -0.56700128316879272 "
        + "0.26335343718528748 -0.3116355836391449 0 @ 2.7827996E-12 -2.7827996E-12 2.7827996E-12 1 0 0 "
        + "-1.15185639E-15 segment -0.47777107357978821 -0.97365808486938477 0.34704557061195374 "
        + "-0.56700128316879272 0.26335343718528748 -0.3116355836391449 0 @ 4.8668543E-08 0 0 1 1.87805327E-12 "
        + "1.72034487E-09 3.45646072E-08";

    [Theory]
    [InlineData(Mesh)]
    [InlineData(Segments)]
    public void WhatWasDeepIsFlat(string record)
    {
        QueryRecord pair = QueryRecord.Parse(record);
        DistanceResult r = ConvexQuery.SignedDistance(pair.A, pair.PoseA, pair.B, pair.PoseB);
        Assert.True(r.IsOverlapping && r.Distance >= -1e-14f, $"{r}");
    }

    [Fact]
    public void SegmentsThatCrossAreNoDeeperThanRounding()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(2000); seed++)
        {
            var rng = new Rng(77_000 + seed);
            Vector3 end = rng.UnitVector();
            var tilt = new RigidPose(
                new Quaternion(rng.UnitVector() * rng.LogFloat(1e-10, 1e-3), 1), end * (0.25f * rng.Below(3)));
            ConvexShape segment = ConvexShape.Segment(end, -end);
            DistanceResult r = ConvexQuery.SignedDistance(segment, RigidPose.Identity, segment, tilt);
            WarmStart warm = default;
            ConvexQuery.SignedDistance(segment, tilt, segment, RigidPose.Identity, ref warm);
            DistanceResult back = ConvexQuery.SignedDistance(segment, RigidPose.Identity, segment, tilt, ref warm);
            Assert.True(r.IsOverlapping && r.Distance >= -2e-14f, $"{r}: seed {seed}");
            Assert.True(back.IsOverlapping && back.Distance >= -2e-14f, $"warm {back}: seed {seed}");
        }
    }
}
