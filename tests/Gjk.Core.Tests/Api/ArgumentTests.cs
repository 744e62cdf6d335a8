namespace Gjk.Core.Tests.Api;

/// <summary>Every argument that a public constructor or method refuses: the exception's type, the argument's name, and
/// words that say what is wrong.</summary>
public class ArgumentTests
{
    private const string FiniteVector = "Every component must be finite.";
    private const string SizeVector = "Every component must be finite and not negative.";
    private const string ScaleVector = "Every component must be finite and not zero.";
    private const string Size = "Must be finite and not negative.";

    private static readonly Vector3 V = Vector3.One;

    /// <summary>NaN and both infinities in each of the three places.</summary>
    private static readonly Vector3[] NotFinite =
        [
            new(float.NaN, 0, 0), new(0, float.NaN, 0), new(0, 0, float.NaN), new(float.PositiveInfinity, 0, 0),
            new(0, float.NegativeInfinity, 0), new(0, 0, float.PositiveInfinity),
        ];

    private static readonly float[] NotASize =
        [-1, -float.Epsilon, float.NaN, float.PositiveInfinity, float.NegativeInfinity];

    private static readonly Vector3[] NotSizes =
        [.. NotFinite, new(-1, 1, 1), new(1, -float.Epsilon, 1), new(1, 1, -1)];

    private static readonly Vector3[] NotAScale = [.. NotFinite, new(0, 1, 1), new(1, 0, 1), new(1, 1, -0f)];

    [Fact]
    public void RigidPoseRefusesWhatIsNoRotation()
    {
        Quaternion[] wrong =
        [
            default, new(0, 0, 0, 1.0011f), new(0, 0, 0, 0.9989f), new(1, 1, 1, 1), new(float.NaN, 0, 0, 1),
            new(0, 0, 0, float.PositiveInfinity), new(0, float.NaN, 0, 0),
        ];
        Refused(wrong, "rotation", "The quaternion's length must be within 1e-3 of 1.", q => new RigidPose(q, V));
        Assert.Equal(0.9991f, new RigidPose(new Quaternion(0, 0, 0, 0.9991f), V).Rotation.W);
        Assert.Equal(1.0009f, new RigidPose(new Quaternion(0, 1.0009f, 0, 0), V).Rotation.Y);
    }

    [Fact]
    public void RigidPoseRefusesAPositionThatIsNotFinite()
    {
        Refused(NotFinite, "position", FiniteVector, p => new RigidPose(Quaternion.Identity, p));
        Refused(NotFinite, "position", FiniteVector, p => new RigidPose(p));
        Assert.Equal(float.MaxValue, new RigidPose(new Vector3(float.MaxValue)).Position.X);
    }

    [Fact]
    public void ABoxOfBoundsIsChecked()
    {
        Refused(NotFinite, "min", FiniteVector, v => new Aabb(v, V));
        Refused(NotFinite, "max", FiniteVector, v => new Aabb(-V, v));
        Refused<Vector3>(
            [new(0, 1, 1), new(1, 0, 1), new(1, 1, 0)], "max", "No maximum may lie below its minimum.",
            v => new Aabb(V, v));
        Assert.Equal(V, new Aabb(V, V).Max);
    }

    [Fact]
    public void SegmentsAreChecked()
    {
        Refused(NotFinite, "a", FiniteVector, v => new SegmentShape(v, V));
        Refused(NotFinite, "b", FiniteVector, v => new SegmentShape(V, v));
        Refused(NotFinite, "a", FiniteVector, v => ConvexShape.Segment(v, V));
        Refused(NotFinite, "b", FiniteVector, v => ConvexShape.Segment(V, v));
    }

    [Fact]
    public void TrianglesAreChecked()
    {
        Refused(NotFinite, "a", FiniteVector, v => new TriangleShape(v, V, V));
        Refused(NotFinite, "b", FiniteVector, v => new TriangleShape(V, v, V));
        Refused(NotFinite, "c", FiniteVector, v => new TriangleShape(V, V, v));
        Refused(NotFinite, "a", FiniteVector, v => ConvexShape.Triangle(v, V, V));
        Refused(NotFinite, "b", FiniteVector, v => ConvexShape.Triangle(V, v, V));
        Refused(NotFinite, "c", FiniteVector, v => ConvexShape.Triangle(V, V, v));
    }

    [Fact]
    public void RoundShapesAreChecked()
    {
        Refused(NotASize, "radius", Size, x => new SphereShape(x));
        Refused(NotASize, "radius", Size, x => ConvexShape.Sphere(x));
        Refused(NotASize, "radius", Size, x => new CapsuleShape(x, 1));
        Refused(NotASize, "halfHeight", Size, x => new CapsuleShape(1, x));
        Refused(NotASize, "radius", Size, x => ConvexShape.Capsule(x, 1));
        Refused(NotASize, "halfHeight", Size, x => ConvexShape.Capsule(1, x));
        Refused(NotASize, "radius", Size, x => new CylinderShape(x, 1));
        Refused(NotASize, "halfHeight", Size, x => new CylinderShape(1, x));
        Refused(NotASize, "radius", Size, x => ConvexShape.Cylinder(x, 1));
        Refused(NotASize, "halfHeight", Size, x => ConvexShape.Cylinder(1, x));
        Refused(NotASize, "radius", Size, x => new ConeShape(x, 1));
        Refused(NotASize, "halfHeight", Size, x => new ConeShape(1, x));
        Refused(NotASize, "radius", Size, x => ConvexShape.Cone(x, 1));
        Refused(NotASize, "halfHeight", Size, x => ConvexShape.Cone(1, x));
        Refused(NotASize, "topRadius", Size, x => new TaperedCapsuleShape(x, 1, 1));
        Refused(NotASize, "bottomRadius", Size, x => new TaperedCapsuleShape(1, x, 1));
        Refused(NotASize, "halfHeight", Size, x => new TaperedCapsuleShape(1, 1, x));
        Refused(NotASize, "topRadius", Size, x => ConvexShape.TaperedCapsule(x, 1, 1));
        Refused(NotASize, "bottomRadius", Size, x => ConvexShape.TaperedCapsule(1, x, 1));
        Refused(NotASize, "halfHeight", Size, x => ConvexShape.TaperedCapsule(1, 1, x));
        Refused(NotASize, "radius", Size, x => new Rounded<PointShape>(default, x));
    }

