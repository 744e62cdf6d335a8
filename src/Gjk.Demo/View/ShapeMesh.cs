namespace Gjk.Demo.View;

/// <summary>The surface of a shape for drawing, in its own frame with its scale. A mesh is drawn as its hull, and as
/// its own triangles where it is a surface. A curved shape is drawn as the hull of some of its support
/// points.</summary>
internal sealed class ShapeMesh
{
    /// <summary>Two triangles are one flat facet if the cosine between their normals is above this value. This is an
    /// angle of 0.5 degrees.</summary>
    private const double FlatCosine = 0.99996;

    /// <summary>The same for the facets of a curved shape, which are steps of 7.5 or 15 degrees. An edge, such as a
    /// cylinder's rim, is 30 degrees or more.</summary>
    private const double SmoothCosine = 0.866;

    private ShapeMesh(ConvexHull hull, Vector3 scale, bool isSmooth)
    {
        IsSmooth = isSmooth;
        Dimension = hull.Dimension;
        Vertices = new Vector3[hull.VertexCount];
        for (int i = 0; i < Vertices.Length; i++) Vertices[i] = hull.GetVertex(i) * scale;
        bool mirrored = scale.X * scale.Y * scale.Z < 0;
        Triangles = new int[3 * hull.TriangleCount];
        for (int i = 0; i < hull.TriangleCount; i++)
        {
            hull.GetTriangle(i, out int a, out int b, out int c);
            (Triangles[3 * i], Triangles[3 * i + 1], Triangles[3 * i + 2]) = mirrored ? (a, c, b) : (a, b, c);
        }

        Edges = hull.Dimension == 1 ? [0, 1] : FindEdges(isSmooth ? SmoothCosine : FlatCosine);
        Radius = FindRadius();
    }

    /// <summary>All triangles of a mesh with all their edges. A triangle is a part.</summary>
    private ShapeMesh(TriangleMesh mesh)
    {
        Dimension = 2;
        Vertices = new Vector3[mesh.VertexCount];
        for (int i = 0; i < Vertices.Length; i++) Vertices[i] = mesh.GetVertex(i) * mesh.Scale;
        Triangles = new int[3 * mesh.TriangleCount];
        PartStarts = new int[mesh.TriangleCount + 1];
        var edges = new HashSet<(int, int)>();
        for (int i = 0; i < mesh.TriangleCount; i++)
        {
            mesh.GetTriangle(i, out int a, out int b, out int c);
            (Triangles[3 * i], Triangles[3 * i + 1], Triangles[3 * i + 2]) = (a, b, c);
            foreach ((int p, int q) in (ReadOnlySpan<(int, int)>)[(a, b), (b, c), (c, a)])
                edges.Add((Math.Min(p, q), Math.Max(p, q)));
            PartStarts[i + 1] = i + 1;
        }

        var ends = new List<int>(2 * edges.Count);
        foreach ((int p, int q) in edges) ends.AddRange([p, q]);
        Edges = ends.ToArray();
        Radius = FindRadius();
    }

    /// <summary>The parts of a compound, one after the other.</summary>
    private ShapeMesh(CompoundShape compound, bool isCoarse)
    {
        var vertices = new List<Vector3>();
        List<int> triangles = [], edges = [], starts = [0];
        for (int i = 0; i < compound.PartCount; i++)
        {
            ShapeMesh part = Of(compound.GetPart(i), isCoarse);
            Dimension = Math.Max(Dimension, Math.Max(part.Dimension, 2));
            IsSmooth |= part.IsSmooth;
            foreach (int vertex in part.Triangles) triangles.Add(vertices.Count + vertex);
            foreach (int vertex in part.Edges) edges.Add(vertices.Count + vertex);
            starts.Add(triangles.Count / 3);
            vertices.AddRange(part.Vertices);
        }

        (Vertices, Triangles, Edges) = (vertices.ToArray(), triangles.ToArray(), edges.ToArray());
        PartStarts = starts.ToArray();
        Radius = FindRadius();
    }

    public Vector3[] Vertices { get; }

