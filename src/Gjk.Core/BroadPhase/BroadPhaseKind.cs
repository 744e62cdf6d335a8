namespace Gjk.Core;

/// <summary>
/// How a <see cref="CollisionScene"/> finds the pairs that are worth a query. The results are the same for all of them.
/// </summary>
public enum BroadPhaseKind
{
    /// <summary>Every pair of bounds is compared: the fastest for a few dozen objects.</summary>
    AllPairs = 0,

    /// <summary>Sorted anew along one axis each time: simple and steady, up to some thousands.</summary>
    SortAndSweep,

    /// <summary>Sorted along all three axes, kept between frames: for objects that move little.</summary>
    SweepAndPrune,

    /// <summary>A tree of boxes, kept between frames: the one that grows best.</summary>
    DynamicTree,
}
