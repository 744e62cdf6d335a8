namespace Gjk.Import;

/// <summary>The shape of an object in its own frame, in numbers. Immutable.</summary>
public sealed record ImportedShape
{
    private ImportedShape(ShapeKind kind) => Kind = kind;

    /// <summary>Box, Sphere, Capsule, Cylinder, Ellipsoid or Mesh.</summary>
    public ShapeKind Kind { get; }

    /// <summary>Of a sphere, a capsule or a cylinder; else 0.</summary>
    public float Radius { get; private init; }

    /// <summary>Of a capsule, without its caps, or a cylinder, along y; else 0.</summary>
    public float HalfHeight { get; private init; }

    /// <summary>The half extents of a box or the radii of an ellipsoid; else 0.</summary>
    public Vector3 Sizes { get; private init; }

    /// <summary>The mesh, or null. As a convex shape it is its hull.</summary>
    public ImportedMesh? Mesh { get; private init; }

    /// <summary>True if the file says that the hull of the mesh is meant: a MeshCollider with Convex ticked.</summary>
    public bool IsHull { get; private init; }

    /// <summary>Turns the shape before the object's scale. Length 1.</summary>
    public Quaternion Rotation { get; internal init; } = Quaternion.Identity;

    /// <summary>A float may have overflowed.</summary>
    internal bool IsFinite =>
        float.IsFinite(Radius) && float.IsFinite(HalfHeight) && float.IsFinite(Sizes.X + Sizes.Y + Sizes.Z);

    /// <summary>The shape in the object's frame, without the object's scale.</summary>
    public ConvexShape ToConvexShape()
    {
        ConvexShape shape = Kind switch
        {
            ShapeKind.Box => ConvexShape.Box(Sizes),
            ShapeKind.Sphere => ConvexShape.Sphere(Radius),
            ShapeKind.Capsule => ConvexShape.Capsule(Radius, HalfHeight),
            ShapeKind.Cylinder => ConvexShape.Cylinder(Radius, HalfHeight),
            ShapeKind.Ellipsoid => ConvexShape.Ellipsoid(Sizes),
            _ => ConvexShape.Mesh(Mesh!.Hull),
        };
        return Rotation == Quaternion.Identity ? shape : shape.Placed(new RigidPose(Rotation, Vector3.Zero));
    }

    internal static ImportedShape Sphere(double radius) => new(ShapeKind.Sphere) { Radius = (float)radius };

    internal static ImportedShape Capsule(double radius, double halfHeight) =>
        new(ShapeKind.Capsule) { Radius = (float)radius, HalfHeight = (float)halfHeight };

    internal static ImportedShape Cylinder(double radius, double halfHeight) =>
        new(ShapeKind.Cylinder) { Radius = (float)radius, HalfHeight = (float)halfHeight };

    internal static ImportedShape Box(Vector3 halfExtents) => new(ShapeKind.Box) { Sizes = halfExtents };

    internal static ImportedShape Ellipsoid(Vector3 radii) => new(ShapeKind.Ellipsoid) { Sizes = radii };

    internal static ImportedShape OfMesh(ImportedMesh mesh, bool isHull) =>
        new(ShapeKind.Mesh) { Mesh = mesh, IsHull = isHull };
}