    [Fact]
    public void BoxesAndEllipsoidsAreChecked()
    {
        Refused(NotSizes, "halfExtents", SizeVector, v => new BoxShape(v));
        Refused(NotSizes, "halfExtents", SizeVector, v => ConvexShape.Box(v));
        Refused(NotSizes, "radii", SizeVector, v => new EllipsoidShape(v));
        Refused(NotSizes, "radii", SizeVector, v => ConvexShape.Ellipsoid(v));
    }

    [Fact]
    public void ScalesAreChecked()
    {
        Refused(NotAScale, "scale", ScaleVector, v => new Scaled<PointShape>(default, v));
        Refused([0f, float.NaN, float.PositiveInfinity], "scale", ScaleVector, x => new Scaled<PointShape>(default, x));
        Refused(NotAScale, "scale", ScaleVector, v => ConvexShape.Sphere(1).Scaled(v));
    }

    [Fact]
    public void ADefaultShapeIsNotDecorated()
    {
        Action[] decorations =
        [
            () => default(ConvexShape).Scaled(V), () => default(ConvexShape).Rounded(1),
            () => default(ConvexShape).Placed(new RigidPose(V)),
        ];
        foreach (Action decorate in decorations)
            Assert.StartsWith(
                "A default ConvexShape is no shape", Assert.Throws<InvalidOperationException>(decorate).Message);
    }

    [Fact]
    public void ScalesThatLeaveTheRangeOfFloatTogether()
    {
        ConvexShape large = ConvexShape.Cylinder(1, 1).Scaled(new Vector3(1e30f));
        ConvexShape small = ConvexShape.Cylinder(1, 1).Scaled(new Vector3(1e-30f));
        Assert.Equal(
            "scale", Assert.Throws<ArgumentOutOfRangeException>(() => large.Scaled(new Vector3(1e10f))).ParamName);
        Assert.Equal(
            "scale", Assert.Throws<ArgumentOutOfRangeException>(() => small.Scaled(new Vector3(1e-20f))).ParamName);
    }

    [Fact]
    public void RadiiOfRoundedShapesAreChecked()
    {
        foreach (float radius in new[] { -1, float.NaN, float.PositiveInfinity })
        {
            Assert.Equal(
                "radius",
                Assert.Throws<ArgumentOutOfRangeException>(() => ConvexShape.Box(V).Rounded(radius)).ParamName);
            Assert.Equal(
                "radius",
                Assert.Throws<ArgumentOutOfRangeException>(() => new Rounded<PointShape>(default, radius)).ParamName);
        }
    }

    [Fact]
    public void PosesOfPlacedShapesAreChecked()
    {
        Assert.Equal(
            "pose", Assert.Throws<ArgumentOutOfRangeException>(() => ConvexShape.Box(V).Placed(default)).ParamName);
        Assert.Equal(
            "pose",
            Assert.Throws<ArgumentOutOfRangeException>(() => new Placed<PointShape>(default, default)).ParamName);
    }

    [Fact]
    public void MeshesAreChecked()
    {
        Assert.Equal("hull", Assert.Throws<ArgumentNullException>(() => new ConvexMesh((ConvexHull)null!)).ParamName);
        Assert.Equal("hull", Assert.Throws<ArgumentNullException>(() => ConvexShape.Mesh((ConvexHull)null!)).ParamName);
        Func<IReadOnlyList<Vector3>, object>[] makers =
            [p => new ConvexHull(p), p => new ConvexMesh(p), p => ConvexShape.Mesh(p)];
        foreach (Func<IReadOnlyList<Vector3>, object> make in makers)
        {
            Assert.NotNull(Assert.Throws<ArgumentNullException>(() => make(null!)).ParamName);
            var empty = Assert.Throws<ArgumentException>(() => make([]));
            Assert.StartsWith("At least one point is needed.", empty.Message);
            Assert.Equal("points", empty.ParamName);
            foreach (Vector3 v in NotFinite)
            {
                var e = Assert.Throws<ArgumentException>(() => make([V, v]));
                Assert.Equal("points", e.ParamName);
                Assert.Contains("1", e.Message);
                Assert.Contains("finite", e.Message);
            }
        }
    }

    private static void Refused<T>(T[] values, string parameter, string message, Func<T, object> make)
        where T : struct
    {
        foreach (T value in values)
        {
            var e = Assert.Throws<ArgumentOutOfRangeException>(() => make(value));
            Assert.True(
                e.ParamName == parameter && e.Message.StartsWith(message, StringComparison.Ordinal),
                $"{value}: {e.ParamName}, '{e.Message}'");
        }
    }
}
