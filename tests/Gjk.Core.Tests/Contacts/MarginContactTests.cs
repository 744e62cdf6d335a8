using static Gjk.Core.Tests.Support.Resting;

namespace Gjk.Core.Tests.Contacts;

/// <summary>A margin lies around the core, not above it: the points of a tilted rounded shape are on its surface, where
/// it leaves the shape along the normal, and each gap is the gap there.</summary>
public class MarginContactTests
{
    private static readonly Vector3[] Wedge =
        [new(-1, -0.5f, -1), new(1, -0.5f, -1), new(0.9f, -0.45f, 1), new(-1, -0.5f, 1), new(0, 1, 0)];

    public static TheoryData<string, float> Tilted
    {
        get
        {
            TheoryData<string, float> data = [];
            foreach (string name in new[] { "capsule", "box", "cylinder", "cone", "triangle", "hull", "scaled" })
                foreach (float angle in new[] { 1e-7f, 1e-5f, 1e-3f, 0.02f, 0.1f, 0.3f, 0.4887f, 0.8f })
                    data.Add(name, angle);
            return data;
        }
    }

    [Fact]
    public void ATiltedCapsuleIsAsDeepAsItsEndAndItsSide()
    {
        var capsule = ConvexShape.Capsule(0.5f, 1);
        float angle = 28 * MathF.PI / 180;
        ContactManifold m = OnSlab(
            capsule, Lowered(capsule, Quaternion.CreateFromAxisAngle(Vector3.UnitZ, angle) * OnItsSide), 1);
        float[] gaps = [.. Points(m).Select(p => p.Gap).Order()];
        float rise = 2 * MathF.Sin(angle) - 0.5f * (1 / MathF.Cos(angle) - 1);
        Assert.Equal([-Resting.Depth, -Resting.Depth + rise], gaps, (x, y) => Math.Abs(x - y) < 1e-6f);
    }

    [Theory]
    [MemberData(nameof(Tilted))]
    public void EveryPointIsWhereTheSurfaceIsLeft(string name, float angle)
    {
        ConvexShape shape = Shape(name);
        var rng = new Rng(7);
        double size = 2 * shape.BoundingRadius, slack = 3e-6 * size, several = 0;
        for (int i = 0; i < 60; i++)
        {
            Quaternion lying = i % 3 == 0 ? Quaternion.Identity
                : Quaternion.CreateFromAxisAngle(i % 3 == 1 ? Vector3.UnitZ : Vector3.UnitX, MathF.PI / 2);
            float turn = rng.Float(0, 6);
            var axis = new Vector3(MathF.Cos(turn), 0, MathF.Sin(turn));
            RigidPose pose = Lowered(
                shape, Quaternion.CreateFromAxisAngle(axis, angle) * Quaternion.CreateFromAxisAngle(Vector3.UnitY, turn)
                    * lying);
            ContactManifold m = OnSlab(shape, pose, 1);
            Vector3 inward = Vector3.Transform(m.Normal, Quaternion.Conjugate(pose.Rotation)) * (float)size;
            if (m.Count > 1) several++;
            foreach (ManifoldPoint p in Points(m))
            {
                float off = Outside(shape, p.LocalPointB), left = Outside(shape, p.LocalPointB - 1e-3f * inward);
                Assert.True(Math.Abs(off) <= slack, $"{i}: {p} is {off:R} off");
                Assert.True(left >= -slack, $"{i}: below {p} there is {left:R} of the shape");
                Assert.Equal(p.PointB.Y, p.Gap, slack);
            }
        }

        Assert.InRange(several, 10, 60);
    }

    private static float Outside(ConvexShape shape, Vector3 local) =>
        ConvexQuery.SignedDistance(shape, RigidPose.Identity, local).Distance;

    private static ConvexShape Shape(string name) => name switch
    {
        "capsule" => ConvexShape.Capsule(0.5f, 1),
        "box" => ConvexShape.Box(new Vector3(0.6f, 0.3f, 0.8f)).Rounded(0.2f),
        "cylinder" => ConvexShape.Cylinder(0.6f, 0.5f).Rounded(0.3f),
        "cone" => ConvexShape.Cone(0.6f, 0.5f).Rounded(0.2f),
        "triangle" => ConvexShape.Triangle(new(-1, 0, -1), new(1, 0, -1), new(0, 0, 1)).Rounded(0.2f),
        "hull" => ConvexShape.Mesh(Wedge).Rounded(0.25f),
        _ => ConvexShape.Cylinder(0.4f, 0.6f).Rounded(0.2f).Scaled(new Vector3(-2)),
    };
}
