namespace Gjk.Core;

/// <summary>An object of a scene and when a moving shape meets it. Immutable. Ordered by fraction, as it was solved; at
/// the start the deepest first; where several are met at once, a face before an edge before a corner; then by id and
/// part.</summary>
public readonly struct CastHit : IComparable<CastHit>
{
    /// <summary>The object; B of <see cref="Result"/>.</summary>
    public readonly int Id;

    /// <summary>When and where they first touch, with the bits of <see cref="ConvexQuery"/>.</summary>
    public readonly CastResult Result;

    /// <summary>The object's part; -1 where it is convex.</summary>
    public readonly int Part;

    private readonly MetFeature _feature;

    internal CastHit(int id, in PartCast cast)
    {
        Id = id;
        Result = cast.Result;
        Part = cast.PartB;
        _feature = cast.Feature;
    }

    /// <inheritdoc/>
    public int CompareTo(CastHit other)
    {
        int order = Result.Order.CompareTo(other.Result.Order);
        if (order == 0) order = _feature.CompareTo(other._feature);
        if (order == 0) order = Id.CompareTo(other.Id);
        return order != 0 ? order : Part.CompareTo(other.Part);
    }

    /// <summary>The object and its result, for people to read.</summary>
    public override string ToString() => FormattableString.Invariant($"{Id}: {Result}");
}
