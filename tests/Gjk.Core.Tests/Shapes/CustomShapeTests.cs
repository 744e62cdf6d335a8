namespace Gjk.Core.Tests;

/// <summary>A user's own shape as a <see cref="ConvexShape"/>.</summary>
public class CustomShapeTests
{
    private static readonly RigidPose Inside = new(
        Quaternion.Normalize(new Quaternion(1, -2, 3, 4)), new Vector3(0.3f, -0.5f, 0.7f));

    [Fact]
    public void ItAnswersAsTheTypedShape()
    {
        var rng = new Rng(5);
        var typed = new RoundedCone(1);
        ConvexShape custom = ConvexShape.Custom(typed), other = ConvexShape.Box(new Vector3(0.5f, 0.4f, 0.3f));
        int overlapping = 0;
        for (int i = 0; i < 300; i++)
        {
            RigidPose a = new(rng.Rotation(), rng.UnitVector()), b = new(rng.Rotation(), 1.1f * rng.UnitVector());
            DistanceResult expected = ConvexQuery.SignedDistance(typed, a, other, b);
            Assert.Equal(expected.Distance, ConvexQuery.SignedDistance(custom, a, other, b).Distance, 4e-6f);
            Assert.Equal(
                ConvexQuery.Cast(typed, a, Vector3.UnitX, other, b, -Vector3.UnitX).Fraction,
                ConvexQuery.Cast(custom, a, Vector3.UnitX, other, b, -Vector3.UnitX).Fraction, 4e-6f);
            Assert.Equal(
                ConvexQuery.Distance(new Placed<RoundedCone>(typed, Inside), a, other, b).Distance,
                ConvexQuery.Distance(custom.Placed(Inside), a, other, b).Distance, 4e-6f);
            Assert.Equal(
                ConvexQuery.Distance(new Scaled<RoundedCone>(typed, 2), a, other, b).Distance,
                ConvexQuery.Distance(custom.Scaled(new Vector3(2)), a, other, b).Distance, 4e-6f);
            if (expected.IsOverlapping) overlapping++;
        }

        Assert.InRange(overlapping, 30, 270);
    }

    [Fact]
    public void ScenesAndBatchesTakeIt()
    {
        ConvexShape custom = ConvexShape.Custom(new RoundedCone(1));
        RigidPose near = new(new Vector3(0, 0, 1)), far = new(new Vector3(9, 0, 0));
        var scene = new CollisionScene();
        scene.Add(custom, RigidPose.Identity);
        scene.Add(ConvexShape.Sphere(0.6f), near);
        scene.Add(custom.Placed(Inside), far);
        var pairs = new List<ObjectPair>();
        scene.FindOverlaps(pairs);
        Assert.Equal([new ObjectPair(0, 1)], pairs);
        ConvexShape[] shapes = [custom, ConvexShape.Sphere(0.6f), custom.Placed(Inside)];
        RigidPose[] poses = [RigidPose.Identity, near, far];
        var results = new DistanceResult[3];
        PairBatch.Distance(shapes, poses, [new(0, 1), new(0, 2), new(1, 2)], results);
        Assert.Equal(
            ResultBits.Of(ConvexQuery.Distance(shapes[0], poses[0], shapes[2], poses[2])), ResultBits.Of(results[1]));
    }

    [Fact]
    public void AQueryAllocatesNothing()
    {
        ConvexShape custom = ConvexShape.Custom(new RoundedCone(1));
        var to = new RigidPose(new Vector3(3, 1, 0));
        ConvexQuery.Distance(custom, RigidPose.Identity, custom, to);
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 100; i++) ConvexQuery.Distance(custom, RigidPose.Identity, custom, to);
        Assert.Equal(before, GC.GetAllocatedBytesForCurrentThread());
    }

    [Fact]
    public void AGenerousRadiusDoesNoHarm()
    {
        ConvexShape generous = ConvexShape.Custom(new RoundedCone(1e6));
        Assert.InRange(generous.BoundingRadius, 0.95, 1.2);
    }

    [Fact]
    public void ItIsEqualByReferenceAndRefusesFiles()
    {
        object box = new RoundedCone(1);
        var shape = (ISupportMap)box;
        Assert.Equal(ConvexShape.Custom(shape), ConvexShape.Custom(shape));
        Assert.NotEqual(ConvexShape.Custom(shape), ConvexShape.Custom(new RoundedCone(1)));
        Assert.Equal(ConvexShape.Sphere(1), ConvexShape.Custom(ConvexShape.Sphere(1)));
        ConvexShape custom = ConvexShape.Custom(shape);
        Assert.Equal(ShapeKind.Custom, custom.Kind);
        Assert.Equal(ShapeKind.Custom, custom.Scaled(new Vector3(1, 2, 3)).Kind);
        Assert.StartsWith("custom shape", custom.ToString());
        var record = new QueryRecord(custom, RigidPose.Identity, custom.Rounded(1), RigidPose.Identity);
        Assert.Throws<NotSupportedException>(() => record.ToString());
        Assert.Throws<ArgumentNullException>(() => ConvexShape.Custom(null!));
        Assert.Throws<ArgumentException>(() => ConvexShape.Custom(new RoundedCone(double.NaN)));
    }

    /// <summary>A cone with a margin: y from -0.5 to 0.5, radius 0.5 at the bottom.</summary>
    private readonly struct RoundedCone(double radius) : ISupportMap
    {
        private readonly ConeShape _cone = new(0.5f, 0.5f);

        public Double3 Center => default;

        public double Margin => 0.25;

        public double BoundingRadius => radius;

        public int Support(in Double3 direction, out Double3 point) => _cone.Support(direction, out point);

        public void GetFace(in Double3 direction, ref FaceCorners corners) => _cone.GetFace(direction, ref corners);

        public bool TryGetVertex(int id, out Double3 point) => _cone.TryGetVertex(id, out point);
    }
}
