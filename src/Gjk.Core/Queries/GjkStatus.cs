namespace Gjk.Core;

/// <summary>What a query found, or why it found nothing.</summary>
public enum GjkStatus : byte
{
    /// <summary>Nothing was asked: what an unwritten result holds, as in a batch that was cancelled. No query returns
    /// it.</summary>
    None = 0,

    /// <summary>The shapes are apart; distance, bound, points and normal are all valid.</summary>
    Separated = 1,

    /// <summary>The shapes share at least one point (touching included): distance 0, both points the same common point,
    /// normal zero. A signed distance has minus the depth, the deepest points and the way out instead.</summary>
    Overlapping = 2,

    /// <summary>The shapes are further apart than the caller asked to know: lower bound and normal belong to a
    /// separating plane, the distance is +infinity, the points NaN.</summary>
    BeyondMaxDistance = 3,

    /// <summary>The iteration cap, or of a signed distance the room, ended the query: the best points found, with the
    /// bounds on either side. Of valid shapes only some that lie deep in each other get here, and only when their depth
    /// is asked.</summary>
    IterationLimit = 4,

    /// <summary>A pose or shape that was never constructed (<c>default</c>), or a NaN: everything else is
    /// NaN.</summary>
    InvalidInput = 5,

    /// <summary>A support function contradicted itself or returned NaN, or both shapes are half-spaces: everything else
    /// is NaN.</summary>
    InvalidShape = 6,
}
