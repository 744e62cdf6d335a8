namespace Gjk.Core.Tests.Queries.Rays;

/// <summary>Rays by hand, their refusals, and what all ways to ask have in common.</summary>
public class RayCastTests
{
    private static readonly RigidPose Here = RigidPose.Identity;

    public static TheoryData<string> Kinds =>
        [.. Generators.AllKinds, .. Generators.LaterKinds, "bigHull", "made", "madeFarOff", "madeUneven"];

    [Theory]
    [InlineData(0, 0, 4)]
    [InlineData(0.5f, -0.5f, 4)]
    [InlineData(1, 0, 4)]
    [InlineData(1, 1, 4)]
    public void ABoxIsHitOnItsFace(float x, float z, float distance)
    {
        RayCastResult r = ConvexQuery.RayCast(
            new BoxShape(Vector3.One), Here, new Vector3(x, 5, z), new Vector3(0, -1e-3f, 0));
        Assert.Equal((CastStatus.Hit, distance, Vector3.UnitY), (r.Status, r.Distance, r.Normal));
        Assert.Equal(new Vector3(x, 1, z), r.Point);

        Assert.Equal(0, r.Iterations);
    }

    [Fact]
    public void TheEndOfTheRayIsClosed()
    {
        Assert.Equal(CastStatus.Hit, Cast(4).Status);
        Assert.Equal((CastStatus.Miss, 3.9999995f), (Cast(3.9999995f).Status, Cast(3.9999995f).Distance));
        Assert.Equal((CastStatus.Miss, 0f), (Cast(-1).Status, Cast(-1).Distance));
        Assert.Equal(CastStatus.Miss, Cast(0).Status);

        // The end is a float that the double on the way to the face may exceed by rounding.
        for (int i = 0; i < 200; i++)
        {
            var rng = new Rng((ulong)i);
            var sphere = new SphereShape(rng.Float(0.1, 1));
            Vector3 origin = rng.UnitVector() * 3;
            float all = ConvexQuery.RayCast(sphere, Here, origin, -origin).Distance;
            CastStatus before = ConvexQuery.RayCast(sphere, Here, origin, -origin, all * (1 - 1e-6f)).Status;
            CastStatus beyond = ConvexQuery.RayCast(sphere, Here, origin, -origin, all * (1 + 1e-6f)).Status;
            Assert.True((before, beyond) == (CastStatus.Miss, CastStatus.Hit), $"seed {i}");
        }

        static RayCastResult Cast(float most) => ConvexQuery.RayCast(
            ConvexShape.Box(Vector3.One), Here, new Vector3(0, 5, 0), new Vector3(0, -3, 0), most);
    }

    /// <summary>From the surface, along a face, an edge, away from it, and in; and from the inside.</summary>
    [Theory]
    [InlineData(1, 0, 0, 1, 0, 0, CastStatus.Miss)]
    [InlineData(1, 0, 0, 0, 1, 0, CastStatus.Miss)]
    [InlineData(1, 1, 0, 0, 0, 1, CastStatus.Miss)]
    [InlineData(1, 1, 1, 1, 1, 1, CastStatus.Miss)]
    [InlineData(1, 1, 0, -1, 1e-3f, 1, CastStatus.Miss)]
    [InlineData(1, 1, 0, -1, -1e-3f, 1, CastStatus.Hit)]
    [InlineData(1, 0, 0, -1, 5, 0, CastStatus.Hit)]
    [InlineData(0.2f, 0.3f, -0.4f, 1, 1, 1, CastStatus.OverlappingAtStart)]
    public void AnOriginOnTheSurfaceGoesInOrMisses(
        float x, float y, float z, float dx, float dy, float dz, CastStatus status)
    {
        Vector3 origin = new(x, y, z), direction = new(dx, dy, dz);
        var mesh = ConvexShape.Mesh(TestShape.Corners(Vector3.One));
        foreach (ConvexShape shape in new[] { ConvexShape.Box(Vector3.One), mesh })
        {
            RayCastResult r = ConvexQuery.RayCast(shape, Here, origin, direction);
            Assert.Equal(status, r.Status);
            if (!r.IsHit) continue;
            Assert.Equal((0f, origin), (r.Distance, r.Point));
            Assert.Equal(status == CastStatus.Hit ? 0 : 0.6f, r.Depth);
            if (status == CastStatus.Hit) Assert.True(Vector3.Dot(r.Normal, direction) < 0, $"{r}");
            else Assert.Equal(-Vector3.UnitZ, r.Normal);
        }
    }

