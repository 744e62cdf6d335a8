namespace Gjk.Core;

/// <summary>Two objects and how far apart they are. Immutable.</summary>
public readonly struct PairDistance
{
    /// <summary>The objects; A and B of <see cref="Result"/>.</summary>
    public readonly ObjectPair Pair;

    /// <summary>Distance, closest points and normal.</summary>
    public readonly DistanceResult Result;

    internal PairDistance(ObjectPair pair, in DistanceResult result)
    {
        Pair = pair;
        Result = result;
    }

    /// <summary>The pair and its result, for people to read.</summary>
    public override string ToString() => $"{Pair}: {Result}";
}
