namespace Gjk.Core;

/// <summary>Where a ray first meets a shape of any kind or an object, and which part. Immutable.</summary>
public readonly struct RayHit : IComparable<RayHit>
{
    /// <summary>The object; -1 where the shape is none of a scene's, and where the ray meets nothing.</summary>
    public readonly int Id;

    /// <summary>What the part says. Of a ray that begins inside a solid: OverlappingAtStart, with the depth and the
    /// normal of the nearest point of the surface.</summary>
    public readonly RayCastResult Result;

    /// <summary>The triangle or part, as the caller numbered it; -1 of a convex shape, and at a miss.</summary>
    public readonly int Part;

    internal RayHit(in RayCastResult result, int part = PartSide.NoPart, int id = -1)
    {
        Result = result;
        (Id, Part) = (id, part);
    }

    /// <summary>What was found.</summary>
    public CastStatus Status => Result.Status;

    /// <summary>World units along the ray; see <see cref="RayCastResult.Distance"/>.</summary>
    public float Distance => Result.Distance;

    /// <summary>True when a contact was found that counts: on the way, or at the origin.</summary>
    public bool IsHit => Result.IsHit;

    /// <summary>The same with an object of a scene.</summary>
    internal RayHit WithId(int id) => new(Result, Part, id);

    /// <summary>The same where the ray enters a solid, or leaves it, with the normal of that.</summary>
    internal RayHit Crossing(bool isExit) => new(isExit ? Result.Exit : Result.On(back: false), Part, Id);

    /// <summary>By the distance as it was solved, then by the object, then by the part.</summary>
    public int CompareTo(RayHit other)
    {
        int order = Result.Order.CompareTo(other.Result.Order);
        if (order == 0) order = Id.CompareTo(other.Id);
        return order != 0 ? order : Part.CompareTo(other.Part);
    }

    /// <summary>The object, the part and the result, for people to read.</summary>
    public override string ToString() => HitText.Name(Id, Part) + Result;
}
