namespace Gjk.Core;

/// <summary>Two objects and how far apart they are. Immutable.</summary>
public readonly struct PairDistance
{
    /// <summary>The objects; A and B of <see cref="Result"/>.</summary>
    public readonly ObjectPair Pair;

    /// <summary>Distance, closest points and normal.</summary>
    public readonly DistanceResult Result;

    /// <summary>The part of A; -1 where it is convex, or holds a piece of B in its inside.</summary>
    public readonly int PartA;

    /// <summary>The part of B, likewise.</summary>
    public readonly int PartB;

    internal PairDistance(
        ObjectPair pair, in DistanceResult result, int partA = PartSide.NoPart, int partB = PartSide.NoPart)
    {
        Pair = pair;
        Result = result;
        PartA = partA;
        PartB = partB;
    }

    /// <summary>The pair and its result, for people to read.</summary>
    public override string ToString() => $"{Pair}: {Result}";
}
