using System;
using System.Collections.Generic;
using System.Numerics;

namespace Gjk.Core.Tests.Support;

/// <summary>Meshes and compounds that are not convex, and what single queries say of all their parts.</summary>
internal static class ConcaveShapes
{
    public static TriangleMesh Torus(int around, int across, float radius = 1, float tube = 0.35f)
    {
        var points = new List<Vector3>();
        var indices = new List<int>();
        for (int i = 0; i < around; i++)
        {
            double a = 2 * Math.PI * i / around;
            for (int j = 0; j < across; j++)
            {
                double b = 2 * Math.PI * j / across, r = radius + tube * Math.Cos(b);
                points.Add(new((float)(r * Math.Cos(a)), (float)(tube * Math.Sin(b)), (float)(r * Math.Sin(a))));
                int p = i * across + j, q = i * across + (j + 1) % across;
                int s = (i + 1) % around * across + j, t = (i + 1) % around * across + (j + 1) % across;
                indices.AddRange([p, q, s, q, t, s]);
            }
        }

        return new TriangleMesh(points, indices);
    }

    /// <summary>A flat grid of 2 n n triangles over the unit square of the xz plane.</summary>
    public static TriangleMesh Grid(int n, Func<float, float, float>? height = null)
    {
        var points = new List<Vector3>();
        var indices = new List<int>();
        for (int i = 0; i <= n; i++)
            for (int j = 0; j <= n; j++)
            {
                float x = (float)i / n - 0.5f, z = (float)j / n - 0.5f;
                points.Add(new Vector3(x, height?.Invoke(x, z) ?? 0, z));
                if (i == n || j == n) continue;
                int p = i * (n + 1) + j;
                indices.AddRange([p, p + 1, p + n + 1, p + 1, p + n + 2, p + n + 1]);
            }

        return new TriangleMesh(points, indices);
    }

    /// <summary>A box as a closed mesh.</summary>
    public static TriangleMesh Box(Vector3 half)
    {
        var points = new Vector3[8];
        for (int i = 0; i < 8; i++)
            points[i] = half * new Vector3((i & 1) == 0 ? -1 : 1, (i & 2) == 0 ? -1 : 1, (i & 4) == 0 ? -1 : 1);
        return new TriangleMesh(
            points,
            [
                0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5,
            ]);
    }

    /// <summary>Triangles at random, some of them degenerate or repeated.</summary>
    public static TriangleMesh Soup(FuzzRandom random, int count, double size)
    {
        var points = new List<Vector3>();
        var indices = new List<int>();
        for (int i = 0; i < count; i++)
        {
            Vector3 middle = random.Vector(1);
            for (int k = 0; k < 3; k++)
            {
                points.Add(random.OneIn(20) && points.Count > 0 ? points[^1] : middle + random.Vector(size));
                indices.Add(points.Count - 1);
            }

            if (random.OneIn(10)) indices.AddRange(indices[^3..]);
        }

        return new TriangleMesh(points, indices);
    }

    public static CompoundShape Compound(FuzzRandom random, int count)
    {
        var parts = new CompoundPart[count];
        for (int i = 0; i < count; i++)
        {
            var pose = new RigidPose(Rotations.Even(random), random.Vector(1));
            float size = random.Float(0.05f, 0.2f);
            parts[i] = new CompoundPart(
                random.Below(5) switch
                {
                    0 => ConvexShape.Sphere(size),
                    1 => ConvexShape.Capsule(size, size),
                    2 => ConvexShape.Box(new Vector3(size, size / 2, size / 4)),
                    3 => ConvexShape.Triangle(random.Vector(size), random.Vector(size), random.Vector(size)),
                    _ => ConvexShape.Mesh([.. RandomPoints(random, 12, size)]),
                }, pose);
        }

        return new CompoundShape(parts);
    }

    /// <summary>Any of the kinds.</summary>
    public static AnyShape Any(FuzzRandom random) => random.Below(6) switch
    {
        0 => AnyShape.Surface(Soup(random, random.Of(1, 3, 20, 60), random.Magnitude(0.02, 0.5))),
        1 => AnyShape.Surface(Torus(random.Of(4, 9), random.Of(3, 7))),
        2 => AnyShape.Surface(Torus(7, 5).Scaled(random.Factors(0.3, 3))),
        3 => AnyShape.Of(Compound(random, random.Of(1, 2, 9, 20))),
        4 => AnyShape.Of(Compound(random, 5).Scaled(random.Factors(0.5, 2))),
        _ => AnyShape.Of(ConvexShape.Box(new Vector3(0.3f, 0.2f, 0.1f)).Rounded(random.Of(0, 0.1f))),
    };

    public static RigidPose Pose(FuzzRandom random, double reach) => new(Rotations.Any(random), random.Vector(reach));

    /// <summary>The parts as they were given, each as a convex shape of its own.</summary>
    public static List<ConvexShape> Parts(in AnyShape shape)
    {
        var parts = new List<ConvexShape>();
        if (shape.Mesh is { } mesh)
        {
            for (int i = 0; i < mesh.TriangleCount; i++)
            {
                mesh.GetTriangle(i, out int a, out int b, out int c);
                var triangle = ConvexShape.Triangle(mesh.GetVertex(a), mesh.GetVertex(b), mesh.GetVertex(c));
                parts.Add(mesh.Scale == Vector3.One ? triangle : triangle.Scaled(mesh.Scale));
            }
        }
        else if (shape.Compound is { } compound)
        {
            for (int i = 0; i < compound.PartCount; i++) parts.Add(compound.GetPart(i));
        }
        else
        {
            parts.Add(shape.Convex);
        }

        return parts;
    }

    private static IEnumerable<Vector3> RandomPoints(FuzzRandom random, int count, double size)
    {
        for (int i = 0; i < count; i++) yield return random.Vector(size);
    }
}
