namespace Gjk.Core;

/// <summary>The contact of two parts as the bodies show it that they are of: along the parts' own way out where both
/// bodies end there; else along a triangle's face, if the pair needs a contact.</summary>
internal static class SeamContacts
{
    /// <summary>Finds the contact of two parts, or what may stand for it.</summary>
    /// <param name="scratch">With both sides and all pairs; gets the contacts of faces, and the orphans: pairs that
    /// overlap and have neither, with what would hold them.</param>
    /// <param name="pair">The parts.</param>
    /// <param name="maxGap">In world units.</param>
    /// <param name="contacts">Gets the contact that needs no others to be judged.</param>
    public static void Find(ConcaveScratch scratch, in PartDistance pair, float maxGap, List<PartContacts> contacts)
    {
        PartSide a = scratch.A, b = scratch.B;
        if (IsInnerWall(a, pair.PartA) || IsInnerWall(b, pair.PartB)) return;
        ConvexShape roomA = default, roomB = default;
        ref readonly ConvexShape shapeA = ref a.Part(Math.Max(pair.PartA, 0), ref roomA);
        ref readonly ConvexShape shapeB = ref b.Part(Math.Max(pair.PartB, 0), ref roomB);
        ContactPlane plane = default;
        DistanceResult result = ConvexQuery.Contacts(
            shapeA, a.Pose, shapeB, b.Pose, maxGap, ref plane, out ContactManifold manifold);
        if (manifold.Count == 0) return;
        Double3 normal = plane.Normal.LengthSquared > 0
            ? plane.Frame.RotationA.Rotate(plane.Normal)
            : (Double3)result.Normal;
        ContactFit fitA = Judge(a, pair.PartA, normal), fitB = Judge(b, pair.PartB, -normal);
        bool isCoveredA = CompoundJoints.Covers(scratch, a, pair.PartA, result.LocalPointA, normal);
        bool isCoveredB = CompoundJoints.Covers(scratch, b, pair.PartB, result.LocalPointB, -normal);
        bool isCovered = isCoveredA || isCoveredB;
        if (!a.IsConvex || !b.IsConvex) DeepestPoint.Lead(ref manifold);
        var own = new PartContacts(pair.PartA, pair.PartB, result, manifold);
        bool isStaying = fitA == ContactFit.Stays && fitB == ContactFit.Stays;
        if (isStaying && !isCovered)
        {
            contacts.Add(own);
            return;
        }

        for (int side = 0; side < 2; side++)
        {
            bool isConvexA = side == 0;
            if ((isConvexA ? a : b).Mesh is not null || (isCovered && !(isConvexA ? isCoveredA : isCoveredB))) continue;
            Double3 way = normal;
            ContactFit fit = isCovered ? ContactFit.Ghost : isConvexA ? fitB : fitA;
            if ((!isCovered || CompoundJoints.TryOver(scratch, isConvexA, own, shapeA, shapeB, ref way))
                && TryConvex(scratch, isConvexA, own, pair, way, fit, shapeA, shapeB, contacts))
            {
                return;
            }
        }

        if (isStaying)
        {
            if (result.Distance < 0) scratch.Orphans.Add(new FaceContact(own));
            return;
        }

        var search = new FaceSearch(scratch, pair, result, plane, maxGap, isCovered);
        search.Run(normal, fitA, fitB, shapeA, shapeB);
        search.Add(own, contacts);
    }

    /// <summary>Whether a body ends at a part along a direction in the world.</summary>
    public static ContactFit Judge(PartSide side, int part, in Double3 direction)
    {
        if (side.Mesh is null || direction.LengthSquared == 0) return ContactFit.Stays;
        return new ContactCone(side, part, new RotationD(side.Pose.Rotation).InverseRotate(direction)).Judge();
    }