    /// <summary>Three vertices per triangle, counter-clockwise seen from outside. A flat shape has both
    /// sides.</summary>
    public int[] Triangles { get; }

    /// <summary>Two vertices per edge. An edge is where the surface has a crease, not where a flat facet is cut into
    /// triangles.</summary>
    public int[] Edges { get; }

    /// <summary>The first triangle of each part of a surface or a compound, and then how many triangles there are.
    /// Empty for a convex shape. A part that is a point or a segment has no triangles.</summary>
    public int[] PartStarts { get; } = [];

    /// <summary>0 is a point, 1 a segment, 2 flat or open, 3 solid.</summary>
    public int Dimension { get; }

    /// <summary>True if the triangles stand for a curved surface.</summary>
    public bool IsSmooth { get; }

    /// <summary>The radius about the local origin.</summary>
    public double Radius { get; }

    public static ShapeMesh Of(in AnyShape shape, bool isCoarse) =>
        shape.Mesh is TriangleMesh mesh ? new ShapeMesh(mesh)
        : shape.Compound is CompoundShape compound ? new ShapeMesh(compound, isCoarse)
        : Of(shape.Convex, isCoarse);

    public static ShapeMesh Of(in ConvexShape shape, bool isCoarse = false)
    {
        if (shape.Kind == ShapeKind.Mesh && !shape.IsDecorated)
            return new ShapeMesh(shape.Hull!, shape.Scale, isSmooth: false);
        List<Vector3> points = SupportSamples.Of(shape, isCoarse);
        return new ShapeMesh(new ConvexHull(points), Vector3.One, SupportSamples.IsCurved(shape));
    }

    /// <summary>The surface of a hull.</summary>
    public static ShapeMesh Of(ConvexHull hull, bool isSmooth) => new(hull, Vector3.One, isSmooth);

    /// <summary>The normal of a triangle. Its length is arbitrary. The differences of the corners are computed in
    /// double.</summary>
    public Double3 Normal(int triangle)
    {
        Double3 a = Vertices[Triangles[3 * triangle]];
        return Double3.Cross(Vertices[Triangles[3 * triangle + 1]] - a, Vertices[Triangles[3 * triangle + 2]] - a);
    }

    /// <summary>The neighbour of each triangle across each side. The sides are those of corners 0 and 1, 1 and 2, 2 and
    /// 0.</summary>
    public int[] Neighbours()
    {
        // Both faces of a flat shape have the same sides inside. There the neighbour is the triangle on the same face.
        var sides = new Dictionary<(int From, int To, bool IsBack), int>(Triangles.Length);
        for (int i = 0; i < Triangles.Length; i++) sides[(Triangles[i], Triangles[Next(i)], IsBack(i / 3))] = i / 3;
        var across = new int[Triangles.Length];
        for (int i = 0; i < across.Length; i++)
        {
            (int from, int to, bool isBack) = (Triangles[Next(i)], Triangles[i], IsBack(i / 3));
            across[i] = sides.TryGetValue((from, to, isBack), out int same) ? same : sides[(from, to, !isBack)];
        }

        return across;
    }

    /// <summary>True if a triangle of a flat shape is on the other side than its first triangle.</summary>
    private bool IsBack(int triangle) => Dimension == 2 && Double3.Dot(Normal(triangle), Normal(0)) < 0;

    /// <summary>The next corner of the same triangle.</summary>
    public static int Next(int corner) => corner % 3 == 2 ? corner - 2 : corner + 1;

    private double FindRadius()
    {
        double radius = 0;
        foreach (Vector3 v in Vertices) radius = Math.Max(radius, ((Double3)v).Length);
        return radius;
    }

    private int[] FindEdges(double cosine)
    {
        int[] across = Neighbours();
        var edges = new List<int>();
        for (int i = 0; i < across.Length; i++)
        {
            if (Triangles[i] > Triangles[Next(i)]) continue;
            Double3 n = Normal(i / 3), m = Normal(across[i]);
            if (Double3.Dot(n, m) >= cosine * n.Length * m.Length) continue;
            edges.Add(Triangles[i]);
            edges.Add(Triangles[Next(i)]);
        }

        return edges.ToArray();
    }
}
