namespace Gjk.Core.Tests.Regression;

/// <summary>Rounded shapes whose cores touch exactly: depth and normal were right, but the deepest points were those of
/// any part of the facet. And shapes a hundred million times larger than the other, of which the normal was
/// zero.</summary>
public class TouchingCoreDepthTests
{
    private static readonly ConvexShape Box = ConvexShape.Box(new Vector3(2));

    [Fact]
    public void ABallWhoseCentreIsOnAFace()
    {
        DistanceResult r = Ask(Box, ConvexShape.Sphere(1), new RigidPose(new Vector3(-2, -1.5f, 1)));
        Assert.Equal((-1f, new Vector3(-1, 0, 0)), (r.Distance, r.Normal));
        Assert.Equal((new Vector3(-2, -1.5f, 1), new Vector3(-1, -1.5f, 1)), (r.PointA, r.PointB));
    }

    [Fact]
    public void ACapsuleWhoseEndIsOnAFace()
    {
        DistanceResult r = Ask(Box, ConvexShape.Capsule(0.5f, 0.5f), new RigidPose(new Vector3(-1.5f, -2, -2)));
        Assert.Equal((-0.5f, -2f, -1.5f), (r.Distance, r.PointA.Z, r.PointB.Z));
        Assert.Equal((-1.5f, -1.5f), (r.PointA.X, r.PointB.X));
        Assert.InRange(r.PointA.Y, -2, -1.5f);
    }

    [Fact]
    public void ARoundedBoxOnABox()
    {
        DistanceResult r = Ask(
            ConvexShape.Box(new Vector3(2, 1, 2)), ConvexShape.Box(new Vector3(1, 2, 2)).Rounded(0.125f),
            new RigidPose(new Vector3(-2, 3, 2.5f)));
        Assert.Equal((-0.125f, Vector3.UnitY), (r.Distance, r.Normal));
        Assert.InRange(r.PointA.X, -2, -1);
        Assert.InRange(r.PointA.Z, 0.5f, 2);
    }

    [Theory]
    [InlineData(1e8f)]
    [InlineData(1e9f)]
    public void ACapsuleThatIsManyTimesLarger(float size)
    {
        var pose = new RigidPose(new(0.398131996f, 0.281014383f, 0.256906539f, 0.834578276f), default);
        DistanceResult r = Ask(ConvexShape.Box(Vector3.One), ConvexShape.Capsule(size, size), pose);
        Assert.Equal(1, r.Normal.Length(), 1e-6f);
        Assert.InRange(r.Distance, -size - 2, -size);
    }

    /// <summary>The depth of a slender cone is only known to 1e-6 of its length: whether it overlaps is for the
    /// distance to say.</summary>
    [Fact]
    public void ASlenderConeBesideABox()
    {
        var cone = new ConeShape(1, 594.99963f);
        var box = new BoxShape(Vector3.One);
        var pose = new RigidPose(new Vector3(1.29850805f, -1.7058779f, 1.4039501f));
        Assert.Equal(
            ConvexQuery.Distance(cone, RigidPose.Identity, box, pose).Status,
            ConvexQuery.SignedDistance(cone, RigidPose.Identity, box, pose).Status);
    }

    /// <summary>The clipping of one by the other must not forget a side of length 0.</summary>
    [Fact]
    public void TwoFlatBoxes()
    {
        ConvexShape flat = ConvexShape.Box(new Vector3(1, 1, 0));
        var pose = new RigidPose(
            new(0.5f, -0.5f, 0.5f, 0.5f), new Vector3(-0.000112228248f, -0.999992728f, -0.999878109f));
        DistanceResult r = Ask(flat, flat, pose);
        Assert.Equal((-7.2717667E-06f, -Vector3.UnitY), (r.Distance, r.Normal));
        Assert.InRange(r.PointA.Z, -1e-6f, 1e-6f);

        var upright = new RigidPose(
            new(0.707106769f, 0, 0, 0.707106769f), new Vector3(-1.007725f, 0.997264564f, -0.000126044164f));
        r = Ask(flat, flat, upright);
        Assert.Equal(Vector3.UnitY, r.Normal);
        Assert.InRange(r.PointA.Z, -1e-6f, 1e-6f);
        Assert.InRange(r.PointA.X, -1, -0.0077f);
    }

    [Fact]
    public void AnEllipsoidAboutAPoint()
    {
        DistanceResult r = Ask(
            ConvexShape.Ellipsoid(new Vector3(0.25f, 0.5f, 0.75f)), ConvexShape.Point(), RigidPose.Identity);
        Assert.Equal(-0.25f, r.Distance, 1e-6f);
        Assert.InRange(r.PointB.Length(), 0, 1.5e-6f);
    }

    /// <summary>They are 3.7e-11 apart, which counts as touching for a curved core; the bound was that gap, above the
    /// distance.</summary>
    [Fact]
    public void ATouchHasNoBoundAboveIt()
    {
        const string Text = "gjk1 cylinder 0 0.50270295143127441 0 @ 0 0 0 1 0 -3.12499999E-08 0 "
            + "point 1.2937690331734757 @ 0 0 0 1 0 1.79647195 0";
        Assert.True(QueryRecord.TryParse(Text, out QueryRecord pair, out _));
        DistanceResult r = ConvexQuery.SignedDistance(pair.A, pair.PoseA, pair.B, pair.PoseB);
        Assert.Equal((true, 0f), (r.IsOverlapping, r.Distance));
        Assert.InRange(r.LowerBound, -1e-6f, 0);
    }

    private static DistanceResult Ask(in ConvexShape a, in ConvexShape b, in RigidPose poseB) =>
        ConvexQuery.SignedDistance(a, RigidPose.Identity, b, poseB);
}
