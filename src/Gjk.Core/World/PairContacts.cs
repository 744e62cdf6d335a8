namespace Gjk.Core;

/// <summary>Two objects and where they touch. Immutable.</summary>
public readonly struct PairContacts
{
    /// <summary>The objects; A and B of <see cref="Result"/> and <see cref="Manifold"/>.</summary>
    public readonly ObjectPair Pair;

    /// <summary>How deep they overlap, or how far apart they are, and the direction in which B leaves A.</summary>
    public readonly DistanceResult Result;

    /// <summary>The points, at least one.</summary>
    public readonly ContactManifold Manifold;

    /// <summary>The part of A; -1 where it is convex. What a solver knows of a point belongs to the pair, the two parts
    /// and the point's name.</summary>
    public readonly int PartA;

    /// <summary>The part of B, likewise.</summary>
    public readonly int PartB;

    internal PairContacts(
        ObjectPair pair, in DistanceResult result, in ContactManifold manifold, int partA = PartSide.NoPart,
        int partB = PartSide.NoPart)
    {
        PartA = partA;
        PartB = partB;
        Pair = pair;
        Result = result;
        Manifold = manifold;
    }

    /// <summary>The pair, its result and its points, for people to read.</summary>
    public override string ToString() => $"{Pair}: {Result}, {Manifold}";
}
