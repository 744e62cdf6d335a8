namespace Gjk.Bench.Scenes;

/// <summary>A shape with a point inside it, and the triangles of its surface if it has any.</summary>
internal sealed class DepthBody
{
    private readonly ConvexHull? _surface;

    private DepthBody(in ConvexShape shape, ConvexHull? surface, Double3 inside)
    {
        Shape = shape;
        _surface = surface;
        Inside = inside;
    }

    public ConvexShape Shape { get; }

    /// <summary>The mean of the corners. It lies inside, unlike the middle of the bounding box.</summary>
    public Double3 Inside { get; }

    /// <summary>Half the sides of a box. Zero for other shapes.</summary>
    public Vector3 Half { get; private init; }

    /// <summary>True for boxes and meshes.</summary>
    public bool HasFaces => _surface is not null;

    public static DepthBody Box(Vector3 half) =>
        new(ConvexShape.Box(half), new ConvexHull(MeshVertices.Box(half)), default) { Half = half };

    public static DepthBody Mesh(Vector3[] vertices)
    {
        var hull = new ConvexHull(vertices);
        Double3 sum = vertices.Aggregate(default(Double3), (total, v) => total + v);
        return new DepthBody(ConvexShape.Mesh(hull), hull, sum * (1.0 / vertices.Length));
    }

    /// <summary>Random corners on an ellipsoid, or on a ball.</summary>
    public static DepthBody Hull(Prng prng, int vertices, Vector3 radii) =>
        Mesh(MeshVertices.OnEllipsoid(prng, vertices, radii));

    public static DepthBody Sphere(float radius) => new(ConvexShape.Sphere(radius), null, default);

    public static DepthBody Capsule(float radius, float halfHeight) =>
        new(ConvexShape.Capsule(radius, halfHeight), null, default);

    /// <summary>Any other shape, about its own origin.</summary>
    public static DepthBody Curved(in ConvexShape shape) => new(shape, null, default);

    /// <summary>The furthest point of the surface, margin included, in the shape's frame.</summary>
    public Double3 Furthest(in Double3 direction)
    {
        Shape.Support(direction, out Double3 fromCenter);
        return Shape.Center + fromCenter + direction * (Shape.Margin / direction.Length);
    }

    /// <summary>A random point of a random face, and the face's outward unit normal.</summary>
    public Double3 OnFace(Prng prng, out Double3 normal)
    {
        ConvexHull surface = _surface ?? throw new InvalidOperationException("The shape has no faces.");
        surface.GetTriangle(prng.Index(surface.TriangleCount), out int a, out int b, out int c);
        Double3 first = surface.GetVertex(a), toB = surface.GetVertex(b) - first, toC = surface.GetVertex(c) - first;
        normal = Double3.Cross(toB, toC);
        normal *= 1 / normal.Length;
        double u = prng.Range(0, 1), v = prng.Range(0, 1);
        if (u + v > 1) (u, v) = (1 - u, 1 - v);
        return first + u * toB + v * toC;
    }
}
