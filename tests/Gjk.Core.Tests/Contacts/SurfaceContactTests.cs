namespace Gjk.Core.Tests.Contacts;

/// <summary>Points lie on both surfaces, with nothing of either body in front of them: of meshes that are scaled
/// unevenly, where what is level inside is steep outside, and of needles, whose edges meet so sharply that a slack
/// reaches far beyond.</summary>
public class SurfaceContactTests
{
    /// <summary>Length, as a fraction of the size: how far a point may be off its surface.</summary>
    private const float Off = 2e-6f;

    private const int Pairs = 400;

    private static readonly Vector3[] Wedge =
        [new(-1, 0, -1), new(1, 0, -1), new(-1, 0, 1), new(1, 0, 1), new(-1, 1, -1), new(1, 1, -1)];

    private static readonly Vector3[] Pyramid =
        [new(-1, 0, -1), new(1, 0, -1), new(-1, 0, 1), new(1, 0, 1), new(0, 1, 0)];

    [Theory]
    [InlineData("mesh", 1, 0.1f, 1)]
    [InlineData("mesh", 0.1f, 1, -0.1f)]
    [InlineData("mesh", 1, 0.01f, 0.3f)]
    [InlineData("placed mesh", 0.1f, 1, 0.1f)]
    [InlineData("placed box", 0.1f, 1, 0.2f)]
    [InlineData("placed cylinder", 0.1f, 1, 0.2f)]
    [InlineData("triangle", 0.1f, 1, 0.1f)]
    [InlineData("twice", 0.1f, 1, 0.2f)]
    public void PointsOfUnevenlyScaledShapesLieOnThem(string kind, float x, float y, float z)
    {
        var rng = new Rng(31);
        var scale = new Vector3(x, y, z);
        int points = 0;
        for (int i = 0; i < Pairs; i++)
        {
            ConvexShape inner = kind switch
            {
                "placed box" => ConvexShape.Box(new Vector3(0.5f, 0.7f, 1))
                    .Placed(new RigidPose(rng.Rotation(), default)),
                "placed cylinder" => ConvexShape.Cylinder(1, 0.5f).Placed(new RigidPose(rng.Rotation(), default)),
                "triangle" => ConvexShape.Triangle(rng.Vector(-1, 1), rng.Vector(-1, 1), rng.Vector(-1, 1))
                    .Placed(new RigidPose(rng.Rotation(), default)),
                "placed mesh" => ConvexShape.Mesh(Wedge).Placed(new RigidPose(rng.Rotation(), default)),
                "twice" => ConvexShape.Mesh(Pyramid).Scaled(new Vector3(1, 4, 2))
                    .Placed(new RigidPose(rng.Rotation(), default)),
                _ => ConvexShape.Mesh(i % 2 == 0 ? Wedge : Pyramid),
            };
            ConvexShape a = inner.Scaled(scale), b = ConvexShape.Box(new Vector3(0.5f));
            points += Check(rng, a, b, new RigidPose(rng.Rotation(), rng.Vector(-0.8, 0.8)), 1);
        }

        Assert.True(points > 2 * Pairs, $"only {points} points");
    }

    [Theory]
    [InlineData(1e-4f)]
    [InlineData(1e-6f)]
    [InlineData(3e-7f)]
    [InlineData(1e-8f)]
    public void PointsOfNeedlesLieOnThem(float width)
    {
        var rng = new Rng(32);
        int points = 0;
        for (int i = 0; i < Pairs; i++)
        {
            ConvexShape a = Needle(rng, width), b = i % 3 == 0 ? a : Needle(rng, width);
            var turn = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, rng.Float(-3, 3));
            if (i % 2 == 0) turn = Quaternion.Identity;
            var pose = new RigidPose(turn, new Vector3(0, 0, rng.Float(-1, 1)) + width * rng.Vector(-3, 3));
            points += Check(rng, a, b, pose, 2);
        }

        Assert.True(points > Pairs, $"only {points} points");
    }

    private static ConvexShape Needle(Rng rng, float width)
    {
        var corners = new Vector3[(int)rng.Float(4, 6.99)];
        for (int i = 0; i < corners.Length; i++)
            corners[i] = rng.Vector(0, 3) * width * new Vector3(1, 1, 0) + new Vector3(0, 0, rng.Float(-1, 1));
        return ConvexShape.Mesh(corners);
    }

    /// <summary>Asks for all within a small gap and, of overlapping pairs, for what overlaps.</summary>
    private static int Check(Rng rng, ConvexShape a, ConvexShape b, RigidPose pose, float size)
    {
        int points = 0;
        ContactManifold manifold = default;
        foreach (float gap in (float[])[0, 0.05f * size])
        {
            DistanceResult result = ConvexQuery.Contacts(a, RigidPose.Identity, b, pose, gap, out manifold);
            points += manifold.Count;
            for (int i = 0; i < manifold.Count; i++)
            {
                ManifoldPoint p = manifold[i];
                string where = $"{result}, point {i}: {p} of {a} and {b} at {pose}";
                OnSurface(a, RigidPose.Identity, p.PointA, manifold.Normal, size, where);
                OnSurface(b, pose, p.PointB, -manifold.Normal, size, where);
            }
        }

        return points;
    }

    /// <summary>The point is in the shape, and a ray that comes against the direction meets it there.</summary>
    private static void OnSurface(
        ConvexShape shape, RigidPose pose, Vector3 point, Vector3 outward, float size, string where)
    {
        float off = ConvexQuery.Distance(shape, pose, point).Distance;
        Assert.True(off <= Off * size, $"{off} off: {where}");
        Vector3 before = point + outward * (20 * Off * size);
        float inside = -ConvexQuery.SignedDistance(shape, pose, before).Distance;
        Assert.True(inside <= Off * size, $"{inside} inside: {where}");
    }
}
