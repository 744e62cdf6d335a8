using static Gjk.Core.Tests.Support.Resting;

namespace Gjk.Core.Tests.Contacts;

/// <summary>Round bodies along a box's edge touch it at the two ends of what they share, though they are turned against
/// it a little.</summary>
public class AlongEdgeTests
{
    private static readonly ConvexShape Box = ConvexShape.Box(new Vector3(0.3f, 0.5f, 0.3f));

    [Theory]
    [InlineData("capsule")]
    [InlineData("cylinder")]
    [InlineData("rounded")]
    public void ABodyAlongAnEdgeHasTwoPointsAtItsEnds(string kind)
    {
        ConvexShape body = kind switch
        {
            "capsule" => ConvexShape.Capsule(0.2f, 0.5f),
            "cylinder" => ConvexShape.Cylinder(0.2f, 0.5f),
            _ => ConvexShape.Box(new Vector3(0.1f, 0.5f, 0.1f)).Rounded(0.1f),
        };
        bool isBox = kind == "rounded";
        float reach = isBox ? 0.1f * MathF.Sqrt(2) + 0.1f : 0.2f, eighth = MathF.PI / 4;
        var rng = new Rng(1);
        foreach (float tilt in new[] { 0, 1e-8f, 1e-7f, 3e-7f, 1e-6f, 1e-5f, 1e-4f, 5e-4f })
        {
            for (int i = 0; i < 100; i++)
            {
                Quaternion turn = Quaternion.Normalize(rng.Rotation());
                Quaternion around = Quaternion.CreateFromAxisAngle(Vector3.UnitY, eighth + rng.Float(-0.3, 0.3));
                Quaternion own = Quaternion.CreateFromAxisAngle(Vector3.UnitY, isBox ? eighth : 0);
                var a = new RigidPose(Quaternion.Normalize(turn * around), default);
                Vector3 edge = Vector3.Transform(new Vector3(0.3f, 0, 0.3f), around);
                if (edge.X < 0.4f) edge = Vector3.Transform(new Vector3(0.3f, 0, -0.3f), around);
                var at = new Vector3(edge.X + reach - 1e-4f, 0.2f, edge.Z);
                Quaternion tilted = Quaternion.CreateFromAxisAngle(Vector3.UnitX, tilt) * own;
                var b = new RigidPose(Quaternion.Normalize(turn * tilted), Vector3.Transform(at, turn));
                ContactManifold m = Ask(Box, a, body, b, 0.02f), swapped = Ask(body, b, Box, a, 0.02f);
                string record = $"{tilt}, {i}: {m}, {new QueryRecord(Box, a, body, b)}";
                Assert.True(m.Count == 2, record);
                Assert.True(swapped.Count == 2, record);
                Assert.True((m[0].PointA - m[1].PointA).Length() > 0.79f, record);
            }
        }
    }

    /// <summary>Cones side by side, the one upside down, touch along a common generator.</summary>
    [Fact]
    public void ConesAlongAGeneratorHaveTwoPoints()
    {
        var rng = new Rng(2);
        for (int i = 0; i < 1000; i++)
        {
            float radius = rng.Float(0.05, 0.55), half = rng.Float(0.2, 0.8);
            ConvexShape cone = ConvexShape.Cone(radius, half);
            float slant = MathF.Sqrt(radius * radius + 4 * half * half);
            var outward = new Vector3(2 * half / slant, radius / slant, 0);
            Quaternion turn = Quaternion.Normalize(rng.Rotation());
            Quaternion flip = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI);
            Quaternion spin = Quaternion.CreateFromAxisAngle(Vector3.UnitY, rng.Float(0, 6.3));
            var a = new RigidPose(
                Quaternion.Normalize(turn * Quaternion.CreateFromAxisAngle(Vector3.UnitY, rng.Float(0, 6.3))), default);
            Vector3 at = new Vector3(radius, 0, 0) - outward * 1e-3f;
            var b = new RigidPose(Quaternion.Normalize(turn * flip * spin), Vector3.Transform(at, turn));
            ContactManifold m = Ask(cone, a, cone, b, 0.02f), swapped = Ask(cone, b, cone, a, 0.02f);
            string record = $"{i}: {m}, {new QueryRecord(cone, a, cone, b)}";
            Assert.True(m.Count == 2, record);
            Assert.True(swapped.Count == 2, record);
        }
    }
}
