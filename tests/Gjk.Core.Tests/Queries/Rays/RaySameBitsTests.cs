namespace Gjk.Core.Tests.Queries.Rays;

/// <summary>However a shape is written, a ray gets the same bits from it.</summary>
public class RaySameBitsTests
{
    private static readonly Vector3 Uneven = new(0.7f, -1.3f, 2.1f), Half = new(0.6f, 0.9f, 0.4f);

    [Fact]
    public void TypedShapesAndConvexShapeAgree()
    {
        Same(new SphereShape(0.7f), ConvexShape.Sphere(0.7f));
        Same(new CapsuleShape(0.4f, 0.7f), ConvexShape.Capsule(0.4f, 0.7f));
        Same(new BoxShape(Half), ConvexShape.Box(Half));
        Same(new CylinderShape(0.4f, 0.7f), ConvexShape.Cylinder(0.4f, 0.7f));
        Same(new ConeShape(0.4f, 0.7f), ConvexShape.Cone(0.4f, 0.7f));
        Same(new EllipsoidShape(Half), ConvexShape.Ellipsoid(Half));
        Same(new TaperedCapsuleShape(0.4f, 0.2f, 0.7f), ConvexShape.TaperedCapsule(0.4f, 0.2f, 0.7f));
        Same(new TaperedCapsuleShape(0.4f, 0.4f, 0.7f), ConvexShape.Capsule(0.4f, 0.7f));
        Vector3 a = new(-1, 0.1f, 0.2f), b = new(0.9f, 0.8f, 0), c = new(0.1f, -0.8f, 1);
        Same(new TriangleShape(a, b, c), ConvexShape.Triangle(a, b, c));
        Same(new SegmentShape(a, b), ConvexShape.Segment(a, b));
        Same(new Rounded<SegmentShape>(new SegmentShape(a, b), 0.3f), ConvexShape.Segment(a, b).Rounded(0.3f));
        var hull = new ConvexHull(Clouds.InBox(new Rng(1), 32, Vector3.One));
        Same(new ConvexMesh(hull), ConvexShape.Mesh(hull));
        Same(new Scaled<ConvexMesh>(new ConvexMesh(hull), Uneven), ConvexShape.Mesh(hull).Scaled(Uneven));
        var box = new ConvexHull(TestShape.Corners(Half));
        Same(new ConvexMesh(box), ConvexShape.Mesh(box));
        Same(new Scaled<ConvexMesh>(new ConvexMesh(box), Uneven), ConvexShape.Mesh(box).Scaled(Uneven));
    }

    [Fact]
    public void DecoratorsAgree()
    {
        var pose = new RigidPose(Quaternion.Normalize(new(0.1f, 0.5f, -0.3f, 0.7f)), new(0.3f, -0.2f, 0.1f));
        Same(new Scaled<SphereShape>(new SphereShape(0.7f), Uneven), ConvexShape.Sphere(0.7f).Scaled(Uneven));
        Same(new Scaled<BoxShape>(new BoxShape(Half), Uneven), ConvexShape.Box(Half).Scaled(Uneven));
        Same(
            new Scaled<CapsuleShape>(new CapsuleShape(0.4f, 0.7f), Uneven),
            ConvexShape.Capsule(0.4f, 0.7f).Scaled(Uneven));
        Same(
            new Scaled<CapsuleShape>(new CapsuleShape(0.4f, 0.7f), -0.7f),
            ConvexShape.Capsule(0.4f, 0.7f).Scaled(new(-0.7f)));
        Same(
            new Placed<Scaled<ConeShape>>(new Scaled<ConeShape>(new ConeShape(0.5f, 0.8f), Uneven), pose),
            ConvexShape.Cone(0.5f, 0.8f).Scaled(Uneven).Placed(pose));
        Same(
            new Rounded<Placed<SphereShape>>(new Placed<SphereShape>(new SphereShape(0.5f), pose), 0.2f),
            ConvexShape.Sphere(0.5f).Placed(pose).Rounded(0.2f));
        Same(
            new Placed<BoxShape>(new BoxShape(Half), pose), ConvexShape.Box(Half).Placed(pose));
        Same(new Rounded<BoxShape>(new BoxShape(Half), 0.1f), ConvexShape.Box(Half).Rounded(0.1f));
        Same(
            new Rounded<Scaled<CylinderShape>>(new Scaled<CylinderShape>(new CylinderShape(0.4f, 0.7f), Uneven), 0.1f),
            ConvexShape.Cylinder(0.4f, 0.7f).Scaled(Uneven).Rounded(0.1f));
    }

    /// <summary>Plain balls and boxes have a way of their own, and what is written otherwise has not; also along faces,
    /// where that way hands over.</summary>
    [Fact]
    public void PlainBodiesAgreeWithOthersOfTheirForm()
    {
        Same(new SphereShape(0.7f), ConvexShape.Point().Rounded(0.7f));
        Same(ConvexShape.Sphere(0.7f), ConvexShape.Point().Rounded(0.7f));
        Same(new BoxShape(Half), ConvexShape.Mesh(new ConvexHull(TestShape.Corners(Half))));
        Same(ConvexShape.Box(Half), ConvexShape.Mesh(new ConvexHull(TestShape.Corners(Half))));
    }

    private static void Same<T>(T typed, ConvexShape shape)
        where T : struct, ISupportMap
    {
        int hits = 0;
        for (int i = 0; i < 200; i++)
        {
            var rng = new Rng((ulong)i);
            RigidPose pose = Generators.Pose(rng, rng.Vector(-1, 1));
            Vector3 origin = pose.Position + rng.UnitVector() * rng.LogFloat(0.3, 1e4);
            Vector3 direction = pose.Position + rng.Vector(-0.3, 0.3) - origin;
            if (i % 4 == 0)
            {
                Vector3 corner = Vector3.Transform(Half * (float)rng.Range(0.9, 1.1), pose.Rotation);
                direction = Vector3.Transform(i % 8 == 0 ? Vector3.UnitX : Vector3.UnitZ, pose.Rotation);
                origin = pose.Position + (i % 3 == 0 ? corner : rng.Vector(-0.3, 0.3)) - 2 * direction;
            }

            RayCastResult a = ConvexQuery.RayCast(typed, pose, origin, direction);
            RayCastResult b = ConvexQuery.RayCast(shape, pose, origin, direction);
            Assert.True(
                a.Status == b.Status && (a.Iterations == b.Iterations || a.Depth > 0)
                && Bits(a.Depth) == Bits(b.Depth) && Bits(a.Distance) == Bits(b.Distance)
                && Bits(a.Point) == Bits(b.Point) && Bits(a.Normal) == Bits(b.Normal),
                $"seed {i}: {typeof(T)} {a}, {shape} {b}");
            if (a.Status == CastStatus.Hit) hits++;
        }

        Assert.True(hits > 20 || shape.Kind == ShapeKind.Segment, $"{typeof(T)}: {hits} hits");
    }

    private static int Bits(float x) => BitConverter.SingleToInt32Bits(x);

    private static (int, int, int) Bits(Vector3 v) => (Bits(v.X), Bits(v.Y), Bits(v.Z));
}
