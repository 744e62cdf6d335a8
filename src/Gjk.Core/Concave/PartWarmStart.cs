namespace Gjk.Core;

/// <summary>The parts that were nearest in the last query of a pair of shapes: where the next one looks first. Kept by
/// the caller, one for each pair; a <c>default</c> struct is a cold start.</summary>
/// <remarks>It is a guess, which shows early what is further away. It changes no distance; of several pairs of parts
/// that are equally near it may change which is named.</remarks>
public struct PartWarmStart
{
    private int _afterA, _afterB;

    /// <summary>The parts, from 0; -1 where there are none.</summary>
    internal readonly int PartA => _afterA - 1;

    /// <inheritdoc cref="PartA"/>
    internal readonly int PartB => _afterB - 1;

    /// <summary>Forgets the parts.</summary>
    public void Clear() => this = default;

    internal void Set(int partA, int partB) => (_afterA, _afterB) = (partA + 1, partB + 1);
}
