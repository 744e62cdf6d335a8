using System;
using System.Numerics;

namespace Gjk.Core;

/// <summary>A point where two shapes touch, overlap or nearly touch. Immutable.</summary>
public readonly struct ContactPoint
{
    /// <summary>On A's surface, or inside B by the overlap; in the world.</summary>
    public readonly Vector3 PointA;

    /// <summary>On B's surface, opposite: PointA + Normal · <see cref="Gap"/>; in the world.</summary>
    public readonly Vector3 PointB;

    /// <summary><see cref="PointA"/> in A's own frame, for a solver that keeps it from frame to frame.</summary>
    public readonly Vector3 LocalPointA;

    /// <summary><see cref="PointB"/> in B's own frame.</summary>
    public readonly Vector3 LocalPointB;

    /// <summary>
    /// How far B's surface is from A's here, along the normal, in world units: negative where they overlap, never less
    /// than the shapes' signed distance.
    /// </summary>
    public readonly float Gap;

    /// <summary>
    /// Tells the point from the others of its manifold: the same number as long as the same corner of one shape lies
    /// across the same face of the other, or the same two edges cross. Carry what a solver knows about a point from
    /// frame to frame by it. 0 for a pair of deepest points that no corner or edge names (round shapes).
    /// </summary>
    public readonly long FeatureId;

    internal ContactPoint(
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
    public ContactPoint Swapped =>
        new(PointB, PointA, LocalPointB, LocalPointA, Gap, ContactFeature.Swapped(FeatureId));

    /// <summary>Gap and place, for people to read.</summary>
    public override string ToString() =>
        FormattableString.Invariant($"{Gap:G9} at {((Vector3D)PointA).ToString("G9")}");
}
