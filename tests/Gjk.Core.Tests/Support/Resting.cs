namespace Gjk.Core.Tests.Support;

/// <summary>Bodies on a slab whose top is at height 0, and what their contacts are compared with.</summary>
internal static class Resting
{
    public const float Depth = 0.01f, Gap = 0.05f;

    /// <summary>Turns the y axis to lie along x.</summary>
    public static readonly Quaternion OnItsSide = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 2);

    public static readonly ConvexShape Slab = ConvexShape.Box(new Vector3(10, 1, 10));

    public static readonly RigidPose SlabPose = new(new Vector3(0, -1, 0));

    public static ContactManifold Ask(
        ConvexShape a, RigidPose poseA, ConvexShape b, RigidPose poseB, float maxGap = Gap)
    {
        var manifold = default(ContactManifold);
        DistanceResult r = ConvexQuery.Contacts(a, poseA, b, poseB, maxGap, out manifold);
        AssertIsSignedDistance(r, a, poseA, b, poseB);
        return manifold;
    }

    /// <summary>Contacts say what the signed distance says in one of the two orders, to the last bit.</summary>
    public static void AssertIsSignedDistance(
        in DistanceResult found, in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB)
    {
        DistanceResult swapped = ConvexQuery.SignedDistance(b, poseB, a, poseA).Swapped;
        Assert.Equal(swapped.Equals(found) ? swapped : ConvexQuery.SignedDistance(a, poseA, b, poseB), found);
    }

    public static ContactManifold OnSlab(ConvexShape shape, RigidPose pose, float maxGap = Gap) =>
        Ask(Slab, SlabPose, shape, pose, maxGap);

    /// <summary>A pose in which the shape is in the slab by the depth.</summary>
    public static RigidPose Lowered(ConvexShape shape, Quaternion rotation) =>
        new(rotation, new Vector3(0, Height(shape, rotation) - Depth, 0));

    public static float Height(ConvexShape shape, Quaternion rotation) =>
        (float)new Body<ConvexShape>(shape, new RigidPose(rotation, default)).Height(new Double3(0, -1, 0));

    public static List<ManifoldPoint> Points(ContactManifold m) =>
        [.. Enumerable.Range(0, m.Count).Select(i => m[i])];

    /// <summary>The points on A, seen from above.</summary>
    public static void AssertPlaces(ContactManifold m, params (float X, float Z)[] expected) =>
        AssertPlaces(m, 1e-5f, expected);

    public static void AssertPlaces(ContactManifold m, float tolerance, params (float X, float Z)[] expected)
    {
        string text = string.Join(", ", Points(m).Select(p => p.PointA.ToString()));
        Assert.True(m.Count == expected.Length, $"{m.Count} points: {text}");
        foreach ((float x, float z) in expected)
        {
            Assert.True(
                Points(m).Any(p => Math.Abs(p.PointA.X - x) <= tolerance && Math.Abs(p.PointA.Z - z) <= tolerance),
                $"none at ({x}, {z}): {text}");
        }
    }

    public static float Area(ContactManifold m)
    {
        var middle = new Vector3(Points(m).Average(p => p.PointA.X), 0, Points(m).Average(p => p.PointA.Z));
        Vector3[] around =
        [
            .. Points(m).Select(p => p.PointA - middle).OrderBy(p => MathF.Atan2(p.Z, p.X)),
        ];
        return around.Select((p, i) => (p, q: around[(i + 1) % around.Length]))
            .Sum(e => MathF.Abs(e.p.X * e.q.Z - e.p.Z * e.q.X)) / 2;
    }
}
