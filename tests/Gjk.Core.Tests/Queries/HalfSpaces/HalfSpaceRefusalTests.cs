namespace Gjk.Core.Tests.Queries;

/// <summary>What a half-space cannot be made of, and where it cannot be used.</summary>
public class HalfSpaceRefusalTests
{
    private static readonly ConvexShape Floor = ConvexShape.HalfSpace(Vector3.UnitY, 0);
    private static readonly ConvexShape Ball = ConvexShape.Sphere(1);

    [Fact]
    public void ItsNumbersAreChecked()
    {
        foreach (float x in new[] { float.NaN, float.PositiveInfinity, float.NegativeInfinity })
        {
            Refused("normal", "Every component must be finite.", () => ConvexShape.HalfSpace(new(0, x, 0), 0));
            Refused("offset", "Must be finite.", () => ConvexShape.HalfSpace(Vector3.UnitY, x));
        }

        Refused("normal", "Must not be zero.", () => ConvexShape.HalfSpace(Vector3.Zero, 1));
        Assert.Equal(Vector3.UnitX, ConvexShape.HalfSpace(new Vector3(float.Epsilon, 0, 0), 0).Normal);
        Assert.Equal(Vector3.UnitX, ConvexShape.HalfSpace(new Vector3(float.MaxValue, 0, 0), 0).Normal);
    }

    [Fact]
    public void TwoHalfSpacesHaveNoAnswer()
    {
        ConvexShape wall = ConvexShape.HalfSpace(Vector3.UnitX, 3);
        RigidPose here = RigidPose.Identity;
        Assert.Equal(GjkStatus.InvalidShape, ConvexQuery.Distance(Floor, here, wall, here).Status);
        Assert.Equal(GjkStatus.InvalidShape, ConvexQuery.SignedDistance(Floor, here, wall, here).Status);
        Assert.False(ConvexQuery.Overlaps(Floor, here, wall, here, out GjkStatus status));
        Assert.Equal(GjkStatus.InvalidShape, status);
        DistanceResult contact = ConvexQuery.Contacts(Floor, here, wall, here, 1, out ContactManifold manifold);
        Assert.Equal((GjkStatus.InvalidShape, 0), (contact.Status, manifold.Count));
        Assert.True(float.IsNaN(contact.Distance) && float.IsNaN(contact.PointA.X));
        Assert.Equal(
            CastStatus.InvalidShape, ConvexQuery.Cast(Floor, here, default, wall, here, Vector3.One).Status);
        var motion = new RigidMotion(here, Vector3.One, Vector3.One);
        Assert.Equal(CastStatus.InvalidShape, ConvexQuery.TimeOfImpact(Floor, motion, wall, motion).Status);
    }

    [Fact]
    public void InsideAnotherDecoratorItIsInvalidInput()
    {
        RigidPose here = RigidPose.Identity;
        Check(new Rounded<ConvexShape>(Floor, 1));
        Check(new Scaled<ConvexShape>(Floor, 2));
        Check(new Placed<ConvexShape>(Floor, new RigidPose(Vector3.One)));

        void Check<T>(T shape)
            where T : struct, ISupportMap
        {
            Assert.Equal(GjkStatus.InvalidInput, ConvexQuery.Distance(shape, here, Ball, here).Status);
            Assert.Equal(GjkStatus.InvalidInput, ConvexQuery.SignedDistance(Ball, here, shape, here).Status);
            Assert.False(ConvexQuery.Overlaps(shape, here, Ball, here, out GjkStatus status));
            Assert.Equal(GjkStatus.InvalidInput, status);
            Assert.Equal(CastStatus.InvalidInput, ConvexQuery.Cast(shape, here, default, Ball, here, default).Status);
            Assert.Equal(
                CastStatus.InvalidInput, ConvexQuery.RayCast(shape, here, Vector3.One, Vector3.UnitX).Status);
        }
    }

