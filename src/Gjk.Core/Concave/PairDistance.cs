namespace Gjk.Core;

/// <summary>The distance between two shapes of any kind or two objects, and the parts that it is between.
/// Immutable.</summary>
public readonly struct PairDistance : IComparable<PairDistance>
{
    /// <summary>The objects; A and B of <see cref="Result"/>. -1 for a shape that is none of a scene's, and where
    /// nothing was found.</summary>
    public readonly ObjectPair Pair;

    /// <summary>The distance, the closest points and the normal, all of the two parts. Beyond the largest distance the
    /// normal is zero: no plane need separate the shapes.</summary>
    public readonly DistanceResult Result;

    /// <summary>The part of A: a triangle or part as the caller numbered it. -1 where A is convex, where it holds a
    /// piece of B in its inside, and where nothing was found; of a compound the first triangle of the solid that holds
    /// it.</summary>
    public readonly int PartA;

    /// <summary>The part of B, likewise.</summary>
    public readonly int PartB;

    internal PairDistance(
        in DistanceResult result, int partA = PartSide.NoPart, int partB = PartSide.NoPart, ObjectPair? pair = null)
    {
        Pair = pair ?? ObjectPair.None;
        Result = result;
        (PartA, PartB) = (partA, partB);
    }

    /// <summary>What was found.</summary>
    public GjkStatus Status => Result.Status;

    /// <summary>World units; see <see cref="DistanceResult.Distance"/>.</summary>
    public float Distance => Result.Distance;

    /// <summary>True when the shapes share a point, touching included.</summary>
    public bool IsOverlapping => Result.IsOverlapping;

    /// <summary>The same with two objects of a scene.</summary>
    internal PairDistance WithPair(ObjectPair pair) => new(Result, PartA, PartB, pair);

    /// <summary>By the objects, then by the part of A, then by that of B.</summary>
    public int CompareTo(PairDistance other)
    {
        int order = Pair.CompareTo(other.Pair);
        if (order == 0) order = PartA.CompareTo(other.PartA);
        return order != 0 ? order : PartB.CompareTo(other.PartB);
    }

    /// <summary>The objects, the parts and the result, for people to read.</summary>
    public override string ToString() => HitText.Name(Pair, PartA, PartB) + Result;
}
