namespace Gjk.Core.Tests.Regression;

/// <summary>An edge whose facets are turned by more than a right angle against each other. The end of its arc was not
/// found then, and the ways out across it were left out: depths of flat bipyramids about one centre were 1e-3 too
/// large.</summary>
public class SharpEdgeArcTests
{
    [Theory]
    [InlineData(37, 1.7856321f)]
    [InlineData(41, 1.78623f)]
    [InlineData(45, 1.7866756f)]
    public void BipyramidsInEitherOrder(int sides, float depth)
    {
        ConvexShape bipyramid = ConvexShape.Mesh(Ring(sides, 0, Vector3.UnitY, -Vector3.UnitY));
        ConvexShape flat = bipyramid.Scaled(new(1, 0.5f, 1)), high = bipyramid.Scaled(new(1, 2, 1));
        foreach ((ConvexShape a, ConvexShape b) in new[] { (flat, high), (high, flat) })
        {
            DistanceResult r = ConvexQuery.SignedDistance(a, RigidPose.Identity, b, RigidPose.Identity);
            Assert.Equal(GjkStatus.Overlapping, r.Status);
            Assert.Equal(-depth, r.Distance, 2e-7f);
        }
    }

    [Fact]
    public void ConesOfManySidesAgreeInEitherOrder()
    {
        for (int sides = 36; sides < 90; sides += 7)
        {
            ConvexShape cone = ConvexShape.Mesh(Ring(sides, -1, Vector3.UnitY));
            ConvexShape high = cone.Scaled(new(1, 2, 1));
            var turned = new RigidPose(new Quaternion(0, 0.5f, 0, 0.8660254f), default);
            DistanceResult r = ConvexQuery.SignedDistance(high, RigidPose.Identity, cone, turned);
            DistanceResult s = ConvexQuery.SignedDistance(cone, turned, high, RigidPose.Identity);
            Assert.True(Math.Abs(r.Distance - s.Distance) <= 3e-7, $"{sides} sides: {r} and {s}");
        }
    }

    private static ConvexHull Ring(int sides, float height, params Vector3[] tips)
    {
        var points = new List<Vector3>(tips);
        for (int i = 0; i < sides; i++)
        {
            float t = 2 * MathF.PI * i / sides;
            points.Add(new Vector3(MathF.Cos(t), height, MathF.Sin(t)));
        }

        return new ConvexHull(points.ToArray());
    }
}
