namespace Gjk.Core;

/// <summary>What a <see cref="ConvexShape"/> holds.</summary>
public enum ShapeKind : byte
{
    /// <summary>Nothing: a <c>default</c> struct, which no query accepts.</summary>
    None = 0,

    /// <summary>A point, or with a margin a sphere.</summary>
    Point,

    /// <summary>A segment, or with a margin a capsule.</summary>
    Segment,

    /// <summary>A triangle.</summary>
    Triangle,

    /// <summary>A box.</summary>
    Box,

    /// <summary>A cylinder.</summary>
    Cylinder,

    /// <summary>A cone.</summary>
    Cone,

    /// <summary>An ellipsoid.</summary>
    Ellipsoid,

    /// <summary>A convex mesh.</summary>
    Mesh,
}
