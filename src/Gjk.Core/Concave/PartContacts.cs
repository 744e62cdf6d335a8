namespace Gjk.Core;

/// <summary>Where a part of one shape touches a part of another. Immutable.</summary>
public readonly struct PartContacts : IComparable<PartContacts>
{
    /// <summary>The part of A: a triangle or part as the caller numbered it; -1 where A is convex.</summary>
    public readonly int PartA;

    /// <summary>The part of B, likewise.</summary>
    public readonly int PartB;

    /// <summary>How deep the two parts overlap, or how far apart they are, along the manifold's normal, and
    /// where.</summary>
    public readonly DistanceResult Result;

    /// <summary>The points, at least one; their names are those of the two parts.</summary>
    public readonly ContactManifold Manifold;

    internal PartContacts(int partA, int partB, in DistanceResult result, in ContactManifold manifold)
    {
        PartA = partA;
        PartB = partB;
        Result = result;
        Manifold = manifold;
    }

    /// <summary>By the part of A, then by that of B.</summary>
    public int CompareTo(PartContacts other)
    {
        int order = PartA.CompareTo(other.PartA);
        return order != 0 ? order : PartB.CompareTo(other.PartB);
    }

    /// <summary>The parts, their result and their points, for people to read.</summary>
    public override string ToString() => $"parts {PartA} and {PartB}: {Result}, {Manifold}";
}
