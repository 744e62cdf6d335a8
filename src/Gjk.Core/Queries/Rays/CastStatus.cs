namespace Gjk.Core;

/// <summary>What a cast found, or why it found nothing.</summary>
public enum CastStatus : byte
{
    /// <summary>Nothing was asked: what an unwritten result holds. No query returns it.</summary>
    None = 0,

    /// <summary>
    /// The shapes touch at the fraction, and not before it; of a time of impact, they are within the tolerance at it.
    /// </summary>
    Hit = 1,

    /// <summary>They do not touch up to the largest fraction, which the result has; point and normal: NaN.</summary>
    Miss = 2,

    /// <summary>
    /// They overlap or touch before anything moves: fraction 0, a common point, and a zero normal. How deep, and which
    /// way out, <see cref="ConvexQuery"/>'s signed distance says.
    /// </summary>
    OverlappingAtStart = 3,

    /// <summary>
    /// The iteration cap ended the query: the shapes are apart up to the fraction; point and normal are NaN. Only a
    /// path along which curved shapes hardly come nearer gets here, and bodies that spin closely past each other for
    /// many turns.
    /// </summary>
    IterationLimit = 4,

    /// <summary>
    /// A pose or shape that was never constructed (<c>default</c>), or a NaN or infinite number: everything else is
    /// NaN.
    /// </summary>
    InvalidInput = 5,

    /// <summary>A support function contradicted itself or returned NaN: everything else is NaN.</summary>
    InvalidShape = 6,
}