    /// <summary>Whether a triangle of a solid is there as often one way as the other: it bounds nothing.</summary>
    private static bool IsInnerWall(PartSide side, int triangle)
    {
        if (!side.IsSolid) return false;
        TriangleMesh mesh = side.Mesh!;
        mesh.GetCorners(triangle, out _, out Double3 b, out Double3 c);
        int ways = 0;
        for (CornerRing ring = mesh.SidesAt(3 * triangle); ring.MoveNext();)
        {
            Double3 after = mesh.GetCorner(ContactCone.After(ring.Current));
            Double3 before = mesh.GetCorner(ContactCone.Before(ring.Current));
            if (after == b && before == c) ways++;
            else if (after == c && before == b) ways--;
        }

        return ways == 0;
    }

    /// <summary>A pair of a convex part and another one whose body goes on: the convex part's face is the one to be
    /// pushed along, where the other body's tip is over it, to which a mesh climbs. The pair has its own contact where
    /// its triangle leans, and else the tip's, if it overlaps.</summary>
    private static bool TryConvex(
        ConcaveScratch scratch, bool isConvexA, in PartContacts own, in PartDistance pair, in Double3 normal,
        ContactFit fit, in ConvexShape shapeA, in ConvexShape shapeB, List<PartContacts> contacts)
    {
        bool isOverlapping = own.Result.Distance < 0;
        PartSide convex = isConvexA ? scratch.A : scratch.B, other = isConvexA ? scratch.B : scratch.A;
        ref readonly ConvexShape shape = ref isConvexA ? ref shapeA : ref shapeB;
        ref readonly ConvexShape tipped = ref isConvexA ? ref shapeB : ref shapeA;
        Double3 outward = isConvexA ? normal : -normal;
        RotationD toOther = new(other.Pose.Rotation), toConvex = new(convex.Pose.Rotation);
        Double3 against = toOther.InverseRotate(-outward), local;
        int part = isConvexA ? pair.PartB : pair.PartA;
        if (other.Mesh is not null)
        {
            if (!MeshClimb.TryFind(other.Mesh, part, against, out int corner)) return false;
            (local, part) = (other.Mesh.GetCorner(corner), corner / 3);
        }
        else
        {
            tipped.Support(against, out Double3 point);
            local = tipped.Center + point + against * tipped.Margin;
            if (CompoundJoints.Covers(scratch, other, part, local, -outward)) return false;
        }

        Double3 tip = toOther.Rotate(local) + other.Pose.Position;
        Double3 direction = toConvex.InverseRotate(outward);
        shape.Support(direction, out Double3 most);
        Double3 inConvex = toConvex.InverseRotate(tip - convex.Pose.Position);
        double gap = Double3.Dot(direction, inConvex - shape.Center - most) - shape.Margin;
        Double3 foot = inConvex - direction * gap;
        if (gap <= 0 && !CompoundJoints.IsOn(scratch, convex, shape, inConvex)) return false;
        bool isDeep = isOverlapping && other.IsSolid && convex.IsConvex;
        if (!isDeep && !CompoundJoints.IsOn(scratch, convex, shape, foot)) return false;
        if (!isOverlapping)
        {
            if (fit == ContactFit.Leans) contacts.Add(own);
            return true;
        }

        PartContacts contact = own;
        if (fit == ContactFit.Ghost)
        {
            var point = new ManifoldPoint(
                (Vector3)(tip - outward * gap), (Vector3)tip, (Vector3)foot, (Vector3)local, (float)gap, 0);
            ContactManifold manifold = default;
            manifold.Begin((Vector3)normal);
            manifold.Add(isConvexA ? point : point.Swapped);
            int partA = isConvexA ? pair.PartA : part, partB = isConvexA ? part : pair.PartB;
            contact = new PartContacts(partA, partB, DeepestPoint.Result(manifold, own.Result), manifold);
        }

        scratch.FaceContacts.Add(new FaceContact(contact, pair, isConvexA, own.Result));
        return true;
    }
}
