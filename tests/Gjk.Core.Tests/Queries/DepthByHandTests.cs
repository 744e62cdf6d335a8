namespace Gjk.Core.Tests.Queries;

/// <summary>Depths that can be worked out by hand, ties and shapes without an inside included.</summary>
public class DepthByHandTests
{
    private static readonly Quaternion Tilted = Quaternion.CreateFromYawPitchRoll(0.3f, -0.7f, 1.1f);

    [Theory]
    [InlineData(1.9f, 0, 0, 0.1f, 1, 0, 0)]
    [InlineData(0, -1.5f, 0, 0.5f, 0, -1, 0)]
    [InlineData(0.25f, 0.5f, 1.75f, 0.25f, 0, 0, 1)]
    public void TwoCubes(float x, float y, float z, float depth, float nx, float ny, float nz)
    {
        var cube = new BoxShape(Vector3.One);
        DistanceResult r = ConvexQuery.SignedDistance(
            cube, RigidPose.Identity, cube, new RigidPose(new Vector3(x, y, z)));
        Assert.Equal(GjkStatus.Overlapping, r.Status);
        Assert.Equal(-depth, r.Distance, 1e-6f);
        Assert.Equal(new Vector3(nx, ny, nz), r.Normal);
        Assert.InRange((r.PointB - r.PointA - r.Normal * r.Distance).Length(), 0, 1e-6f);
        Assert.True(r.LowerBound <= r.Distance);
    }

    /// <summary>All six directions cost the same: the first one found stays, and it is one of them.</summary>
    [Fact]
    public void ACubeInItself()
    {
        var cube = new BoxShape(Vector3.One);
        DistanceResult r = ConvexQuery.SignedDistance(cube, RigidPose.Identity, cube, RigidPose.Identity);
        Assert.Equal(-2, r.Distance);
        Assert.Equal(1, Math.Abs(r.Normal.X) + Math.Abs(r.Normal.Y) + Math.Abs(r.Normal.Z));
        DistanceResult again = ConvexQuery.SignedDistance(cube, RigidPose.Identity, cube, RigidPose.Identity);
        Assert.Equal(r.Normal, again.Normal);
    }

    [Fact]
    public void TwoSpheres()
    {
        var ball = new SphereShape(1);
        DistanceResult r = ConvexQuery.SignedDistance(
            ball, new RigidPose(Tilted, default), new SphereShape(2), new RigidPose(new Vector3(0, 0.5f, 0)));
        Assert.Equal(-2.5f, r.Distance);
        Assert.Equal(Vector3.UnitY, r.Normal);
        Assert.Equal(Vector3.UnitY, r.PointA);
        Assert.Equal(new Vector3(0, -1.5f, 0), r.PointB);
    }

    [Fact]
    public void SpheresAboutOneCentreHaveADirection()
    {
        DistanceResult r = ConvexQuery.SignedDistance(
            new SphereShape(1), RigidPose.Identity, new SphereShape(2), RigidPose.Identity);
        Assert.Equal((-3f, GjkStatus.Overlapping, 1f), (r.Distance, r.Status, r.Normal.Length()));
        Assert.Equal(r.PointA - 3 * r.Normal, r.PointB);
    }

