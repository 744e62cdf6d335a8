namespace Gjk.Core;

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
