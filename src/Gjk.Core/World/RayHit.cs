namespace Gjk.Core;

/// <summary>An object of a scene and where a ray meets it. Immutable. Ordered by distance, as it was solved;
/// at the same distance by id.</summary>
public readonly struct RayHit : IComparable<RayHit>
{
    /// <summary>The object, or -1 where the ray meets none.</summary>
    public readonly int Id;

    /// <summary>Where the ray meets it, with the bits of <see cref="ConvexQuery"/>.</summary>
    public readonly RayCastResult Result;

    /// <summary>The object's part; -1 where it is convex, or where the start is in its inside.</summary>
    public readonly int Part;

    internal RayHit(int id, in RayCastResult result, int part = PartSide.NoPart)
    {
        Id = id;
        Result = result;
        Part = part;
    }

    /// <inheritdoc/>
    public int CompareTo(RayHit other)
    {
        int order = Result.Order.CompareTo(other.Result.Order);
        return order != 0 ? order : Id.CompareTo(other.Id);
    }

    /// <summary>The object and its result, for people to read.</summary>
    public override string ToString() => FormattableString.Invariant($"{Id}: {Result}");
}
