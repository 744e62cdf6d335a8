namespace Gjk.Core;

/// <summary>Any shape, convex or not, as one type: a convex shape, the surface of a triangle mesh, the solid inside a
/// closed one, or a compound.</summary>
/// <remarks>Immutable, but for the heights of a mesh (<see cref="HeightField.SetHeights"/>). Copies share the mesh or
/// compound. Parts have numbers: those of the mesh's triangles or of the compound's parts, as the caller gave them; a
/// convex shape's number is -1.</remarks>
public readonly struct AnyShape
{
    private readonly ConvexShape _convex;

    private AnyShape(AnyShapeKind kind, in ConvexShape convex, TriangleMesh? mesh, CompoundShape? compound)
    {
        Kind = kind;
        _convex = convex;
        Mesh = mesh;
        Compound = compound;
    }

    /// <summary>What it is.</summary>
    public AnyShapeKind Kind { get; }

    /// <summary>The convex shape; a <c>default</c> struct in the other kinds.</summary>
    public ConvexShape Convex => _convex;

    /// <summary>The mesh of a surface or a solid, else null.</summary>
    public TriangleMesh? Mesh { get; }

    /// <summary>The compound, else null.</summary>
    public CompoundShape? Compound { get; }

    /// <summary>A convex shape.</summary>
    /// <exception cref="ArgumentException">The shape is a <c>default</c> struct.</exception>
    public static AnyShape Of(in ConvexShape shape) =>
        shape.Kind != ShapeKind.None
            ? new AnyShape(AnyShapeKind.Convex, shape, null, null)
            : throw new ArgumentException("A default ConvexShape is no shape.", nameof(shape));

    /// <summary>The union of a mesh's triangles, without what they enclose.</summary>
    /// <exception cref="ArgumentNullException">The mesh is null.</exception>
    public static AnyShape Surface(TriangleMesh mesh) =>
        new(AnyShapeKind.Surface, default, Guard.NotNull(mesh, nameof(mesh)), null);

    /// <summary>The triangles of a closed mesh, and what they enclose.</summary>
    /// <exception cref="ArgumentNullException">The mesh is null.</exception>
    /// <exception cref="ArgumentException">The mesh has no inside; the message names an edge.</exception>
    public static AnyShape Solid(TriangleMesh mesh)
    {
        string? reason = Guard.NotNull(mesh, nameof(mesh)).WhyNoInside;
        if (reason is not null) throw new ArgumentException(reason, nameof(mesh));
        return new AnyShape(AnyShapeKind.Solid, default, mesh, null);
    }

    /// <summary>The union of a compound's parts.</summary>
    /// <exception cref="ArgumentNullException">The compound is null.</exception>
    public static AnyShape Of(CompoundShape compound) =>
        new(AnyShapeKind.Compound, default, null, Guard.NotNull(compound, nameof(compound)));

    /// <summary>The convex shape's text, or the kind and the number of triangles or parts, as "Solid of 12
    /// triangles".</summary>
    public override string ToString() => Kind switch
    {
        AnyShapeKind.Surface or AnyShapeKind.Solid => FormattableString.Invariant($"{Kind} of {PartCount} triangles"),
        AnyShapeKind.Compound => FormattableString.Invariant($"{Kind} of {PartCount} parts"),
        _ => _convex.ToString(),
    };

    /// <summary>How many parts it has: triangles, a compound's parts, or 1.</summary>
    public int PartCount => Mesh?.TriangleCount ?? Compound?.PartCount ?? (Kind == AnyShapeKind.Convex ? 1 : 0);

    /// <summary>Volume, mass, centre of mass and inertia, as the convex shape, the solid mesh or the compound gives
    /// them.</summary>
    /// <param name="density">Mass in a unit of volume; at least 0 and finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">The density is negative, NaN or infinite.</exception>
    /// <exception cref="InvalidOperationException">This is a surface, a <c>default</c> struct, or what
    /// <see cref="ConvexShape.GetMassProperties"/> refuses.</exception>
    public MassProperties GetMassProperties(float density = 1) => Kind switch
    {
        AnyShapeKind.Solid => Mesh!.GetMassProperties(density),
        AnyShapeKind.Compound => Compound!.GetMassProperties(density),
        AnyShapeKind.Surface => throw new InvalidOperationException("A surface has no mass; make a solid of the mesh."),
        _ => _convex.GetMassProperties(density),
    };

    /// <summary>What it holds besides its parts.</summary>
    internal SolidInside[] Insides => Kind == AnyShapeKind.Solid ? Mesh!.Insides : Compound?.Insides ?? [];

    /// <summary>A part as a convex shape of its own; of a convex shape the whole.</summary>
    internal ConvexShape PartAt(int part) =>
        Mesh is not null ? Mesh.GetShape(part) : Compound is not null ? Compound.Parts[part] : _convex;

    /// <summary>The convex shape, without a copy.</summary>
    internal static ref readonly ConvexShape ConvexOf(in AnyShape shape) => ref shape._convex;
}

/// <summary>What an <see cref="AnyShape"/> is.</summary>
public enum AnyShapeKind : byte
{
    /// <summary>Nothing: a <c>default</c> struct, which no query accepts.</summary>
    None = 0,

    /// <summary>One convex shape.</summary>
    Convex = 1,

    /// <summary>The union of a mesh's triangles.</summary>
    Surface = 2,

    /// <summary>A mesh's triangles and all points about which its winding number is not 0.</summary>
    Solid = 3,

    /// <summary>The union of convex parts, triangles and solids, each in its place.</summary>
    Compound = 4,
}
