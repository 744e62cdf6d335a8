namespace Gjk.Core;

/// <summary>The contact of two parts as their surfaces show it: as the convex query has it, along a triangle's normal
/// instead, or not at all.</summary>
internal static class SeamContacts
{
    /// <summary>Of a depth: less is much less. At a half no face pushes more than twice as far as it must.
    /// TipContactTests fails without; twice as much or as little is harmless.</summary>
    private const float MuchLess = 0.5f;

    /// <summary>Finds the contact of two parts.</summary>
    /// <param name="a">The first side.</param>
    /// <param name="partA">The number of its part.</param>
    /// <param name="b">The second side.</param>
    /// <param name="partB">The number of its part.</param>
    /// <param name="maxGap">In world units.</param>
    /// <param name="found">The contact.</param>
    /// <param name="isGhost">Whether it is that of a face, whose pair's own leads over a seam.</param>
    /// <returns>False where there is none.</returns>
    public static bool TryFind(
        PartSide a, int partA, PartSide b, int partB, float maxGap, out PartContacts found, out bool isGhost)
    {
        ConvexShape roomA = default, roomB = default;
        ref readonly ConvexShape shapeA = ref a.Part(Math.Max(partA, 0), ref roomA);
        ref readonly ConvexShape shapeB = ref b.Part(Math.Max(partB, 0), ref roomB);
        ContactPlane plane = default;
        DistanceResult result = ConvexQuery.Contacts(
            shapeA, a.Pose, shapeB, b.Pose, maxGap, ref plane, out ContactManifold manifold);
        found = default;
        isGhost = false;
        if (manifold.Count == 0) return false;
        RotationD toA = new(a.Pose.Rotation), toB = new(b.Pose.Rotation);
        Double3 normal = plane.Normal.LengthSquared > 0
            ? plane.Frame.RotationA.Rotate(plane.Normal)
            : (Double3)result.Normal;
        ContactFit fitA = Judge(a, partA, toA.InverseRotate(normal), out Double3 faceA);
        ContactFit fitB = Judge(b, partB, toB.InverseRotate(-normal), out Double3 faceB);
        if (fitA != ContactFit.Stays || fitB != ContactFit.Stays)
        {
            // Along the face of the triangle that says so; of two, of the one that is further off.
            bool isOfA = fitA >= fitB;
            isGhost = fitA == ContactFit.Ghost || fitB == ContactFit.Ghost;
            TipContact tip = isOfA
                ? new TipContact(a, partA, b, shapeB, faceA, !isGhost)
                : new TipContact(b, partB, a, shapeA, faceB, !isGhost);
            if (tip.Face.LengthSquared == 0 || (isGhost && tip.Gap > Math.Max(maxGap, 0))) return false;
            Double3 along = isOfA ? toA.Rotate(tip.Face) : toB.Rotate(-tip.Face);
            if (isGhost && !(isOfA ? IsShown(b, partB, toB, -along) : IsShown(a, partA, toA, along))) return false;
            manifold = default;
            if (plane.Normal.LengthSquared > 0)
                ConvexQuery.ContactsAlong(shapeA, a.Pose, shapeB, along, maxGap, ref plane, out manifold);
            if (manifold.Count == 0 && !tip.TryAdd(isOfA, isOfA ? a : b, maxGap, ref manifold)) return false;
            result = Deepest(manifold, result);
        }

        found = new PartContacts(partA, partB, result, manifold);
        return true;
    }

    /// <summary>Whether a face's contact is needed: where a contact of another direction takes the shapes apart by much
    /// less, it is not the face that they meet, but what it ends at.</summary>
    public static bool IsNeeded(in PartContacts face, List<PartContacts> others)
    {
        for (int i = 0; i < others.Count; i++)
        {
            PartContacts other = others[i];
            if (other.Result.Distance < 0 && other.Result.Distance > face.Result.Distance * MuchLess
                && Vector3.Dot(other.Manifold.Normal, face.Manifold.Normal) < ContactCone.LeastCosine)
            {
                return false;
            }
        }

        return true;
    }

    private static bool IsShown(PartSide side, int part, in RotationD turn, in Double3 direction) =>
        Judge(side, part, turn.InverseRotate(direction), out _) == ContactFit.Stays;

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
