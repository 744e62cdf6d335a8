namespace Gjk.Core;

/// <summary>A point where two shapes touch, overlap or nearly touch. Immutable.</summary>
public readonly struct ManifoldPoint
{
    /// <summary>On A's surface, or inside B by the overlap; in the world.</summary>
    public readonly Vector3 PointA;

    /// <summary>On B's surface, opposite: PointA + Normal · <see cref="Gap"/>; in the world.</summary>
    public readonly Vector3 PointB;

    /// <summary><see cref="PointA"/> in A's own frame, for a solver that keeps it from frame to frame.</summary>
    public readonly Vector3 LocalPointA;

    /// <summary><see cref="PointB"/> in B's own frame.</summary>
    public readonly Vector3 LocalPointB;

    /// <summary>How far B's surface is from A's here, along the normal, in world units: negative where they overlap,
    /// never less than the shapes' signed distance.</summary>
    public readonly float Gap;

    /// <summary>Tells the point from the others of its manifold. Carry what a solver knows about a point from frame to
    /// frame by it. A's part is in the upper half, B's in the lower one: a corner's id times 4 plus 1, or the id of the
    /// corner at which an edge begins times 4 plus 2, or 0 for a face or a round side. Both are corners where two
    /// coincide, to within a two hundredth of the width that is shared; one is where it lies on the other's face; both
    /// are edges where these cross. A point on the outline of a round face (a disc, or one of 16 corners or more) is
    /// named by the quarter that it is in. 0 for a pair of deepest points that no corner or edge names (round
    /// shapes).</summary>
    public readonly long FeatureId;

    internal ManifoldPoint(
        Vector3 pointA, Vector3 pointB, Vector3 localPointA, Vector3 localPointB, float gap, long featureId)
    {
        PointA = pointA;
        PointB = pointB;
        LocalPointA = localPointA;
        LocalPointB = localPointB;
        Gap = gap;
        FeatureId = featureId;
    }

    /// <summary>The same point with A and B exchanged.</summary>
    public ManifoldPoint Swapped =>
        new(PointB, PointA, LocalPointB, LocalPointA, Gap, ContactFeature.Swapped(FeatureId));

    /// <summary>Gap and place, for people to read.</summary>
    public override string ToString() => FormattableString.Invariant($"{Gap:G9} at {((Double3)PointA).ToText()}");
}
