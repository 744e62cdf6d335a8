namespace Gjk.Core;

/// <summary>Where the cores of a pair are in their shapes' frames; null where the two are the same.</summary>
internal readonly struct PairPlacement
{
    /// <summary>Of shapes that are not placed; a <c>default</c> on the stack would be cleared for each query.</summary>
    public static readonly PairPlacement None;

    public readonly Placement? A, B;

    public PairPlacement(Placement? a, Placement? b)
    {
        A = a;
        B = b;
    }

    /// <summary>Whether neither shape is placed.</summary>
    public bool IsNone => A is null & B is null;
}
