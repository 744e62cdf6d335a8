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

    internal PairContacts(ObjectPair pair, in DistanceResult result, in ContactManifold manifold)
    {
        Pair = pair;
        Result = result;
        Manifold = manifold;
    }

    /// <summary>The pair, its result and its points, for people to read.</summary>
    public override string ToString() => $"{Pair}: {Result}, {Manifold}";
}
