using Gjk.Import;

namespace Gjk.Demo.Tests.Import;

/// <summary>Which parts get a warning, and what it says.</summary>
public sealed class ConvexityTests
{
    private const int Seed = 4711;

    /// <summary>Corners rounded to float, far from the origin, leave less than the tolerance.</summary>
    [Fact]
    public void ConvexPartsGetNone()
    {
        var random = new Rng(Seed);
        for (int i = 0; i < 60; i++)
        {
            Vector3[] cloud = Clouds.InBox(random, 5 + i, Vector3.One);
            ImportedMesh part = HullPart(cloud, new Vector3(i % 3 * 50), i % 2 == 0);
            Assert.True(Convexity.Warning(part) is null, $"seed {Seed}, {i}: {Convexity.Warning(part)}");
        }
    }

    [Fact]
    public void TheShareOfTheHullIsNamed()
    {
        Vector3[] box = Box(new Vector3(1, 1, 1), Vector3.Zero);
        Vector3[] far = Box(new Vector3(1, 1, 1), new Vector3(3, 0, 0));
        ImportedMesh two = ImportedMesh.Weld("two", (Vector3[])[.. box, .. far], [.. Boxes(0), .. Boxes(8)]);
        Assert.Equal(
            "is not convex: it fills 50 % of its hull's volume; as a convex shape it is its hull",
            Convexity.Warning(two));

        ImportedMesh twice = ImportedMesh.Weld("twice", box, [.. Boxes(0), .. Boxes(0)]);
        Assert.Contains("overlap and enclose 200 %", Convexity.Warning(twice));
    }

    [Fact]
    public void OpenFlatAndLooseParts()
    {
        Vector3[] box = Box(new Vector3(1, 1, 1), Vector3.Zero);
        int[] faces = Boxes(0);
        Assert.Contains("is not closed", Convexity.Warning(ImportedMesh.Weld("open", box, faces[..^3])));
        int[] turned = [.. faces[..^3], faces[^3], faces[^1], faces[^2]];
        Assert.Contains("is not closed", Convexity.Warning(ImportedMesh.Weld("turned", box, turned)));
        Assert.Contains("has no faces", Convexity.Warning(ImportedMesh.Weld("loose", box, [])));
        Assert.Null(Convexity.Warning(ImportedMesh.Weld("triangle", box, [0, 1, 2])));
        Assert.Null(Convexity.Warning(ImportedMesh.Weld("both sides", box, [0, 1, 2, 0, 2, 1])));
        Assert.Null(Convexity.Warning(ImportedMesh.Weld("point", [Vector3.One], [])));
        ImportedMesh line = ImportedMesh.Weld("line", [Vector3.Zero, Vector3.One, Vector3.UnitX], [0, 1, 1]);
        Assert.Null(Convexity.Warning(line));
        Vector3[] arrow = [new(0, 0, 0), new(4, 0, 0), new(1, 1, 0), new(0, 4, 0)];
        ImportedMesh dart = ImportedMesh.Weld("arrow", arrow, [0, 1, 2, 0, 2, 3]);
        Assert.Contains("do not fill its outline", Convexity.Warning(dart));
    }

    /// <summary>A hull whose triangles are each cut into four, at corners that rounding moves out of their
    /// plane.</summary>
    private static ImportedMesh HullPart(Vector3[] cloud, Vector3 offset, bool mirrored)
    {
        var hull = new ConvexHull(cloud);
        var corners = new List<Vector3>();
        void Add(params Vector3[] triangle) => corners.AddRange(
            (mirrored ? triangle.Reverse() : triangle).Select(v => v + offset));
        for (int i = 0; i < hull.TriangleCount; i++)
        {
            hull.GetTriangle(i, out int ia, out int ib, out int ic);
            Vector3 a = hull.GetVertex(ia), b = hull.GetVertex(ib), c = hull.GetVertex(ic);
            Vector3 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
            Add(a, ab, ca);
            Add(ab, b, bc);
            Add(ca, bc, c);
            Add(ab, bc, ca);
        }

        return ImportedMesh.Weld("hull", corners.ToArray(), [.. Enumerable.Range(0, corners.Count)]);
    }

    private static Vector3[] Box(Vector3 size, Vector3 at) =>
        [.. Enumerable.Range(0, 8).Select(i => at + size * new Vector3(i & 1, i >> 1 & 1, i >> 2))];

    /// <summary>The faces of a box, seen from outside counter-clockwise.</summary>
    private static int[] Boxes(int first)
    {
        int[] faces =
        [
            0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5,
        ];
        return Array.ConvertAll(faces, i => i + first);
    }
}
