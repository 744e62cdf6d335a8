namespace Gjk.Core.Tests.Concave;

/// <summary>Closed meshes, round, rough, hollow and toothed.</summary>
internal static class Solids
{
    public static TriangleMesh Named(string name, int seed) => name switch
    {
        "ball" => Ball(12, 20, _ => 0.8f),
        "gear" => Gear(12, 0.4f, 0.5f, 0.1f),
        "ring" => ConcaveShapes.Torus(24, 12, 0.5f, 0.15f),
        _ => Rock(seed, 0.5f, 0.15f),
    };

    public static TriangleMesh Box(Vector3 low, Vector3 high) =>
        Joined((ConcaveShapes.Box((high - low) / 2), (high + low) / 2));

    /// <summary>A square height field at height 0, open or with a base at -1.</summary>
    public static AnyShape FlatField(int columns, float cell, bool isSolid)
    {
        var heights = new float[columns * columns];
        return isSolid
            ? AnyShape.Solid(TriangleMesh.FromHeights(heights, columns, new Vector2(cell), baseHeight: -1))
            : AnyShape.Surface(TriangleMesh.FromHeights(heights, columns, new Vector2(cell)));
    }

    /// <summary>The lowest height of a turned mesh.</summary>
    public static float Lowest(TriangleMesh mesh, Quaternion turn) =>
        Vertices(mesh).Min(v => Vector3.Transform(v * mesh.Scale, turn).Y);

    /// <summary>1 where the signed volume is positive, so that normals look out.</summary>
    public static int Sign(TriangleMesh mesh)
    {
        double volume = 0;
        Vector3[] points = Vertices(mesh);
        for (int i = 0; i < mesh.TriangleCount; i++)
        {
            mesh.GetTriangle(i, out int a, out int b, out int c);
            volume += Double3.Triple(points[a], points[b], points[c]);
        }

        return Math.Sign(volume);
    }

    public static TriangleMesh Scaled(TriangleMesh mesh, float factor) =>
        new([.. Vertices(mesh).Select(v => factor * v)], Indices(mesh));

    public static TriangleMesh Flipped(TriangleMesh mesh) => new(Vertices(mesh), Indices(mesh, true));

    public static TriangleMesh Joined(params (TriangleMesh Mesh, Vector3 At)[] pieces)
    {
        var points = new List<Vector3>();
        var indices = new List<int>();
        foreach ((TriangleMesh mesh, Vector3 at) in pieces)
        {
            indices.AddRange(Indices(mesh).Select(i => points.Count + i));
            points.AddRange(Vertices(mesh).Select(v => v + at));
        }

        return new TriangleMesh(points, indices);
    }

    private static TriangleMesh Rock(int seed, float radius, float rough)
    {
        var random = new Rng((ulong)seed);
        Vector3[] waves = [.. Enumerable.Range(0, 5).Select(_ => random.Vector(6))];
        return Ball(12, 20, d => radius * (1 + rough / 2 * waves.Sum(w => MathF.Sin(Vector3.Dot(w, d)))));
    }

    private static TriangleMesh Ball(int rings, int around, Func<Vector3, float> radius)
    {
        var points = new List<Vector3>();
        var indices = new List<int>();
        int At(int ring, int i) => ring == 0 ? 0 : ring == rings ? 1 : 2 + (ring - 1) * around + i % around;
        void Add(double down, double turn)
        {
            var d = new Vector3(
                (float)(Math.Sin(down) * Math.Cos(turn)), (float)Math.Cos(down),
                (float)(Math.Sin(down) * Math.Sin(turn)));
            points.Add(d * radius(d));
        }

        Add(0, 0);
        Add(Math.PI, 0);
        for (int ring = 0; ring < rings; ring++)
        {
            for (int i = 0; i < around; i++)
            {
                if (ring > 0) Add(Math.PI * ring / rings, 2 * Math.PI * i / around);
                if (ring > 0) indices.AddRange([At(ring, i), At(ring, i + 1), At(ring + 1, i)]);
                if (ring + 1 < rings) indices.AddRange([At(ring, i + 1), At(ring + 1, i + 1), At(ring + 1, i)]);
            }
        }

        return new TriangleMesh(points, indices);
    }

    /// <summary>A prism with teeth about the y axis.</summary>
    private static TriangleMesh Gear(int teeth, float inner, float outer, float half)
    {
        int n = 4 * teeth;
        var points = new List<Vector3>();
        var indices = new List<int>();
        foreach (float height in new[] { -half, half })
        {
            for (int i = 0; i < n; i++)
            {
                (float sin, float cos) = MathF.SinCos(MathF.Tau * i / n);
                float radius = i % 4 < 2 ? outer : inner;
                points.Add(new Vector3(radius * cos, height, radius * sin));
            }

            points.Add(new Vector3(0, height, 0));
        }

        for (int i = 0; i < n; i++)
        {
            int j = (i + 1) % n, up = n + 1;
            indices.AddRange([n, i, j, up + n, up + j, up + i, i, up + i, j, j, up + i, up + j]);
        }

        return new TriangleMesh(points, indices);
    }

    public static Vector3[] Vertices(TriangleMesh mesh) =>
        [.. Enumerable.Range(0, mesh.VertexCount).Select(mesh.GetVertex)];

    public static List<int> Indices(TriangleMesh mesh, bool isFlipped = false)
    {
        var indices = new List<int>();
        for (int i = 0; i < mesh.TriangleCount; i++)
        {
            mesh.GetTriangle(i, out int a, out int b, out int c);
            indices.AddRange(isFlipped ? [a, c, b] : new[] { a, b, c });
        }

        return indices;
    }
}
