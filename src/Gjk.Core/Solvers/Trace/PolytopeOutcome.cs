namespace Gjk.Core.Diagnostics;

/// <summary>What a step of the search for a depth led to.</summary>
public enum PolytopeOutcome
{
    /// <summary>The support point lies beyond the lowest face. It joins the surface, and the search goes on.</summary>
    Grows = 0,

    /// <summary>Nothing lies beyond the lowest face but what rounding leaves open: its height is the depth.</summary>
    BoundsMet,

    /// <summary>The support point's plane separates the cores; the distance query has the answer.</summary>
    Apart,

    /// <summary>A - B has no inside, so there is no surface to grow: the cores touch, or are apart.</summary>
    Flat,

    /// <summary>There was no room for another point. The query asks another search then, which has no surface to tell
    /// of.</summary>
    OutOfRoom,

    /// <summary>The support points contradict each other, as those of no convex shape do.</summary>
    Contradiction,
}
