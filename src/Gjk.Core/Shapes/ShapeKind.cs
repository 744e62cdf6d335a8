namespace Gjk.Core;

/// <summary>What a <see cref="ConvexShape"/> is, or what it was before it was rounded, placed or scaled.</summary>
public enum ShapeKind : byte
{
    /// <summary>Nothing: a <c>default</c> struct, which no query accepts.</summary>
    None = 0,

    /// <summary>A point.</summary>
    Point = 1,

    /// <summary>A segment.</summary>
    Segment = 2,

    /// <summary>A triangle.</summary>
    Triangle = 3,

    /// <summary>A box.</summary>
    Box = 4,

    /// <summary>A cylinder.</summary>
    Cylinder = 5,

    /// <summary>A cone.</summary>
    Cone = 6,

    /// <summary>An ellipsoid.</summary>
    Ellipsoid = 7,

    /// <summary>A convex mesh.</summary>
    Mesh = 8,

    /// <summary>A sphere: a point with a margin.</summary>
    Sphere = 9,

    /// <summary>A capsule: a segment with a margin.</summary>
    Capsule = 10,

    /// <summary>The hull of two balls on the y axis.</summary>
    TaperedCapsule = 11,

    /// <summary>All points on one side of a plane.</summary>
    HalfSpace = 12,

    /// <summary>A shape of the caller's own; no file holds it. The last number, so that new kinds follow the
    /// others.</summary>
    Custom = 255,
}