    /// <summary>The cores cross in one point; both radii are left, across both axes.</summary>
    [Fact]
    public void CapsulesThatCross()
    {
        var capsule = new CapsuleShape(0.5f, 2);
        var lying = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 2);
        DistanceResult r = ConvexQuery.SignedDistance(
            capsule, RigidPose.Identity, capsule, new RigidPose(lying, default));
        Assert.Equal(-1, r.Distance, 1e-6f);
        Assert.Equal(1, Math.Abs(r.Normal.Z), 1e-6f);
        DistanceResult apart = ConvexQuery.SignedDistance(
            capsule, RigidPose.Identity, capsule, new RigidPose(lying, new Vector3(0, 0, 0.25f)));
        Assert.Equal(-0.75f, apart.Distance, 1e-6f);
        Assert.Equal(Vector3.UnitZ, apart.Normal);
    }

    /// <summary>A segment leaves another in the same line sideways, at no cost but the radii.</summary>
    [Fact]
    public void CapsulesInOneLine()
    {
        var capsule = new CapsuleShape(0.5f, 2);
        DistanceResult r = ConvexQuery.SignedDistance(
            capsule, RigidPose.Identity, capsule, new RigidPose(new Vector3(0, 1, 0)));
        Assert.Equal(-1, r.Distance, 1e-6f);
        Assert.Equal(0, r.Normal.Y, 1e-6f);
        Assert.Equal(1, r.Normal.Length(), 1e-6f);
    }

    [Fact]
    public void TrianglesInOnePlane()
    {
        var triangle = new TriangleShape(Vector3.Zero, Vector3.UnitX, Vector3.UnitY);
        DistanceResult r = ConvexQuery.SignedDistance(
            triangle, new RigidPose(Tilted, default), triangle, new RigidPose(Tilted, default));
        Assert.Equal((0f, GjkStatus.Overlapping), (r.Distance, r.Status));
        Vector3 across = Vector3.Transform(Vector3.UnitZ, Tilted);
        Assert.Equal(1, Math.Abs(Vector3.Dot(across, r.Normal)), 1e-6f);
    }

    [Fact]
    public void SegmentsAndPointsThatTouchHaveADirection()
    {
        var segment = new SegmentShape(-Vector3.UnitX, Vector3.UnitX);
        var across = new SegmentShape(-Vector3.UnitY, Vector3.UnitY);
        DistanceResult crossing = ConvexQuery.SignedDistance(
            segment, RigidPose.Identity, across, RigidPose.Identity);
        Assert.Equal((0f, GjkStatus.Overlapping), (crossing.Distance, crossing.Status));
        Assert.Equal(1, Math.Abs(crossing.Normal.Z));
        DistanceResult same = ConvexQuery.SignedDistance(segment, RigidPose.Identity, segment, RigidPose.Identity);
        Assert.Equal((0f, 0f, 1f), (same.Distance, same.Normal.X, same.Normal.Length()));
        DistanceResult points = ConvexQuery.SignedDistance(
            new PointShape(), RigidPose.Identity, new PointShape(), RigidPose.Identity);
        Assert.Equal((0f, 1f), (points.Distance, points.Normal.Length()));
    }

    [Fact]
    public void ACubeOnACubeTouchesWithTheNormalOfTheFace()
    {
        var cube = new BoxShape(Vector3.One);
        DistanceResult r = ConvexQuery.SignedDistance(
            cube, RigidPose.Identity, cube, new RigidPose(new Vector3(0.25f, 2, 0.5f)));
        Assert.Equal((0f, GjkStatus.Overlapping), (r.Distance, r.Status));
        Assert.Equal(Vector3.UnitY, r.Normal);
    }

    [Fact]
    public void ACylinderInABall()
    {
        DistanceResult r = ConvexQuery.SignedDistance(
            new CylinderShape(0.5f, 2), RigidPose.Identity, new SphereShape(0.25f),
            new RigidPose(new Vector3(0.375f, 0, 0)));
        Assert.Equal(-0.375f, r.Distance, 2.5e-6f);
        Assert.InRange(Vector3.Dot(r.Normal, Vector3.UnitX), 0.999, 1.001);
    }

    [Fact]
    public void AnInvalidPoseIsInvalid()
    {
        DistanceResult r = ConvexQuery.SignedDistance(
            new BoxShape(Vector3.One), default, new BoxShape(Vector3.One), RigidPose.Identity);
        Assert.Equal((GjkStatus.InvalidInput, true), (r.Status, float.IsNaN(r.Distance)));
        Assert.Equal(
            GjkStatus.InvalidInput,
            ConvexQuery.SignedDistance(default(ConvexShape), RigidPose.Identity, new SphereShape(1), default).Status);
    }
}
