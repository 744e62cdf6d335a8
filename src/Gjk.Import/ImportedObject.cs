namespace Gjk.Import;

/// <summary>A named shape in its place. Immutable.</summary>
public sealed record ImportedObject
{
    internal ImportedObject(string name, ImportedShape shape, in Affine world, in TurnD rotation)
    {
        Name = name;
        Shape = shape;
        Position = (Vector3)world.Origin;
        Rotation = rotation.ToFloat();
        Scale = Vector3.One;
    }

    /// <summary>As the file names it, with a number behind it where another object has that name, too.</summary>
    public string Name { get; internal init; }

    /// <summary>The shape before <see cref="Scale"/>.</summary>
    public ImportedShape Shape { get; }

    /// <summary>Position in the file's world.</summary>
    public Vector3 Position { get; }

    /// <summary>Rotation in the file's world, of length 1.</summary>
    public Quaternion Rotation { get; }

    /// <summary>Scale along the object's own axes. No factor is 0; negative ones mirror.</summary>
    public Vector3 Scale { get; internal init; }

    /// <summary>Pose in the file's world.</summary>
    public RigidPose Pose => new(Rotation, Position);

    internal bool IsFinite => Shape.IsFinite && ((Double3)Position).IsFinite && ((Double3)Scale).IsFinite;

    /// <summary>The shape with its scale, for queries at <see cref="Pose"/>. Objects that share a mesh share its
    /// hull.</summary>
    public ConvexShape ToConvexShape() =>
        Scale == Vector3.One ? Shape.ToConvexShape() : Shape.ToConvexShape().Scaled(Scale);

    /// <summary>The shape as it is, with its scale, for queries at <see cref="Pose"/>: a mesh by its triangles, solid
    /// where they close, else a surface; what is no mesh, or has no triangles, or is a hull in its file, is convex.
    /// Each call builds a mesh anew.</summary>
    public AnyShape ToAnyShape()
    {
        if (Shape is not { Mesh: { Triangles.Count: > 0 } read, IsHull: false }) return AnyShape.Of(ToConvexShape());
        var mesh = new TriangleMesh(read.Vertices, read.Triangles);
        if (Scale != Vector3.One) mesh = mesh.Scaled(Scale);
        return mesh.HasInside ? AnyShape.Solid(mesh) : AnyShape.Surface(mesh);
    }
}