    [Fact]
    public void WrongPosesAndShapesAreInvalidInput()
    {
        RigidPose here = RigidPose.Identity;
        Assert.Equal(GjkStatus.InvalidInput, ConvexQuery.Distance(Floor, default, Ball, here).Status);
        Assert.Equal(GjkStatus.InvalidInput, ConvexQuery.Distance(Floor, here, Ball, default).Status);
        ConvexShape none = default;
        Assert.Equal(GjkStatus.InvalidInput, ConvexQuery.SignedDistance(none, here, Floor, here).Status);
        ConvexQuery.Overlaps(Floor, here, none, here, out GjkStatus status);
        Assert.Equal(GjkStatus.InvalidInput, status);
        Assert.Equal(CastStatus.InvalidInput, ConvexQuery.Cast(Floor, default, default, Ball, here, default).Status);
        var motion = new RigidMotion(here, Vector3.One, Vector3.One);
        Assert.Equal(CastStatus.InvalidInput, ConvexQuery.TimeOfImpact(Floor, default, Ball, motion).Status);
    }

    [Fact]
    public void ItIsNoPartOfACompound()
    {
        ArgumentException refused = Assert.Throws<ArgumentException>(
            () => new CompoundPart(Floor, RigidPose.Identity));
        Assert.Equal("shape", refused.ParamName);
        Assert.StartsWith("A half-space has no end, and cannot be a part.", refused.Message);
    }

    [Fact]
    public void ARecordBringsItBack()
    {
        ConvexShape plane = ConvexShape.HalfSpace(new Vector3(1, 2, 3), 0.1f)
            .Placed(new RigidPose(new Rng(3).Rotation(), new Vector3(1e5f, 0.3f, 7))).Rounded(0.1f);
        var at = new RigidPose(new Vector3(4, 5, 6));
        QueryRecord record = new(plane, RigidPose.Identity, Ball, at);
        QueryRecord read = QueryRecord.Parse(record.ToString());
        Assert.Equal(plane, read.A);
        Assert.True(ResultBits.AreSame(
            ConvexQuery.SignedDistance(plane, RigidPose.Identity, Ball, at),
            ConvexQuery.SignedDistance(read.A, RigidPose.Identity, Ball, at)));
    }

    private static void Refused(string name, string message, Func<object> make)
    {
        ArgumentOutOfRangeException refused = Assert.Throws<ArgumentOutOfRangeException>(() => make());
        Assert.Equal(name, refused.ParamName);
        Assert.StartsWith(message, refused.Message);
    }

    /// <summary>Two half-spaces have no distance, so neither is near the other, and what is near is found.</summary>
    [Fact]
    public void AHalfSpaceIsNotNearAnother()
    {
        var scene = new CollisionScene();
        int wall = scene.Add(ConvexShape.HalfSpace(Vector3.UnitX, -6), RigidPose.Identity);
        Assert.False(scene.TryFindNearest(Floor, RigidPose.Identity, out PairDistance nearest));
        Assert.Equal(-1, nearest.Pair.B);
        int ball = scene.Add(ConvexShape.Sphere(1), new RigidPose(new Vector3(0, 5, 0)));
        Assert.True(scene.TryFindNearest(Floor, RigidPose.Identity, out nearest));
        Assert.Equal(ball, nearest.Pair.B);
        Assert.True(scene.TryFindNearest(scene.Add(Floor, RigidPose.Identity), out nearest));
        Assert.Equal(ball, nearest.Pair.B);
        var found = new List<PairDistance>();
        scene.FindDistances(Floor, RigidPose.Identity, float.PositiveInfinity, found);
        Assert.Equal([ball], found.Select(p => p.Pair.B));
        scene.FindDistances(ConvexShape.Sphere(1), RigidPose.Identity, float.PositiveInfinity, found);
        Assert.Contains(wall, found.Select(p => p.Pair.B));
    }
}
