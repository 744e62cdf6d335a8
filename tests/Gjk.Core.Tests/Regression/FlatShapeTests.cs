namespace Gjk.Core.Tests.Regression;

/// <summary>Flat and straight shapes gave NaN or no answer, because the barycentric weights of a simplex without area
/// or volume divide 0 by 0. Weights of degenerate simplices fall back to their edges and corners here, and what is flat
/// is a hull like any other.</summary>
public class FlatShapeTests
{
    [Fact]
    public void CoplanarSquaresHaveTheDistanceOfTheirEdges()
    {
        ConvexShape square = ConvexShape.Mesh([new(-1, 0, -1), new(1, 0, -1), new(-1, 0, 1), new(1, 0, 1)]);
        for (int i = 0; i <= 40; i++)
        {
            float x = i * 0.125f;
            DistanceResult r = ConvexQuery.Distance(
                square, RigidPose.Identity, square, new RigidPose(new Vector3(x, 0, 0.5f)));
            Assert.Equal(Math.Max(0, x - 2), r.Distance);
            Assert.Equal(x <= 2, r.IsOverlapping);
        }
    }

    [Fact]
    public void ParallelSquaresHaveTheirHeight()
    {
        ConvexShape square = ConvexShape.Mesh([new(-1, 0, -1), new(1, 0, -1), new(-1, 0, 1), new(1, 0, 1)]);
        foreach (float height in new[] { 1e-30f, 1e-15f, 1e-9f, 1e-3f, 1, 1e9f })
        {
            DistanceResult r = ConvexQuery.Distance(
                square, RigidPose.Identity, square, new RigidPose(new Vector3(0.25f, height, 0.5f)));
            Assert.Equal(height > 1e-14f ? height : 0, r.Distance);
        }
    }

    [Fact]
    public void CrossedSegmentsInOnePlaneTouchAndCollinearOnesHaveTheirGap()
    {
        ConvexShape along = ConvexShape.Segment(new(-1, 0, 0), new(1, 0, 0));
        ConvexShape across = ConvexShape.Segment(new(0, 0, -1), new(0, 0, 1));
        Assert.True(
            ConvexQuery.Distance(
                along, RigidPose.Identity, across, new RigidPose(new Vector3(0.5f, 0, 0.5f))).IsOverlapping);
        Assert.True(
            ConvexQuery.Distance(along, RigidPose.Identity, across, new RigidPose(new Vector3(1, 0, 1))).IsOverlapping);
        Assert.Equal(
            0.5f,
            ConvexQuery.Distance(along, RigidPose.Identity, across, new RigidPose(new Vector3(1.5f, 0, 1))).Distance);
        Assert.Equal(
            1f, ConvexQuery.Distance(along, RigidPose.Identity, along, new RigidPose(new Vector3(3, 0, 0))).Distance);
        Assert.True(
            ConvexQuery.Distance(along, RigidPose.Identity, along, new RigidPose(new Vector3(2, 0, 0))).IsOverlapping);
        Assert.True(ConvexQuery.Distance(along, RigidPose.Identity, along, RigidPose.Identity).IsOverlapping);
    }

    [Fact]
    public void TrianglesWithoutAreaAreSegmentsAndPoints()
    {
        var p = new Vector3(1, 2, 3);
        Assert.Equal(
            5,
            ConvexQuery.Distance(
                ConvexShape.Triangle(p, p, p), RigidPose.Identity, ConvexShape.Point(),
                new RigidPose(new Vector3(1, 5, -1))).Distance);
        ConvexShape straight = ConvexShape.Triangle(new(-1, 0, 0), new(1, 0, 0), new(0.5f, 0, 0));
        Assert.Equal(
            2,
            ConvexQuery.Distance(
                straight, RigidPose.Identity, straight, new RigidPose(new Vector3(0.5f, 2, 0))).Distance);
    }

    [Fact]
    public void FlatHullsInAllPosesHaveTheExactAnswer()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(300); seed++)
        {
            TestPair pair = Generators.Pair(200_000 + seed, ["flat", "triangle", "segment", "point"], 0.5);

            // Half of them in one plane.
            var inPlane = new RigidPose(pair.PoseB.Position * new Vector3(1, 0, 1));
            if (seed % 2 == 0) pair = pair with { PoseA = RigidPose.Identity, PoseB = inPlane };
            DistanceResult r = pair.Distance();
            Assert.True(new[] { r.Distance, r.PointA.X, r.PointB.Y, r.Normal.Z }.All(float.IsFinite), pair.ToString());
            string? problem = OracleVerdict.Problem(pair, out _);
            Assert.True(problem is null, $"{problem}\n{pair}");
        }
    }
}
