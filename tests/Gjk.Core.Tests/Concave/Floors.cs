namespace Gjk.Core.Tests.Concave;

/// <summary>Flat floors at height 0, from 0 to 3 along x and z, made in the ways in which editors and exporters make
/// them.</summary>
internal static class Floors
{
    private const int Cells = 6;

    private const float Cell = 0.5f;

    public static AnyShape Named(string name) => name switch
    {
        "doubled" => AnyShape.Surface(Again((a, b, c) => [a, b, c])),
        "two-sided" => AnyShape.Surface(Again((a, b, c) => [a, c, b])),
        "slivers of 1e-7" => AnyShape.Surface(Strips(0, 1e-7f)),
        "slivers of 1e-6" => AnyShape.Surface(Strips(0, 1e-6f)),
        "filled T-junctions" => AnyShape.Surface(Strips(0, 0)),
        "turned filled T-junctions" => AnyShape.Surface(Strips(0.3, 0)),
        "T-junctions" => AnyShape.Surface(Strips(0, 0, isFilled: false)),
        "turned T-junctions" => AnyShape.Surface(Strips(0.3, 0, isFilled: false)),
        "bricks" => AnyShape.Surface(Bricks(0.3)),
        "tiles" => AnyShape.Of(new CompoundShape(Tiles(0))),
        "tiles with steps of 1e-6" => AnyShape.Of(new CompoundShape(Tiles(1e-6f))),
        "joined boxes" => AnyShape.Solid(Joined()),
        _ => AnyShape.Surface(Plate()),
    };

    public static List<CompoundPart> Tiles(float step)
    {
        var tiles = new List<CompoundPart>();
        for (int i = 0; i < Cells * Cells; i++)
        {
            var at = new Vector3(
                (i / Cells + 0.5f) * Cell, -0.2f - (i / Cells + i) % 2 * step, (i % Cells + 0.5f) * Cell);
            tiles.Add(new CompoundPart(ConvexShape.Box(new Vector3(0.25f, 0.2f, 0.25f)), new RigidPose(at)));
        }

        return tiles;
    }

    public static TriangleMesh Plate() =>
        TriangleMesh.FromHeights(new float[(Cells + 1) * (Cells + 1)], Cells + 1, new Vector2(Cell));

    /// <summary>The plate and each of its triangles again.</summary>
    private static TriangleMesh Again(Func<int, int, int, int[]> again)
    {
        TriangleMesh plate = Plate();
        var indices = new List<int>();
        for (int i = 0; i < plate.TriangleCount; i++)
        {
            plate.GetTriangle(i, out int a, out int b, out int c);
            indices.AddRange([a, b, c, .. again(a, b, c)]);
        }

        return new TriangleMesh(Solids.Vertices(plate), indices);
    }

    /// <summary>Rows of rectangles along x, each row shifted against the one before: corners lie on edges of both
    /// sides.</summary>
    private static TriangleMesh Bricks(double turn)
    {
        var points = new List<Vector3>();
        var indices = new List<int>();
        for (int i = 0; i < 4 * Cells; i++)
        {
            (int row, int k) = (i / 4, i % 4);
            float x = k - 0.3f * (row % 3), z = row * Cell;
            int a = points.Count;
            points.AddRange([Turned(x, z, turn), Turned(x + 1, z, turn)]);
            points.AddRange([Turned(x, z + Cell, turn), Turned(x + 1, z + Cell, turn)]);
            indices.AddRange([a, a + 2, a + 1, a + 1, a + 2, a + 3]);
        }

        return new TriangleMesh(points, indices);
    }

    /// <summary>Strips along x, all but the first with a vertex on its near side, moved off the side by a height; a
    /// thin triangle fills what that leaves between it and the strip before, unless it is left open.</summary>
    private static TriangleMesh Strips(double turn, float height, bool isFilled = true)
    {
        var points = new List<Vector3>();
        var indices = new List<int>();
        for (int i = 0; i < Cells; i++)
        {
            int a = points.Count, middle = a + 4;
            foreach (float z in new[] { i * Cell, (i + 1) * Cell })
                points.AddRange([Turned(0, z, turn), Turned(3, z, turn)]);
            if (i == 0)
            {
                indices.AddRange([a, a + 2, a + 1, a + 1, a + 2, a + 3]);
                continue;
            }

            points.Add(Turned(1.3f, i * Cell + height, turn) + new Vector3(0, 0.1f * height, 0));
            indices.AddRange([a + 2, middle, a, a + 2, a + 1, middle, a + 1, a + 2, a + 3]);
            if (isFilled) indices.AddRange([a, middle, a + 1]);
        }

        return new TriangleMesh(points, indices);
    }

    private static Vector3 Turned(float x, float z, double angle)
    {
        double sine = Math.Sin(angle), cosine = Math.Cos(angle), u = x - 1.5, w = z - 1.5;
        return new((float)(1.5 + cosine * u + sine * w), 0, (float)(1.5 - sine * u + cosine * w));
    }

    /// <summary>Two closed boxes side by side in one mesh, with the wall between them there once each way.</summary>
    private static TriangleMesh Joined() => Solids.Joined(
        (ConcaveShapes.Box(new Vector3(0.75f, 0.5f, 1.5f)), new Vector3(0.75f, -0.5f, 1.5f)),
        (ConcaveShapes.Box(new Vector3(0.75f, 0.5f, 1.5f)), new Vector3(2.25f, -0.5f, 1.5f)));
}
