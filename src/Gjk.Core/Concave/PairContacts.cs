namespace Gjk.Core;

/// <summary>Where two convex shapes, or a part of one shape and a part of another, touch. Immutable.</summary>
public readonly struct PairContacts : IComparable<PairContacts>
{
    /// <summary>The objects; A and B of <see cref="Result"/> and <see cref="Manifold"/>. -1 for shapes that are none of
    /// a scene's.</summary>
    public readonly ObjectPair Pair;

    /// <summary>The part of A: a triangle or part as the caller numbered it; -1 where A is convex. What a solver knows
    /// of a point belongs to the pair, the two parts and the point's name.</summary>
    public readonly int PartA;

    /// <summary>The part of B, likewise.</summary>
    public readonly int PartB;

    /// <summary>How deep the two parts overlap, or how far apart they are, along the manifold's normal, and
    /// where.</summary>
    public readonly DistanceResult Result;

    /// <summary>The points, at least one; their names are those of the two parts.</summary>
    public readonly ContactManifold Manifold;

    internal PairContacts(
        int partA, int partB, in DistanceResult result, in ContactManifold manifold, ObjectPair? pair = null)
    {
        Pair = pair ?? ObjectPair.None;
        (PartA, PartB) = (partA, partB);
        Result = result;
        Manifold = manifold;
    }

    /// <summary>The part of A, or else that of B.</summary>
    internal int PartOf(bool isA) => isA ? PartA : PartB;

    /// <summary>The same with two objects of a scene.</summary>
    internal PairContacts WithPair(ObjectPair pair) => new(PartA, PartB, Result, Manifold, pair);

    /// <summary>The same of two shapes that are none of a scene's, with A and B exchanged.</summary>
    internal PairContacts Swapped => new(PartB, PartA, Result.Swapped, Manifold.Swapped);

    /// <summary>By the objects, then by the part of A, then by that of B.</summary>
    public int CompareTo(PairContacts other)
    {
        int order = Pair.CompareTo(other.Pair);
        if (order == 0) order = PartA.CompareTo(other.PartA);
        return order != 0 ? order : PartB.CompareTo(other.PartB);
    }

    /// <summary>The objects, the parts, their result and their points, for people to read.</summary>
    public override string ToString() => $"{HitText.Name(Pair, PartA, PartB)}{Result}, {Manifold}";
}
