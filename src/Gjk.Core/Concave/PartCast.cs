namespace Gjk.Core;

/// <summary>When two moving shapes of any kind first touch, and with which parts. Immutable.</summary>
public readonly struct PartCast
{
    /// <summary>The contact of the two parts. Where a piece of one begins inside a solid: OverlappingAtStart with a
    /// point of it, a zero normal and depth 0.</summary>
    public readonly CastResult Result;

    /// <summary>The part of A: a triangle or part as the caller numbered it. -1 where A is convex, where it holds a
    /// piece of B in its inside, and where nothing was found.</summary>
    public readonly int PartA;

    /// <summary>The part of B, likewise.</summary>
    public readonly int PartB;

    internal PartCast(in CastResult result, int partA, int partB)
    {
        Result = result;
        PartA = partA;
        PartB = partB;
    }

    /// <summary>What was found.</summary>
    public CastStatus Status => Result.Status;

    /// <summary>The part of the motion; see <see cref="CastResult.Fraction"/>.</summary>
    public float Fraction => Result.Fraction;

    /// <summary>True when a contact was found that counts: on the way, or at the start.</summary>
    public bool IsHit => Result.IsHit;

    /// <summary>The result and the parts, for people to read.</summary>
    public override string ToString() => $"{Result}, parts {PartA} and {PartB}";
}
