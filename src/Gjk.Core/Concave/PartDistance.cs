namespace Gjk.Core;

/// <summary>The distance between two shapes of any kind, and the parts that it is between. Immutable.</summary>
public readonly struct PartDistance : IComparable<PartDistance>
{
    /// <summary>The distance, the closest points and the normal, all of the two parts. Beyond the largest distance the
    /// normal is zero: no plane need separate the shapes.</summary>
    public readonly DistanceResult Result;

    /// <summary>The part of A: a triangle or part as the caller numbered it. -1 where A is convex, where it holds a
    /// piece of B in its inside, and where nothing was found.</summary>
    public readonly int PartA;

    /// <summary>The part of B, likewise.</summary>
    public readonly int PartB;

    internal PartDistance(in DistanceResult result, int partA, int partB)
    {
        Result = result;
        PartA = partA;
        PartB = partB;
    }

    /// <summary>What was found.</summary>
    public GjkStatus Status => Result.Status;

    /// <summary>World units; see <see cref="DistanceResult.Distance"/>.</summary>
    public float Distance => Result.Distance;

    /// <summary>True when the shapes share a point, touching included.</summary>
    public bool IsOverlapping => Result.IsOverlapping;

    /// <summary>By the part of A, then by that of B.</summary>
    public int CompareTo(PartDistance other)
    {
        int order = PartA.CompareTo(other.PartA);
        return order != 0 ? order : PartB.CompareTo(other.PartB);
    }

    /// <summary>The status, the distance and the parts, for people to read.</summary>
    public override string ToString() => $"{Result}, parts {PartA} and {PartB}";
}
