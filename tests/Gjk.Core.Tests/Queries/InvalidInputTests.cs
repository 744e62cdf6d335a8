namespace Gjk.Core.Tests.Queries;

/// <summary>Contract 2: a default struct or a NaN that slips in gives InvalidInput and nothing but NaN.</summary>
public class InvalidInputTests
{
    private static readonly RigidPose Apart = new(new Vector3(5, 0, 0));

    [Fact]
    public void ADefaultPoseIsInvalid()
    {
        AssertInvalid(new SphereShape(1), default, new SphereShape(1), Apart);
        AssertInvalid(new SphereShape(1), RigidPose.Identity, new BoxShape(Vector3.One), default);
    }

    [Fact]
    public void ADefaultConvexShapeIsInvalid()
    {
        AssertInvalid(default(ConvexShape), RigidPose.Identity, new SphereShape(1), Apart);
        AssertInvalid(new SphereShape(1), RigidPose.Identity, default(ConvexShape), Apart);
        AssertInvalid(default(ConvexShape), RigidPose.Identity, default(ConvexShape), RigidPose.Identity);
    }

    [Fact]
    public void ADefaultMeshIsInvalid()
    {
        AssertInvalid(default(ConvexMesh), RigidPose.Identity, new SphereShape(1), Apart);
        AssertInvalid(new BoxShape(Vector3.One), RigidPose.Identity, default(ConvexMesh), RigidPose.Identity);
    }

    [Fact]
    public void ADefaultScaledShapeIsInvalid() =>
        AssertInvalid(default(Scaled<BoxShape>), RigidPose.Identity, new SphereShape(1), Apart);

    [Fact]
    public void APoseThatWasOverwrittenWithNaNIsInvalid()
    {
        AssertInvalid(
            new SphereShape(1), Forge(new Quaternion(float.NaN, 0, 0, 1), default), new SphereShape(1), Apart);
        AssertInvalid(
            new SphereShape(1), Forge(Quaternion.Identity, new Vector3(0, float.NaN, 0)), new SphereShape(1), Apart);
        AssertInvalid(
            new BoxShape(Vector3.One), Forge(Quaternion.Identity, new Vector3(0, 0, float.PositiveInfinity)),
            new SphereShape(1), Apart);
        AssertInvalid(new BoxShape(Vector3.One), Forge(new Quaternion(0, 0, 0, 2), default), new SphereShape(1), Apart);
    }

    [Fact]
    public void DefaultPrimitivesArePointsAtTheirOrigin()
    {
        // Zero sizes are legal, so these are not mistakes that anyone could tell from intent.
        Assert.Equal(
            5, ConvexQuery.Distance(default(BoxShape), RigidPose.Identity, default(SphereShape), Apart).Distance);
        Assert.Equal(
            5, ConvexQuery.Distance(default(CapsuleShape), RigidPose.Identity, default(SegmentShape), Apart).Distance);
    }

    /// <summary>What no constructor lets through, as memory read from elsewhere would bring it in.</summary>
    private static RigidPose Forge(Quaternion rotation, Vector3 position)
    {
        Span<float> floats = [rotation.X, rotation.Y, rotation.Z, rotation.W, position.X, position.Y, position.Z];
        return System.Runtime.InteropServices.MemoryMarshal.Cast<float, RigidPose>(floats)[0];
    }

    private static void AssertInvalid<TA, TB>(in TA a, in RigidPose poseA, in TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        DistanceResult r = ConvexQuery.Distance(a, poseA, b, poseB);
        Assert.Equal(GjkStatus.InvalidInput, r.Status);
        Assert.False(r.IsOverlapping);
        foreach (float x
            in new[] { r.Distance, r.LowerBound, r.PointA.X, r.PointB.Y, r.Normal.Z, r.LocalPointA.X, r.LocalPointB.X })
        {
            Assert.True(float.IsNaN(x));
        }
        Assert.Equal(GjkStatus.InvalidInput, ConvexQuery.Distance(a, poseA, b, poseB, 1f).Status);
        Assert.False(ConvexQuery.Overlaps(a, poseA, b, poseB));
        Assert.False(ConvexQuery.Overlaps(a, poseA, b, poseB, out GjkStatus status));
        Assert.Equal(GjkStatus.InvalidInput, status);
    }
}
