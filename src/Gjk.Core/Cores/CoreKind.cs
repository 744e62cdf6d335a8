namespace Gjk.Core;

/// <summary>The cores that queries have a support of their own for.</summary>
internal enum CoreKind : byte
{
    /// <summary>Asked through its own type.</summary>
    Other,

    /// <summary><see cref="BoxCore"/>.</summary>
    Box,

    /// <summary><see cref="HullCore"/>.</summary>
    Hull,

    /// <summary><see cref="SegmentCore"/>.</summary>
    Segment,

    /// <summary><see cref="TriangleCore"/>.</summary>
    Triangle,

    /// <summary>Added to one of the others: the core is placed in the shape's frame.</summary>
    Moved = 8,
}
