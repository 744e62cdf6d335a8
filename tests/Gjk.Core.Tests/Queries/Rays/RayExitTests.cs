namespace Gjk.Core.Tests.Queries.Rays;

/// <summary>Where rays leave, by hand and by the distance around the end; <see cref="RayAccuracyTests"/> compares exits
/// with a reference of 640 digits.</summary>
public class RayExitTests
{
    private static readonly RigidPose Here = RigidPose.Identity;

    /// <summary>Those that rays meet, and where a float is fine enough to step beyond.</summary>
    public static TheoryData<string> Kinds =>
    [
        .. Generators.AllKinds.Concat(Generators.LaterKinds).Except(["point", "segment", "needle"]),
        "bigHull", "made", "madeUneven",
    ];

    [Theory]
    [InlineData(5, 6)]
    [InlineData(1, 2)]
    [InlineData(0.5f, 1.5f)]
    [InlineData(-0.5f, 0.5f)]
    public void ABoxIsLeftOnItsFarFace(float z, float distance)
    {
        RayCastResult r = ConvexQuery.RayExit(
            new BoxShape(Vector3.One), Here, new Vector3(0.25f, 0.5f, z), new Vector3(0, 0, -3));
        Assert.Equal((CastStatus.Hit, distance, -Vector3.UnitZ), (r.Status, r.Distance, r.Normal));
        Assert.Equal(new Vector3(0.25f, 0.5f, -1), r.Point);
    }

    [Fact]
    public void ARayThatEndsInsideDoesNotLeave()
    {
        ConvexShape box = ConvexShape.Box(Vector3.One);
        Assert.Equal(CastStatus.Hit, End(6).Status);
        Assert.Equal((CastStatus.Miss, 5.9999995f), (End(5.9999995f).Status, End(5.9999995f).Distance));
        Assert.Equal(CastStatus.Miss, End(1).Status);
        Assert.Equal(CastStatus.Miss, End(-1).Status);
        Assert.Equal(CastStatus.Miss, ConvexQuery.RayExit(box, Here, new(0, 0, 5), Vector3.UnitZ).Status);
        Assert.Equal(CastStatus.Miss, ConvexQuery.RayExit(box, Here, new(0, 3, 5), -Vector3.UnitZ).Status);
        Assert.Equal(CastStatus.InvalidInput, ConvexQuery.RayExit(box, Here, default, default).Status);
        Assert.Equal(CastStatus.InvalidInput, ConvexQuery.RayExit(box, default, default, Vector3.UnitX).Status);
        Assert.Equal(
            CastStatus.InvalidInput, ConvexQuery.RayExit(box, Here, default, Vector3.UnitX, float.NaN).Status);

        RayCastResult End(float most) =>
            ConvexQuery.RayExit(box, Here, new Vector3(0, 0, 5), new Vector3(0, 0, -2), most);
    }

    /// <summary>What has no inside is left where it is met.</summary>
    [Fact]
    public void ATriangleIsLeftAtOnce()
    {
        var triangle = new TriangleShape(new Vector3(-1, 0, -1), new Vector3(1, 0, -1), new Vector3(0, 0, 1));
        RayCastResult r = ConvexQuery.RayExit(triangle, Here, new Vector3(0, 3, 0), new Vector3(0, -1, 0));
        Assert.Equal((CastStatus.Hit, 3f), (r.Status, r.Distance));
        Assert.Equal(-Vector3.UnitY, r.Normal);
    }

    [Fact]
    public void FromTheSurfaceARayEndsAtOnce()
    {
        RayCastResult r = ConvexQuery.RayExit(new BoxShape(Vector3.One), Here, Vector3.UnitX, Vector3.UnitX);
        Assert.Equal((CastStatus.Hit, 0f, Vector3.UnitX), (r.Status, r.Distance, r.Normal));
        ConvexShape floor = ConvexShape.HalfSpace(Vector3.UnitX, 1);
        Assert.Equal(CastStatus.Miss, ConvexQuery.RayExit(floor, Here, Vector3.UnitX, Vector3.UnitX).Status);
    }

    [Theory]
    [InlineData(3, -1, 2.5f)]
    [InlineData(3, 1, float.NaN)]
    [InlineData(-3, 1, float.NaN)]
    [InlineData(-3, -1, float.NaN)]
    public void AHalfSpaceIsLeftOnce(float y, float dy, float distance)
    {
        // Inside is what is above 0.5.
        ConvexShape above = ConvexShape.HalfSpace(-2 * Vector3.UnitY, -1);
        RayCastResult r = ConvexQuery.RayExit(above, Here, new Vector3(1, y, 2), new Vector3(0, dy, 0));
        Assert.Equal(float.IsNaN(distance) ? CastStatus.Miss : CastStatus.Hit, r.Status);
        if (r.Status == CastStatus.Miss) return;
        Assert.Equal((distance, new Vector3(1, 0.5f, 2), -Vector3.UnitY), (r.Distance, r.Point, r.Normal));
    }

