namespace Gjk.Core;

/// <summary>What a cast found, or why it found nothing.</summary>
public enum CastStatus : byte
{
    /// <summary>Nothing was asked: what an unwritten result holds. No query returns it.</summary>
    None = 0,

    /// <summary>The shapes touch at the fraction, and not before it; of a time of impact, to within the
    /// tolerance. The fraction is 0 where they only touch at the start and the motion takes them into each
    /// other.</summary>
    Hit = 1,

    /// <summary>No contact counts up to the largest fraction, which the result has; point and normal: NaN. Shapes that
    /// only touch at the start and slide or part miss each other, too.</summary>
    Miss = 2,

    /// <summary>They overlap before anything moves: fraction 0, a common point, the normal along which B leaves A, and
    /// the depth.</summary>
    OverlappingAtStart = 3,

    /// <summary>The iteration cap ended the query: the shapes are apart up to the fraction; point and normal are NaN.
    /// Only a path along which curved shapes hardly come nearer gets here, and bodies that spin closely past each other
    /// for many turns.</summary>
    IterationLimit = 4,

    /// <summary>A pose or shape that was never constructed (<c>default</c>), or a NaN or infinite number: everything
    /// else is NaN.</summary>
    InvalidInput = 5,

    /// <summary>A support function contradicted itself or returned NaN: everything else is NaN.</summary>
    InvalidShape = 6,
}
