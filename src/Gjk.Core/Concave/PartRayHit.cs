namespace Gjk.Core;

/// <summary>Where a ray first meets a shape of any kind, and which part. Immutable.</summary>
public readonly struct PartRayHit : IComparable<PartRayHit>
{
    /// <summary>What the part says. Of a ray that begins inside a solid: OverlappingAtStart, with the depth and the
    /// normal of the nearest point of the surface.</summary>
    public readonly RayCastResult Result;

    /// <summary>The triangle or part, as the caller numbered it; -1 of a convex shape, and at a miss.</summary>
    public readonly int Part;

    internal PartRayHit(in RayCastResult result, int part)
    {
        Result = result;
        Part = part;
    }

    /// <summary>What was found.</summary>
    public CastStatus Status => Result.Status;

    /// <summary>World units along the ray; see <see cref="RayCastResult.Distance"/>.</summary>
    public float Distance => Result.Distance;

    /// <summary>True when a contact was found that counts: on the way, or at the origin.</summary>
    public bool IsHit => Result.IsHit;

    /// <summary>By the distance as it was solved, then by the part.</summary>
    public int CompareTo(PartRayHit other)
    {
        int order = Result.Order.CompareTo(other.Result.Order);
        return order != 0 ? order : Part.CompareTo(other.Part);
    }

    /// <summary>The result and the part, for people to read.</summary>
    public override string ToString() => $"{Result}, part {Part}";
}