    /// <summary>What slides along a face hits the edge that it runs into; a hair above it, it misses.</summary>
    [Fact]
    public void ASlideIsClosed()
    {
        foreach (ConvexShape shape in new[] { ConvexShape.Box(Vector3.One), ConvexShape.Cylinder(1, 1) })
        {
            RayCastResult flush = ConvexQuery.RayCast(shape, Here, new Vector3(-5, 1, 0), Vector3.UnitX);
            Assert.Equal((CastStatus.Hit, 4f), (flush.Status, flush.Distance));
            RayCastResult above = ConvexQuery.RayCast(shape, Here, new Vector3(-5, 1.0000001f, 0), Vector3.UnitX);
            Assert.Equal(CastStatus.Miss, above.Status);
        }
    }

    [Fact]
    public void FlatShapesAreHit()
    {
        Vector3 origin = new(0.1f, 3, 0.2f), down = new(0, -2, 0);
        foreach (ConvexShape shape in new[]
        {
            ConvexShape.Box(new(1, 0, 1)), ConvexShape.Cylinder(1, 0), ConvexShape.Ellipsoid(new(1, 0, 1)),
            ConvexShape.Triangle(new(-1, 0, -1), new(3, 0, -1), new(-1, 0, 3)),
            ConvexShape.Mesh([new(-1, 0, -1), new(3, 0, -1), new(-1, 0, 3)]),
        })
        {
            RayCastResult r = ConvexQuery.RayCast(shape, Here, origin, down);
            Assert.True(r.Status == CastStatus.Hit && Math.Abs(r.Distance - 3) < 1e-6, $"{shape}: {r}");
            Assert.True(((Double3)r.Normal - Vector3.UnitY).Length < 1e-5, $"{shape}: {r}");
        }

        RayCastResult point = ConvexQuery.RayCast(new PointShape(), Here, new(0, 2, 0), new(0, -4, 0));
        Assert.Equal(CastStatus.Hit, point.Status);
        Assert.Equal(CastStatus.Hit, ConvexQuery.RayCast(
            new SegmentShape(new(-1, 0, 0), new(1, 0, 0)), Here, new(0, 2, 0), -Vector3.UnitY).Status);
        var triangle = ConvexShape.Triangle(new(-1, 0, -1), new(3, 0, -1), new(-1, 0, 3));
        Assert.Equal(CastStatus.Hit, ConvexQuery.RayCast(triangle, Here, new(-5, 0, 0), Vector3.UnitX).Status);
    }

    [Fact]
    public void BadInputIsInvalid()
    {
        Vector3 from = new(0, 5, 0), down = -Vector3.UnitY, bad = new(0, float.NaN, 0);
        var box = ConvexShape.Box(Vector3.One);
        foreach (RayCastResult r in new[]
        {
            ConvexQuery.RayCast(box, Here, from, Vector3.Zero), ConvexQuery.RayCast(box, Here, from, bad),
            ConvexQuery.RayCast(box, Here, from, new Vector3(float.PositiveInfinity, 0, 0)),
            ConvexQuery.RayCast(box, Here, bad, down), ConvexQuery.RayCast(box, default, from, down),
            ConvexQuery.RayCast(box, Here, from, down, float.NaN),
            ConvexQuery.RayCast(default(ConvexShape), Here, from, down),
            ConvexQuery.RayCast(default(ConvexMesh), Here, from, down),
            ConvexQuery.RayCast(default(Scaled<SphereShape>), Here, from, down),
            ConvexQuery.RayCast(default(Placed<SphereShape>), Here, from, down),
            ConvexQuery.RayCast(new SphereShape(1), default, from, down),
            ConvexQuery.RayCast(new SphereShape(1), Here, from, bad),
        })
        {
            Assert.Equal(CastStatus.InvalidInput, r.Status);
            Assert.True(float.IsNaN(r.Distance) && float.IsNaN(r.Point.X) && float.IsNaN(r.Normal.X) && !r.IsHit);
        }
    }

