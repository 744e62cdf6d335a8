namespace Gjk.Core.Tests.World;

/// <summary>The bounds hold the shape, outward of every rounding, and are as tight as they say.</summary>
public class ShapeBoundsTests
{
    private static readonly Double3[] Axes = [new(1, 0, 0), new(0, 1, 0), new(0, 0, 1)];

    [Theory]
    [InlineData(1f)]
    [InlineData(1e4f)]
    [InlineData(1e9f)]
    public void TheyHoldTheShape(float spread)
    {
        for (int seed = 0; seed < Budget.Count(2000); seed++)
        {
            var rng = new Rng((ulong)seed);
            TestShape shape = Generators.Shape(rng, Generators.AllKinds[seed % Generators.AllKinds.Length]);
            RigidPose pose = Generators.Pose(rng, rng.Vector(-spread, spread));
            var bounds = new ShapeBounds(shape.Shape);
            var body = new Body<ConvexShape>(shape.Shape, pose);
            Aabb box = bounds.BoxAt(pose);
            for (int axis = 0; axis < 3; axis++)
            {
                double at = Double3.Dot(pose.Position, Axes[axis]), high = at + body.Height(Axes[axis]);
                double low = at - body.Height(-Axes[axis]);
                Assert.True(
                    Component(box.Min, axis) <= low && high <= Component(box.Max, axis),
                    $"seed {seed}, axis {axis}: {shape} at {TestShape.T(pose)}, {low:R} to {high:R}");
            }
        }
    }

    [Fact]
    public void AShapeFarFromItsOwnOriginIsHeldToo()
    {
        for (int seed = 0; seed < 200; seed++)
        {
            var rng = new Rng((ulong)seed);
            Vector3 offset = rng.UnitVector() * rng.LogFloat(1, 1e6);
            TestShape shape = TestShape.Mesh([.. Clouds.InBox(rng, 8, Vector3.One).Select(v => v + offset)]);
            Quaternion rotation = rng.Rotation();
            Vector3 back = -new RigidPose(rotation, Vector3.Zero).TransformPoint(offset);
            var pose = new RigidPose(rotation, back);
            var body = new Body<ConvexShape>(shape.Shape, pose);
            Aabb box = new ShapeBounds(shape.Shape).BoxAt(pose);
            for (int axis = 0; axis < 3; axis++)
            {
                double at = Double3.Dot(pose.Position, Axes[axis]);
                Assert.True(
                    Component(box.Min, axis) <= at - body.Height(-Axes[axis])
                        && at + body.Height(Axes[axis]) <= Component(box.Max, axis),
                    $"seed {seed}");
            }
        }
    }

    [Fact]
    public void ABoxAndASphereHaveTheirExactBounds()
    {
        var pose = new RigidPose(Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 6), new Vector3(1, 2, 3));
        Aabb box = new ShapeBounds(ConvexShape.Box(new Vector3(1, 2, 3))).BoxAt(pose);
        double c = Math.Sqrt(3) / 2, s = 0.5;
        Near(new Double3(1 - (c + 2 * s), 2 - (s + 2 * c), 0), box.Min);
        Near(new Double3(1 + c + 2 * s, 2 + s + 2 * c, 6), box.Max);
        Aabb ball = new ShapeBounds(ConvexShape.Sphere(2)).BoxAt(pose);
        Near(new Double3(-1, 0, 1), ball.Min);
        Near(new Double3(3, 4, 5), ball.Max);
    }

    /// <summary>Wide enough for a margin and for touching, and no wider than is of use.</summary>
    [Fact]
    public void TheSlackIsAFewRoundingsOfFloatAndAFewTouches()
    {
        Aabb far = new ShapeBounds(ConvexShape.Sphere(1)).BoxAt(new RigidPose(new Vector3(1000, 0, 0)));
        Assert.InRange((far.Max.X - 1001.0) / 1001 * (1 << 24), 2, 8);
        Aabb disc = new ShapeBounds(ConvexShape.Cylinder(1, 0)).BoxAt(RigidPose.Identity);
        Assert.InRange(disc.Max.Y / GjkTolerances.TouchCurved, 3, 12);
    }

    [Fact]
    public void PositionsAtTheEndOfTheRangeGiveFiniteBoxes()
    {
        Aabb box = new ShapeBounds(ConvexShape.Sphere(1e38f)).BoxAt(
            new RigidPose(new Vector3(float.MaxValue, -float.MaxValue, 0)));
        Assert.Equal(float.MaxValue, box.Max.X);
        Assert.Equal(-float.MaxValue, box.Min.Y);
    }

    [Fact]
    public void ADefaultShapeIsRefused() =>
        Assert.Equal("shape", Assert.Throws<ArgumentException>(() => new ShapeBounds(default(ConvexShape))).ParamName);

    private static float Component(Vector3 v, int axis) => axis == 0 ? v.X : axis == 1 ? v.Y : v.Z;

    private static void Near(Double3 expected, Vector3 actual) =>
        Assert.True((expected - actual).Length < 1e-5, $"{expected} is not {actual}");
}
