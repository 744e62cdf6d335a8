namespace Gjk.Exact.Fuzz;

/// <summary>A shape of the library beside the points that its mesh was made of, so that the library's hull itself is
/// under test.</summary>
internal readonly struct FuzzShape
{
    private FuzzShape(in ConvexShape shape, IReadOnlyList<Vector3>? cloud)
    {
        Shape = shape;
        Cloud = cloud;
    }

    public ConvexShape Shape { get; }

    /// <summary>A mesh's points as they were given, repeats and inner ones included, without the scale; null for what
    /// is no mesh.</summary>
    public IReadOnlyList<Vector3>? Cloud { get; }

    public ShapeKind Kind => Shape.Kind;

    public Vector3 Scale => Shape.Scale;

    /// <summary>Where only the hull is known, its corners are the cloud.</summary>
    public static implicit operator FuzzShape(in ConvexShape shape) =>
        new(shape, shape.Hull is { } hull ? Corners(hull) : null);

    public static FuzzShape Mesh(IReadOnlyList<Vector3> cloud) => new(ConvexShape.Mesh(cloud), cloud);

    /// <summary>A mesh that was built before, with the points that it was made of.</summary>
    public static FuzzShape Of(in ConvexShape shape, IReadOnlyList<Vector3> cloud) => new(shape, cloud);

    /// <summary>With a scale; the shape must have none yet.</summary>
    public FuzzShape Scaled(Vector3 factors) => new(Shape.Scaled(factors), Cloud);

    private static Vector3[] Corners(ConvexHull hull)
    {
        var corners = new Vector3[hull.VertexCount];
        for (int i = 0; i < corners.Length; i++) corners[i] = hull.GetVertex(i);
        return corners;
    }
}
