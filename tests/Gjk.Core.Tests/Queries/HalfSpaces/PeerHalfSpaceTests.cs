namespace Gjk.Core.Tests.Queries.HalfSpaces;

/// <summary>What FCL's own tests expect of shapes on half-spaces (test/test_fcl_geometric_shapes.cpp, the functions
/// test_shapeIntersection_halfspace...; coal has the same): depth, normal, and the contact in the middle of what lies
/// in both, here and with both bodies turned and moved.</summary>
public class PeerHalfSpaceTests
{
    private static readonly RigidPose Elsewhere =
        new(Quaternion.Normalize(new Quaternion(0.3f, -0.6f, 0.2f, 0.7f)), new Vector3(4, -7, 9));

    /// <summary>The shape, the axis of the plane's normal, how deep the shape is where the plane goes through its
    /// origin, the plane's offsets that FCL takes, and one at which they are apart.</summary>
    public static TheoryData<string, int, float, float[], float> Rows => new()
    {
        { "sphere", 0, 10, [0, 5, -5, 10.1f], -10.1f },
        { "box", 0, 2.5f, [0, 1.25f, -1.25f, 2.51f], -2.51f },
        { "ellipsoid", 0, 5, [0, 1.25f, -1.25f, 5.01f], -5.01f },
        { "ellipsoid", 1, 10, [0, 1.25f, -1.25f, 10.01f], -10.01f },
        { "ellipsoid", 2, 20, [0, 1.25f, -1.25f, 20.01f], -20.01f },
        { "capsule", 0, 5, [0, 2.5f, -2.5f, 5.1f], -5.1f },
        { "capsule", 1, 5, [0, 2.5f, -2.5f, 5.1f], -5.1f },
        { "capsule", 2, 10, [0, 2.5f, -2.5f, 10.1f], -10.1f },
        { "cylinder", 0, 5, [0, 2.5f, -2.5f, 5.1f], -5.1f },
        { "cylinder", 1, 5, [0, 2.5f, -2.5f, 5.1f], -5.1f },
        { "cylinder", 2, 5, [0, 2.5f, -2.5f, 5.1f], -5.1f },
        { "cone", 0, 5, [0, 2.5f, -2.5f, 5.1f], -5.1f },
        { "cone", 1, 5, [0, 2.5f, -2.5f, 5.1f], -5.1f },
        { "cone", 2, 5, [0, 2.5f, -2.5f, 5.1f], -5.1f },
    };

    [Theory]
    [MemberData(nameof(Rows))]
    public void ShapesStandInHalfSpaces(string kind, int axis, float reach, float[] offsets, float apart)
    {
        ConvexShape shape = kind switch
        {
            "sphere" => ConvexShape.Sphere(10),
            "box" => ConvexShape.Box(new Vector3(2.5f, 5, 10)),
            "ellipsoid" => ConvexShape.Ellipsoid(new Vector3(5, 10, 20)),
            "capsule" => ConvexShape.Capsule(5, 5).AlongZ(),
            "cylinder" => ConvexShape.Cylinder(5, 5).AlongZ(),
            _ => ConvexShape.Cone(5, 5).AlongZ(),
        };
        Vector3 normal = axis == 0 ? Vector3.UnitX : axis == 1 ? Vector3.UnitY : Vector3.UnitZ;
        foreach (RigidPose pose in new[] { RigidPose.Identity, Elsewhere })
        {
            Vector3 up = Vector3.Transform(normal, pose.Rotation);
            foreach (float offset in offsets)
            {
                // FCL moves the half-space; an offset of the plane is the same.
                var moved = new RigidPose(pose.Rotation, pose.TransformPoint(normal * offset));
                foreach ((ConvexShape floor, RigidPose at) in new[]
                    {
                        (ConvexShape.HalfSpace(normal, offset), pose), (ConvexShape.HalfSpace(normal, 0), moved),
                    })
                {
                    DistanceResult r = ConvexQuery.SignedDistance(shape, pose, floor, at);
                    Assert.Equal(GjkStatus.Overlapping, r.Status);
                    Assert.Equal(-(reach + offset), r.Distance, 1e-5f);
                    Assert.InRange(Vector3.Distance(-up, r.Normal), 0, 1e-6f);
                    float middle = Vector3.Dot((r.PointA + r.PointB) / 2 - pose.Position, up);
                    Assert.Equal((offset - reach) / 2, middle, 1e-5f);
                    Assert.True(ConvexQuery.Overlaps(shape, pose, floor, at));
                }
            }

            ConvexShape below = ConvexShape.HalfSpace(normal, apart);
            Assert.False(ConvexQuery.Overlaps(shape, pose, below, pose));
            Assert.Equal(-apart - reach, ConvexQuery.Distance(shape, pose, below, pose).Distance, 1e-5f);
        }
    }
}
