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
        if (!a.IsConvex || !b.IsConvex) DeepestPoint.Lead(ref manifold);
        var own = new PartContacts(pair.PartA, pair.PartB, result, manifold);
        if (fitA == ContactFit.Stays && fitB == ContactFit.Stays)
        {
            bool isCovered = CompoundJoints.Covers(scratch, true, pair, result, normal)
                || CompoundJoints.Covers(scratch, false, pair, result, -normal);
            if (!isCovered) contacts.Add(own);
            else if (result.Distance < 0) scratch.Orphans.Add(new FaceContact(own));
            return;
        }

        if (result.Distance < 0 && TryTip(scratch, pair, result, normal, fitA, fitB, shapeA, shapeB)) return;
        var search = new FaceSearch(scratch, pair, result, plane, maxGap);
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

    /// <summary>A convex part that shows its own way out, to a solid that goes on further into it: the solid's tip
    /// there, if the part holds it.</summary>
    private static bool TryTip(
        ConcaveScratch scratch, in PartDistance pair, in DistanceResult result, in Double3 normal, ContactFit fitA,
        ContactFit fitB, in ConvexShape shapeA, in ConvexShape shapeB)
    {
        bool isConvexA = scratch.A.Mesh is null;
        PartSide convex = isConvexA ? scratch.A : scratch.B, solid = isConvexA ? scratch.B : scratch.A;
        if (convex.Mesh is not null || !solid.IsSolid || (isConvexA ? fitA : fitB) != ContactFit.Stays) return false;
        Double3 outward = isConvexA ? normal : -normal;
        RotationD toSolid = new(solid.Pose.Rotation), toConvex = new(convex.Pose.Rotation);
        int triangle = isConvexA ? pair.PartB : pair.PartA;
        if (!MeshClimb.TryFind(solid.Mesh!, triangle, toSolid.InverseRotate(-outward), out int corner)) return false;
        Double3 local = solid.Mesh!.GetCorner(corner), tip = toSolid.Rotate(local) + solid.Pose.Position;
        ref readonly ConvexShape shape = ref isConvexA ? ref shapeA : ref shapeB;
        if (!ConvexQuery.Contains(shape, convex.Pose, (Vector3)tip)) return false;
        shape.Support(toConvex.InverseRotate(outward), out Double3 most);
        Double3 top = toConvex.Rotate(shape.Center + most) + convex.Pose.Position + outward * shape.Margin;
        double gap = Double3.Dot(outward, tip - top);
        if (!(gap <= 0)) return false;
        Double3 foot = tip - outward * gap;
        var localFoot = (Vector3)toConvex.InverseRotate(foot - convex.Pose.Position);
        var point = new ManifoldPoint((Vector3)foot, (Vector3)tip, localFoot, (Vector3)local, (float)gap, 0);
        ContactManifold manifold = default;
        manifold.Begin((Vector3)normal);
        manifold.Add(isConvexA ? point : point.Swapped);
        int partA = isConvexA ? pair.PartA : corner / 3, partB = isConvexA ? corner / 3 : pair.PartB;
        var contact = new PartContacts(partA, partB, DeepestPoint.Result(manifold, result), manifold);
        scratch.FaceContacts.Add(new FaceContact(contact, pair, isConvexA, result));
        return true;
    }
}
