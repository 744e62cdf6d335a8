namespace Gjk.Core;

/// <summary>How a <see cref="CollisionScene"/> finds the pairs that are worth a query. The results are the same for all
/// of them.</summary>
public enum BroadPhaseKind
{
    /// <summary>Sorted anew along one axis each time: simple and steady, up to some thousands.</summary>
    SortAndSweep = 0,

    /// <summary>A tree of boxes, kept between frames: the one that grows best.</summary>
    DynamicTree,
}
