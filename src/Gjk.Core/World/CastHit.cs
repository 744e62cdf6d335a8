namespace Gjk.Core;

/// <summary>An object of a scene and when a moving shape meets it. Immutable. Ordered by fraction; at the same fraction
/// by id.</summary>
public readonly struct CastHit : IComparable<CastHit>
{
    /// <summary>The object; B of <see cref="Result"/>.</summary>
    public readonly int Id;

    /// <summary>When and where they first touch, with the bits of <see cref="ConvexQuery"/>.</summary>
    public readonly CastResult Result;

    /// <summary>The object's part; -1 where it is convex, or where the start is in its inside.</summary>
    public readonly int Part;

    internal CastHit(int id, in CastResult result, int part = PartSide.NoPart)
    {
        Id = id;
        Result = result;
        Part = part;
    }

    /// <inheritdoc/>
    public int CompareTo(CastHit other)
    {
        int order = Result.Fraction.CompareTo(other.Result.Fraction);
        return order != 0 ? order : Id.CompareTo(other.Id);
    }

    /// <summary>The object and its result, for people to read.</summary>
    public override string ToString() => FormattableString.Invariant($"{Id}: {Result}");
}