    [Theory]
    [InlineData(1e-38f, 1e-30f)]
    [InlineData(1e38f, 1e-30f)]
    [InlineData(1e-38f, 1e30f)]
    [InlineData(1e38f, 1e30f)]
    [InlineData(1e-45f, 1)]
    public void AnyLengthOfTheDirectionAndAnySizeWillDo(float length, float size)
    {
        foreach (ConvexShape shape in new[]
        {
            ConvexShape.Sphere(size), ConvexShape.Box(new(size)), ConvexShape.Cylinder(size, size),
            ConvexShape.Capsule(size * 0.5f, size * 0.5f), ConvexShape.Ellipsoid(new(size)),
            ConvexShape.Cylinder(size * 0.5f, size * 0.5f).Rounded(size * 0.5f),
        })
        {
            RayCastResult r = ConvexQuery.RayCast(shape, Here, new(0, 3 * size, 0), new(0, -length, 0), 2.5f * size);
            Assert.True(r.Status == CastStatus.Hit, $"{shape}: {r}");
            Assert.Equal(2, r.Distance / size, 1e-6f);
            Assert.Equal(1, r.Normal.Y, 1e-6f);
        }
    }

    /// <summary>A user's shape has no closed form; what is cast and what is computed agree.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void TheClosedFormAgreesWithTheCast(string kind)
    {
        int hits = 0, count = Budget.Count(200);
        for (int i = 0; i < count; i++)
        {
            TestPair p = Generators.Pair((ulong)(500 + i), [kind, "point"], 1);
            TestShape shape = p.A.Shape.Kind == ShapeKind.Point ? p.B : p.A;
            var rng = new Rng((ulong)i);
            Vector3 center = (Vector3)(new RotationD(p.PoseA.Rotation).Rotate(shape.Shape.Center) + p.PoseA.Position);
            Vector3 origin = center + rng.UnitVector() * (float)shape.LongestSide * rng.Float(0.2, 20);
            Vector3 direction = center + rng.Vector(-0.3, 0.3) * (float)shape.LongestSide - origin;
            RayCastResult r = ConvexQuery.RayCast(shape.Shape, p.PoseA, origin, direction);
            RayCastResult cast = ConvexQuery.RayCast(
                new SupportCounter(shape.Shape, new int[1]), p.PoseA, origin, direction);
            string text = $"seed {i}: {shape} at {TestShape.T(p.PoseA)} from {origin} along {direction}: {r}, {cast}";
            Assert.True(r.Status == cast.Status, text);
            if (r.Status != CastStatus.Hit) continue;
            hits++;
            Assert.True(Math.Abs(r.Distance - cast.Distance) <= 2e-7 * Math.Max(shape.LongestSide, r.Distance), text);
            Assert.True(((Double3)r.Point - cast.Point).Length <= 1e-6 * (shape.LongestSide + origin.Length()), text);
        }

        Assert.True(hits > 0.05 * count || kind is "point" or "segment" or "needle", $"{hits} hits");
    }