    /// <summary>The end is on the surface, and beyond it the ray is outside; entry and exit change places with the
    /// direction.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void TheEndIsOnTheSurface(string kind)
    {
        int ends = 0;
        for (int i = 0; i < Budget.Count(120); i++)
        {
            var rng = new Rng((ulong)i);
            ConvexShape shape = Generators.Shape(rng, kind).Shape;
            RigidPose pose = Generators.Pose(rng, rng.Vector(-2, 2));
            float size = (float)(shape.BoundingRadius + shape.Margin);
            var center = (Vector3)(new RotationD(pose.Rotation).Rotate(shape.Center) + pose.Position);
            Vector3 origin = center + rng.UnitVector() * (size * rng.Float(0, 3));
            Vector3 direction = center + rng.UnitVector() * (size * rng.Float(0, 0.5)) - origin;
            if (direction == Vector3.Zero) continue;
            RayCastResult start = ConvexQuery.RayCast(shape, pose, origin, direction);
            RayCastResult end = ConvexQuery.RayExit(shape, pose, origin, direction);
            Assert.True(start.IsHit == (end.Status == CastStatus.Hit), $"{i}: {start}, {end}");
            if (!start.IsHit) continue;
            ends++;
            float error = 1e-6f * MathF.Max(size, end.Distance);
            Assert.True(end.Distance >= start.Distance, $"{i}: {start}, {end}");
            Assert.True(ConvexQuery.Distance(shape, pose, end.Point).Distance <= error, $"{i}: {end}");
            Vector3 beyond = end.Point + Vector3.Normalize(direction) * (1e-3f * size);
            Assert.False(ConvexQuery.Contains(shape, pose, beyond), $"{i}: {end}");
            Assert.True(Vector3.Dot(end.Normal, direction) >= -1e-3f * direction.Length(), $"{i}: {end}");
            RayCastResult back = ConvexQuery.RayCast(shape, pose, beyond, -direction);
            Assert.True(Math.Abs(back.Distance - 1e-3f * size) <= 4 * error, $"{i}: {end}, {back}");
        }

        Assert.InRange(ends, 40, int.MaxValue);
    }

    /// <summary>What a ball holds may be a speck in it, and the next float may lie beyond the shape.</summary>
    [Theory]
    [InlineData(1, 0)]
    [InlineData(1e12, 0)]
    [InlineData(1e16, 0)]
    [InlineData(1e100, 0)]
    [InlineData(1, 1e9f)]
    [InlineData(1e16, 1e9f)]
    public void NeitherAGenerousRadiusNorAFarPlaceMatters(double radius, float place)
    {
        var pose = new RigidPose(new Vector3(place, place, 0));
        RayCastResult r = ConvexQuery.RayExit(new Generous(radius), pose, pose.Position, Vector3.UnitX);
        Assert.Equal((CastStatus.Hit, 0.25f, Vector3.UnitX), (r.Status, r.Distance, r.Normal));
    }

    /// <summary>Nothing is thrown where what is beyond the shape is no float.</summary>
    [Fact]
    public void TheLargestBallIsLeft()
    {
        RayCastResult r = ConvexQuery.RayExit(ConvexShape.Sphere(2e38f), Here, Vector3.Zero, Vector3.UnitX);
        Assert.Equal((CastStatus.Hit, 2e38f), (r.Status, r.Distance));
    }

    [Fact]
    public void NothingIsAllocated()
    {
        ConvexShape custom = ConvexShape.Custom(new CylinderShape(1, 1)), hull = ConvexShape.Mesh(
            TestShape.Corners(Vector3.One));
        Assert.Equal(0, Allocation.Least(() =>
        {
            ConvexQuery.RayExit(custom, Here, new Vector3(0.1f, 0.2f, 5), -Vector3.UnitZ);
            ConvexQuery.RayExit(hull, Here, new Vector3(0.1f, 0.2f, 5), -Vector3.UnitZ);
        }));
    }

    /// <summary>A small cube that claims to need much room.</summary>
    private readonly struct Generous(double radius) : ISupportMap
    {
        private static readonly BoxShape Box = new(new Vector3(0.25f));

        public Double3 Center => default;

        public double Margin => 0;

        public double BoundingRadius => radius;

        public int Support(in Double3 direction, out Double3 point) => Box.Support(direction, out point);

        public void GetFace(in Double3 direction, ref FaceCorners corners) => Box.GetFace(direction, ref corners);

        public bool TryGetVertex(int id, out Double3 point) => Box.TryGetVertex(id, out point);
    }
}
