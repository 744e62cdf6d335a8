namespace Gjk.Core.Tests.Shapes;

/// <summary>A shape tells the numbers that it was made from.</summary>
public class ShapeSizeTests
{
    private static readonly RigidPose Pose = new(Quaternion.CreateFromYawPitchRoll(1, 2, 3), Vector3.One);

    [Fact]
    public void TheNumbersAreThoseThatWereGiven()
    {
        Same(ConvexShape.Sphere(2), 2, 0, default);
        Same(ConvexShape.Capsule(2, 3), 2, 3, default);
        Same(ConvexShape.Cylinder(2, 3), 2, 3, default);
        Same(ConvexShape.Cone(2, 3), 2, 3, default);
        Same(ConvexShape.Box(new Vector3(1, 2, 3)), 0, 0, new Vector3(1, 2, 3));
        Same(ConvexShape.Ellipsoid(new Vector3(1, 2, 3)), 0, 0, new Vector3(1, 2, 3));
        Same(ConvexShape.TaperedCapsule(1, 2, 3), 0, 3, default);
        Same(ConvexShape.Mesh([Vector3.One]), 0, 0, default);
        Same(default, 0, 0, default);
        ConvexShape tapered = ConvexShape.TaperedCapsule(1, 2, 3).Placed(Pose).Scaled(new Vector3(1, 2, 3));
        Assert.Equal((1, 2), (tapered.TopRadius, tapered.BottomRadius));
        Assert.Equal((0, 0), (ConvexShape.Capsule(1, 2).TopRadius, ConvexShape.Capsule(1, 2).BottomRadius));
        Assert.Equal(0.5f, ConvexShape.Box(Vector3.One).Placed(Pose).Rounded(0.5f).Rounding);
    }

    private static void Same(ConvexShape shape, float radius, float halfHeight, Vector3 halfExtents)
    {
        ConvexShape[] ways = shape.Kind == ShapeKind.None
            ? [shape]
            : [shape, shape.Placed(Pose), shape.Placed(Pose).Scaled(new Vector3(1, 2, 3)).Placed(Pose)];
        foreach (ConvexShape way in ways)
        {
            Assert.Equal(radius, way.Radius);
            Assert.Equal(halfHeight, way.HalfHeight);
            Assert.Equal(halfExtents, way.HalfExtents);
            Assert.Equal(0, way.Rounding);
        }
    }
}
