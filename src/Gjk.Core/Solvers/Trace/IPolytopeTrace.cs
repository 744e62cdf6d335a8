namespace Gjk.Core.Diagnostics;

/// <summary>Told how the search for a depth grows a surface inside the Minkowski difference A - B until a face of it is
/// a face of A - B. Implement it with a struct: the query is compiled for that type, so one whose <see cref="IsOn"/> is
/// the constant false costs nothing, and the ordinary queries have such a one.</summary>
/// <remarks>Everything is about the cores, without their margins: directions are in A's axes, lengths in world units,
/// and a point of A - B is a point of A less one of B.</remarks>
public interface IPolytopeTrace
{
    /// <summary>Whether to call the other method at all.</summary>
    bool IsOn { get; }

    /// <summary>The search has asked what lies beyond the surface's lowest face, or has ended without a
    /// surface.</summary>
    /// <param name="step">The surface as it was when it asked, and the answer. It reads the search's own memory, so it
    /// is valid during the call only; copy what is to be kept.</param>
    void OnStep(in PolytopeStep step);
}

/// <summary>The trace of the queries that are not traced.</summary>
internal struct NoPolytopeTrace : IPolytopeTrace
{
    public readonly bool IsOn => false;

    public readonly void OnStep(in PolytopeStep step)
    {
    }
}

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
