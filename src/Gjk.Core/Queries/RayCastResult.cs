namespace Gjk.Core;

/// <summary>Where a ray first meets a shape. Immutable.</summary>
public readonly struct RayCastResult
{
    /// <summary>What was found; see <see cref="CastStatus"/> for which fields are valid.</summary>
    public readonly CastStatus Status;

    /// <summary>Whether the ray meets a back face: it leaves a convex shape there or crosses out of a solid, or it
    /// meets a triangle of a mesh from the side from which its corners run clockwise. Of a solid mesh the back is
    /// inside. A scale that mirrors a mesh keeps its front. Triangles that are shapes of their own, or of a
    /// surface in a compound, have two fronts for a ray that comes in.</summary>
    public readonly bool IsBackFace;

    /// <summary>World units along the ray from its origin, rounded to float; 0 where it begins in the shape, the
    /// largest distance at a miss.</summary>
    public readonly float Distance;

    /// <summary>The point of the ray at that distance, in the world.</summary>
    public readonly Vector3 Point;

    /// <summary>The unit normal of the shape's surface there, outward; of a triangle that a ray is cast against, on the
    /// side from which the ray comes, front or back. Where the ray begins in the shape it is that of
    /// the nearest point of the surface, the shortest way out.</summary>
    public readonly Vector3 Normal;

    /// <summary>World units: how deep in the shape the ray begins; 0 for a hit and a miss. Where <c>SignedDistance</c>
    /// has no room for its search, it may be less.</summary>
    public readonly float Depth;

    /// <summary>How many times the shape was asked for a support point: 0 where a closed form
    /// answers, but of a half-space 1.</summary>
    public readonly int Iterations;

    /// <summary>The distance as it was solved, before rounding to float.</summary>
    private readonly double _solved;

    internal RayCastResult(
        CastStatus status, double distance, Vector3 point, Vector3 normal, int iterations, float depth = 0,
        bool isBackFace = false)
    {
        IsBackFace = isBackFace;
        (Status, Distance, _solved, Depth, Iterations) = (status, (float)distance, distance, depth, iterations);
        Point = point;
        Normal = normal;
    }

    /// <summary>True when a contact was found that counts: on the way, or at the origin.</summary>
    public bool IsHit => Status is CastStatus.Hit or CastStatus.OverlappingAtStart;

    /// <summary>By what it is compared with other contacts of the ray.</summary>
    internal ContactOrder Order => new(_solved, Status, Depth);

    /// <summary>The same of a point that is cast by a unit of length for each fraction of 1.</summary>
    internal CastResult ToCast() => new(Status, _solved, Point, Normal, Iterations, Depth);

    /// <summary>The same where the ray leaves, with the opposite normal.</summary>
    internal RayCastResult Exit => new(Status, _solved, Point, Opposite.Of(Normal), Iterations, Depth, true);

    /// <summary>The same with a front or a back.</summary>
    internal RayCastResult On(bool back) => new(Status, _solved, Point, Normal, Iterations, Depth, back);

    /// <summary>True also for a search that ended at its limit, apart up to the distance.</summary>
    internal bool MayHit => IsHit || Status == CastStatus.IterationLimit;

    /// <summary>The status and the fields that are valid with it, as text.</summary>
    public override string ToString() => Status switch
    {
        CastStatus.Hit => FormattableString.Invariant(
            $"Hit after {Distance:G9} at {Text(Point)}, normal {Text(Normal)}{(IsBackFace ? ", back face" : "")}"),
        CastStatus.OverlappingAtStart => FormattableString.Invariant(
            $"{Status} by {Depth:G9}, normal {Text(Normal)}"),
        CastStatus.Miss or CastStatus.IterationLimit => FormattableString.Invariant($"{Status} up to {Distance:G9}"),
        _ => Status.ToString(),
    };

    private static string Text(Vector3 v) => ((Double3)v).ToText();

    internal static RayCastResult Nothing(CastStatus status, float distance, int iterations)
    {
        var nan = new Vector3(float.NaN);
        float depth = status is CastStatus.Miss or CastStatus.IterationLimit ? 0 : float.NaN;
        return new RayCastResult(status, distance, nan, nan, iterations, depth);
    }
}
