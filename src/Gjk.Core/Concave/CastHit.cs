namespace Gjk.Core;

/// <summary>When two moving shapes of any kind first touch, or a moving shape and an object, and with which parts.
/// Immutable.</summary>
public readonly struct CastHit : IComparable<CastHit>
{
    /// <summary>The object; B of <see cref="Result"/>. -1 where B is none of a scene's, and where nothing was
    /// found.</summary>
    public readonly int Id;

    /// <summary>The contact of the two parts. Where one overlaps at the start, depth and normal are those of the
    /// deepest two parts: what crosses several faces of a mesh may need a longer way. Where one begins wholly inside a
    /// solid: OverlappingAtStart, with the way out over the solid's outside.</summary>
    public readonly CastResult Result;

    /// <summary>The part of A: a triangle or part as the caller numbered it. -1 where A is convex, and where
    /// nothing was found.</summary>
    public readonly int PartA;

    /// <summary>The part of B, likewise.</summary>
    public readonly int PartB;

    /// <summary>What of the parts meets.</summary>
    internal readonly MetFeature Feature;

    internal CastHit(
        in CastResult result, int partA = PartSide.NoPart, int partB = PartSide.NoPart,
        MetFeature feature = MetFeature.None, int id = -1)
    {
        Result = result;
        (Id, PartA, PartB, Feature) = (id, partA, partB, feature);
    }

    /// <summary>What was found.</summary>
    public CastStatus Status => Result.Status;

    /// <summary>The part of the motion; see <see cref="CastResult.Fraction"/>.</summary>
    public float Fraction => Result.Fraction;

    /// <summary>True when a contact was found that counts: on the way, or at the start.</summary>
    public bool IsHit => Result.IsHit;

    /// <summary>The same with an object of a scene.</summary>
    internal CastHit WithId(int id) => new(Result, PartA, PartB, Feature, id);

    /// <summary>By the fraction as it was solved; at the start the deepest first; where several are met at once, a face
    /// before an edge before a corner; then by the object, the part of A and that of B.</summary>
    public int CompareTo(CastHit other)
    {
        int order = Result.Order.CompareTo(other.Result.Order);
        if (order == 0) order = (int)Feature - (int)other.Feature;
        if (order == 0) order = Id.CompareTo(other.Id);
        if (order == 0) order = PartA.CompareTo(other.PartA);
        return order != 0 ? order : PartB.CompareTo(other.PartB);
    }

    /// <summary>The object, the parts and the result, for people to read.</summary>
    public override string ToString() => HitText.Name(Id, PartA, PartB) + Result;
}