    /// <summary>An origin counts as in the shape where the shape contains it, by more than touching: there the ray hits
    /// at 0 or misses.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void TheStartIsWhatContainsSays(string kind)
    {
        for (int i = 0; i < Budget.Count(200); i++)
        {
            var rng = new Rng((ulong)(9000 + i));
            TestShape shape = Generators.Shape(rng, kind);
            RigidPose pose = Generators.Pose(rng, rng.Vector(-1, 1));
            Vector3 out1 = rng.UnitVector() * 100 * (float)(shape.LongestSide + shape.Shape.Center.Length);
            Vector3 surface = ConvexQuery.ClosestPoint(shape.Shape, pose, out1);
            foreach (float way in new[] { 0, 1e-3f, -1e-3f })
            {
                Vector3 origin = surface + (out1 - surface) * way;
                bool isIn = ConvexQuery.Contains(shape.Shape, pose, origin);
                RayCastResult r = ConvexQuery.RayCast(shape.Shape, pose, origin, rng.UnitVector());
                float depth = -ConvexQuery.SignedDistance(shape.Shape, pose, origin).Distance;
                bool isDeep = depth > 1e-6 * shape.LongestSide, isInside = r.Status == CastStatus.OverlappingAtStart;
                Assert.True(
                    isInside ? isIn : !isDeep && (!isIn || r.Status == CastStatus.Miss || r.Distance == 0),
                    $"seed {9000 + i}: {shape} at {TestShape.T(pose)}, {origin}: {isIn}, {depth:R}, {r}");
            }
        }
    }

    [Fact]
    public void APointThatIsCastIsARay()
    {
        for (int i = 0; i < 300; i++)
        {
            TestPair p = Generators.Pair((ulong)i, ["sphere", "box", "cylinder", "cone", "hull"], 2);
            Vector3 motion = (p.PoseA.Position - p.PoseB.Position) * 2;
            CastResult cast = ConvexQuery.Cast(p.A.Shape, p.PoseA, default, new PointShape(), p.PoseB, motion);
            CastResult closed = ConvexQuery.Cast(p.A.Shape, p.PoseA, default, ConvexShape.Point(), p.PoseB, motion);
            CastResult swapped = ConvexQuery.Cast(
                new PointShape(), p.PoseB, motion, p.A.Shape, p.PoseA, default).Swapped;
            RayCastResult ray = ConvexQuery.RayCast(p.A.Shape, p.PoseA, p.PoseB.Position, motion, motion.Length());
            Assert.Equal((cast.Status, cast.Fraction, cast.Normal), (closed.Status, closed.Fraction, closed.Normal));
            Assert.Equal((cast.Status, cast.Fraction), (swapped.Status, swapped.Fraction));
            Assert.Equal(cast.Depth, swapped.Depth, 1e-6f * (float)p.Scale);
            if (cast.Status == CastStatus.Hit) Assert.Equal(cast.Normal, swapped.Normal);
            Assert.True(ray.Status == cast.Status, $"seed {i}: {p}: {ray}, {cast}");
            if (ray.Status == CastStatus.Hit) Assert.Equal(ray.Distance, cast.Fraction * motion.Length(), 1e-5f);
        }
    }

    [Fact]
    public void NothingIsAllocated()
    {
        string[] kinds = [.. Generators.AllKinds, "bigHull", "made"];
        TestShape[] shapes = [.. kinds.Select((k, i) => Generators.Shape(new Rng((ulong)i), k))];
        var placed = new Placed<Scaled<ConeShape>>(
            new Scaled<ConeShape>(new ConeShape(1, 1), new Vector3(1, 2, 3)), new RigidPose(Vector3.One));
        Action work = () =>
        {
            foreach (TestShape s in shapes)
            {
                ConvexQuery.RayCast(s.Shape, Here, new(3, 4, 5), new(-3, -4, -5));
                ConvexQuery.Contains(s.Shape, Here, new(0.1f));
                ConvexQuery.ClosestPoint(s.Shape, Here, new(0.1f));
                ConvexQuery.SignedDistance(s.Shape, Here, new Vector3(0.1f));
            }

            ConvexQuery.RayCast(placed, Here, new(3, 4, 5), new(-3, -4, -5));
            ConvexQuery.RayCast(new Rounded<SphereShape>(new SphereShape(1), 1), Here, new(3, 4, 5), new(-3, -4, -5));
        };
        Assert.Equal(0, Allocation.Least(work));
    }
}
