namespace Gjk.Exact.Fuzz;

/// <summary>A shape where it is, seen without the library's hulls, supports and solvers: a rotation matrix of its own,
/// the points that the shape was made of, and heights found by looking at all of them. Nothing here depends on the
/// shape's bounding radius, which may be generous.</summary>
internal sealed class PosedShape
{
    private readonly ConvexShape _shape;
    private readonly Double3[] _fromCenter;
    private readonly CurvedHeights? _curved;
    private readonly ApproximateRotation _rotation;

    public PosedShape(in FuzzShape shape, in RigidPose pose)
    {
        _shape = shape.Shape;
        _rotation = new ApproximateRotation(pose.Rotation);
        Position = pose.Position;
        Vertices = ListVertices(shape);
        if (Vertices.Length == 0) _curved = new CurvedHeights(_shape);
        else Center = Middle(Vertices);
        _fromCenter = Array.ConvertAll(Vertices, v => v - Center);
        Sides = new Double3(Side(new Double3(1, 0, 0)), Side(new Double3(0, 1, 0)), Side(new Double3(0, 0, 1)));
    }

    public Double3 Position { get; }

    /// <summary>The middle of the local bounding box; the local origin of a curved shape.</summary>
    public Double3 Center { get; }

    public double Margin => _shape.Margin;

    /// <summary>In the local frame, scale applied, as the shape was given; empty where the core is curved.</summary>
    public Double3[] Vertices { get; }

    public bool IsCurved => _curved is not null;

    /// <summary>The sides of the local bounding box, margin included.</summary>
    public Double3 Sides { get; }

    /// <summary>The largest magnitude of each local coordinate.</summary>
    public Double3 Extents =>
        new(Math.Abs(Center.X) + 0.5 * Sides.X, Math.Abs(Center.Y) + 0.5 * Sides.Y, Math.Abs(Center.Z) + 0.5 * Sides.Z);

    public double LongestSide => Math.Max(Sides.X, Math.Max(Sides.Y, Sides.Z));

    /// <summary>Half the diagonal of the local bounding box: a ball about the centre that holds the shape.</summary>
    public double Radius => 0.5 * Sides.Length;

    public Double3 Rotate(in Double3 v) => _rotation.Rotate(v);

    public Double3 InverseRotate(in Double3 v) => _rotation.InverseRotate(v);

    /// <summary>How far the shape reaches beyond its centre along a unit direction of the world.</summary>
    public double Height(in Double3 direction) => CoreHeight(InverseRotate(direction)) + Margin;

    /// <summary>The same for the core, without the margin, along a direction of the local frame.</summary>
    public double CoreHeight(in Double3 direction)
    {
        if (_curved is not null) return _curved.Of(direction);
        double most = double.NegativeInfinity;
        foreach (Double3 v in _fromCenter) most = Math.Max(most, Double3.Dot(direction, v));
        return most;
    }

    /// <summary>The most that a local point exceeds the shape by along any of the directions, or along that from the
    /// centre; all of them in the local frame.</summary>
    public double Outside(in Double3 local, ReadOnlySpan<Double3> directions)
    {
        Double3 outward = local - Center;
        double length = outward.Length, most = length > 0 ? length - CoreHeight(outward * (1 / length)) - Margin : 0;
        foreach (Double3 u in directions) most = Math.Max(most, Double3.Dot(u, outward) - CoreHeight(u) - Margin);
        return outward.IsFinite ? most : double.PositiveInfinity;
    }

    /// <summary>The directions across up to <paramref name="most"/> triangles of a mesh's surface, in the local
    /// frame.</summary>
    public IEnumerable<Double3> FaceNormals(int most)
    {
        if (_shape.Hull is not { } hull) yield break;
        int step = Math.Max(1, hull.TriangleCount / most);
        Double3 factors = _shape.Scale;
        for (int i = 0; i < hull.TriangleCount; i += step)
        {
            hull.GetTriangle(i, out int a, out int b, out int c);
            Double3 corner = hull.GetVertex(a), ab = hull.GetVertex(b) - corner, ac = hull.GetVertex(c) - corner;
            Double3 n = Double3.Cross(Double3.Multiply(factors, ab), Double3.Multiply(factors, ac));
            double length = n.Length;
            if (length > 0) yield return n * (1 / length);
        }
    }

    /// <summary>How many directions <see cref="EdgeDirections"/> has; none where the core is curved.</summary>
    public int EdgeCount =>
        _shape.Hull is { TriangleCount: > 0 } hull
            ? 3 * hull.TriangleCount / 2
            : Vertices.Length * (Vertices.Length - 1) / 2;

    /// <summary>Along the sides of a mesh's triangles, and without triangles along the differences of all vertices, in
    /// the local frame: every edge of the core is along one of them.</summary>
    public List<Double3> EdgeDirections()
    {
        var edges = new List<Double3>(EdgeCount);
        if (_shape.Hull is { TriangleCount: > 0 } hull)
        {
            for (int i = 0; i < hull.TriangleCount; i++)
            {
                hull.GetTriangle(i, out int a, out int b, out int c);
                if (a < b) edges.Add(Side(hull, a, b));
                if (b < c) edges.Add(Side(hull, b, c));
                if (c < a) edges.Add(Side(hull, c, a));
            }

            return edges;
        }

        for (int i = 0; i < Vertices.Length; i++)
        {
            for (int j = i + 1; j < Vertices.Length; j++) edges.Add(Vertices[j] - Vertices[i]);
        }

        return edges;
    }

    private Double3 Side(ConvexHull hull, int from, int to) =>
        Double3.Multiply(_shape.Scale, (Double3)hull.GetVertex(to) - hull.GetVertex(from));

    private double Side(in Double3 axis) => CoreHeight(axis) + CoreHeight(-axis) + 2 * Margin;

    private static Double3 Middle(Double3[] vertices)
    {
        Double3 low = vertices[0], high = low;
        foreach (Double3 v in vertices)
        {
            low = new Double3(Math.Min(low.X, v.X), Math.Min(low.Y, v.Y), Math.Min(low.Z, v.Z));
            high = new Double3(Math.Max(high.X, v.X), Math.Max(high.Y, v.Y), Math.Max(high.Z, v.Z));
        }

        return (low + high) * 0.5;
    }

    private static Double3[] ListVertices(in FuzzShape shape)
    {
        if (shape.Cloud is { } cloud)
        {
            var scaled = new Double3[cloud.Count];
            Double3 factors = shape.Scale;
            for (int i = 0; i < scaled.Length; i++) scaled[i] = Double3.Multiply(factors, cloud[i]);
            return scaled;
        }

        // Segments, boxes and the like: the library multiplies the scale in without rounding, and has at most eight of
        // them.
        var vertices = new List<Double3>();
        for (int id = 0; shape.Shape.TryGetVertex(id, out Double3 vertex); id++)
            vertices.Add(shape.Shape.Center + vertex);
        return [.. vertices];
    }
}
