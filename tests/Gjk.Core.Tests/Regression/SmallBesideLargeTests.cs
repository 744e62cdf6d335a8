namespace Gjk.Core.Tests.Regression;

/// <summary>Parts that are tiny beside others are found however the others are measured.</summary>
public class SmallBesideLargeTests
{
    /// <summary>In units of the large triangle the product of two gaps has no digits left as a float, which must not
    /// make it larger.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(1.5)]
    [InlineData(100)]
    public void ALimitAtTheDistanceChangesNothing(float factor)
    {
        Vector3[] corners =
        [
            new(0.30814448f, -0.14017351f, -0.8038461f), new(0.30814448f, -0.14017351f, -0.8038461f),
            new(0.3134914f, -0.1179574f, -0.7888305f), new(79335.26f, -70957.016f, 15336.242f),
            new(33897.34f, -16444.354f, 185164.78f), new(89405.625f, -115082f, -177499.02f),
        ];
        Vector3[] small =
        [
            new(0.00056944916f, -0.0005479192f, 0.0005583259f), new(0.0005801798f, -0.00055829115f, 0.00055042194f),
            new(0.00057895324f, -0.00055210246f, 0.00055844896f),
        ];
        AnyShape a = AnyShape.Surface(new TriangleMesh(corners, [0, 1, 2, 3, 4, 5]));
        AnyShape b = AnyShape.Surface(new TriangleMesh(small, [0, 1, 2]));
        var poseA = new RigidPose(new Quaternion(0.60322845f, 0.11828859f, -0.7663441f, -0.1866549f), default);
        var poseB = new RigidPose(
            new Quaternion(-0.40004098f, 0.2521666f, 0.88014644f, 0.041490704f),
            new Vector3(0.7181847f, 0.20556337f, -0.42037326f));
        var scratch = new ConcaveScratch();
        PairDistance whole = ConcaveQuery.Distance(a, poseA, b, poseB, scratch);
        PairDistance within = ConcaveQuery.Distance(a, poseA, b, poseB, scratch, whole.Distance * factor);
        Assert.Equal((GjkStatus.Separated, whole.Distance, 0), (within.Status, within.Distance, within.PartA));
    }

    /// <summary>A curved part that is as near as the query calls touching overlaps, and so it has a depth.</summary>
    [Fact]
    public void ACurvedPartThatTouchesHasADepth()
    {
        TriangleMesh mesh = new([Vector3.Zero, new(0, 0.75f, 0), new(0, 0, 0.75f)], [0, 1, 2]);
        AnyShape wall = AnyShape.Surface(mesh);
        var at = new RigidPose(new Vector3(1.05e-9f, 0.25f, 0.25f));
        ConvexShape egg = ConvexShape.Ellipsoid(new Vector3(1e-9f));
        ConvexShape triangle = ConvexShape.Triangle(Vector3.Zero, new(0, 0.75f, 0), new(0, 0, 0.75f));
        Assert.True(ConvexQuery.Distance(triangle, RigidPose.Identity, egg, at).IsOverlapping);
        AnyShape parts = AnyShape.Of(new CompoundShape([new CompoundPart(egg, RigidPose.Identity)]));
        List<PairDistance> found = [];
        var scratch = new ConcaveScratch();
        Assert.True(ConcaveQuery.FindDepths(wall, RigidPose.Identity, parts, at, scratch, found));
        Assert.Single(found);
        Assert.True(ConcaveQuery.FindPairsWithin(wall, RigidPose.Identity, parts, at, 0, scratch, found));
        Assert.Single(found);
    }

    /// <summary>Of parts that are met at nearly one fraction, hardly after the start, the first is found.</summary>
    [Theory]
    [InlineData(0, 1, 2, 3, 4, 5)]
    [InlineData(3, 4, 5, 0, 1, 2)]
    public void ACastMeetsTheFirstOfNearlyEqualParts(params int[] triangles)
    {
        Vector3[] corners =
        [
            new(-0.5190659f, 0.60626423f, 0.7379608f),
            new(-0.55023104f, 0.59933937f, 0.7249388f),
            new(-0.5187459f, 0.61786866f, 0.7160264f),
        ];
        Vector3[] blade =
        [
            new(-1.216308f, 0, 6.456924e-07f),
            new(-1.1425326f, 2.4800136e-07f, 6.065278e-07f),
            new(-1.216308f, 0, -6.456924e-07f),
            new(-1.216308f, 0, 6.456924e-07f),
            new(-1.216308f, 0, -6.456924e-07f),
            new(-1.1425326f, -2.4800136e-07f, -6.065278e-07f),
        ];
        ConvexShape a = ConvexShape.Triangle(corners[0], corners[1], corners[2]);
        var poseA = new RigidPose(new Quaternion(2.4593837E-07f, 0, 0, 1), default);
        var poseB = new RigidPose(
            new Quaternion(0, 1.4162699E-08f, 0, 1), new Vector3(0.6975621f, 0.6178683f, 0.7160273f));
        Vector3 way = new(-0.10874378f, -0.1762235f, -0.005313715f);
        float least = float.PositiveInfinity;
        for (int i = 0; i < 6; i += 3)
        {
            ConvexShape b = ConvexShape.Triangle(
                blade[triangles[i]], blade[triangles[i + 1]], blade[triangles[i + 2]]);
            least = MathF.Min(least, ConvexQuery.Cast(a, poseA, default, b, poseB, way).Fraction);
        }

        AnyShape surface = AnyShape.Surface(new TriangleMesh(blade, triangles));
        CastHit found = ConcaveQuery.Cast(
            AnyShape.Of(a), poseA, default, surface, poseB, way, new ConcaveScratch());
        Assert.Equal((CastStatus.Hit, least), (found.Status, found.Fraction));
    }
}
