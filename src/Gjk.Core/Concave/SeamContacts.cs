using System;

namespace Gjk.Core;

/// <summary>
/// The contact of two parts as their surfaces show it: as the convex query has it, along a triangle's normal instead,
/// or not at all.
/// </summary>
internal static class SeamContacts
{
    /// <summary>Finds the contact of two parts.</summary>
    /// <param name="a">The first side.</param>
    /// <param name="partA">The number of its part.</param>
    /// <param name="b">The second side.</param>
    /// <param name="partB">The number of its part.</param>
    /// <param name="maxGap">In world units.</param>
    /// <param name="found">The contact.</param>
    /// <returns>False where there is none.</returns>
    public static bool TryFind(PartSide a, int partA, PartSide b, int partB, float maxGap, out PartContacts found)
    {
        ConvexShape roomA = default, roomB = default;
        ref readonly ConvexShape shapeA = ref a.Part(Math.Max(partA, 0), ref roomA);
        ref readonly ConvexShape shapeB = ref b.Part(Math.Max(partB, 0), ref roomB);
        ContactPlane plane = default;
        DistanceResult result = ConvexQuery.Contacts(
            shapeA, a.Pose, shapeB, b.Pose, maxGap, ref plane, out ContactManifold manifold);
        found = default;
        if (manifold.Count == 0) return false;
        RotationD toA = new(a.Pose.Rotation), toB = new(b.Pose.Rotation);
        Double3 normal = plane.Normal.LengthSquared > 0
            ? plane.Frame.RotationA.Rotate(plane.Normal)
            : (Double3)result.Normal;
        ContactFit fitA = Judge(a, partA, toA.InverseRotate(normal), out Double3 faceA);
        ContactFit fitB = Judge(b, partB, toB.InverseRotate(-normal), out Double3 faceB);
        if (fitA == ContactFit.Ghost || fitB == ContactFit.Ghost) return false;
        if (fitA == ContactFit.Leans || fitB == ContactFit.Leans)
        {
            if (plane.Normal.LengthSquared == 0) return false;
            Double3 along = fitA == ContactFit.Leans ? toA.Rotate(faceA) : toB.Rotate(-faceB);
            ConvexQuery.ContactsAlong(shapeA, a.Pose, shapeB, along, maxGap, ref plane, out manifold);
            if (manifold.Count == 0) return false;
            result = Deepest(manifold, result);
        }

        found = new PartContacts(partA, partB, result, manifold);
        return true;
    }

    private static ContactFit Judge(PartSide side, int part, in Double3 direction, out Double3 face)
    {
        face = default;
        if (side.Mesh is null || direction.LengthSquared == 0) return ContactFit.Stays;
        return new ContactCone(side.Mesh, direction).Judge(part, out face);
    }

    /// <summary>The deepest point of a manifold as a result.</summary>
    private static DistanceResult Deepest(in ContactManifold manifold, in DistanceResult before)
    {
        ManifoldPoint point = manifold[0];
        for (int i = 1; i < manifold.Count; i++)
            if (manifold[i].Gap < point.Gap) point = manifold[i];
        return new DistanceResult(
            point.Gap > 0 ? GjkStatus.Separated : GjkStatus.Overlapping, point.Gap,
            Math.Min(before.LowerBound, point.Gap), point.PointA, point.PointB, manifold.Normal, point.LocalPointA,
            point.LocalPointB, before.Iterations);
    }
}
