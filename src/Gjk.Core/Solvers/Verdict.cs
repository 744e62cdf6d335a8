namespace Gjk.Core;

/// <summary>What a solver can say about two cores; <see cref="GjkStatus"/> is what a query says about two
/// shapes.</summary>
internal enum Verdict : byte
{
    /// <summary>Rounding leaves it open, or the iterations ran out.</summary>
    Undecided,

    /// <summary>The cores are apart; the nearest feature and a plane that meets it are known.</summary>
    Apart,

    /// <summary>The cores share a point.</summary>
    Enclosed,

    /// <summary>A plane proves that the cores are further apart than asked.</summary>
    Beyond,

    /// <summary>A support function contradicted itself or gave NaN.</summary>
    Contradiction,
}
