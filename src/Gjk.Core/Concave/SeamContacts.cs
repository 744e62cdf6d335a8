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
            contacts.Add(own);
            return;
        }

        if (result.Distance < 0 && TryTip(scratch, pair, result, normal, fitA, fitB, shapeA, shapeB)) return;
        var search = new FaceSearch(scratch, pair, result, plane, maxGap);
        search.Run(normal, fitA, fitB, shapeA, shapeB);
        search.Add(own, contacts);
    }

    /// <summary>Takes out the contacts at sides that the other parts of their body cover; of parts that overlap, what
    /// may hold them instead is kept.</summary>
    public static void RemoveCovered(ConcaveScratch scratch, float maxGap, List<PartContacts> contacts)
    {
        RemoveCovered(scratch, scratch.A, true, maxGap, contacts);
        RemoveCovered(scratch, scratch.B, false, maxGap, contacts);
    }

    private static void RemoveCovered(
        ConcaveScratch scratch, PartSide side, bool isA, float maxGap, List<PartContacts> contacts)
    {
        if (side.IsConvex) return;
        List<OpenPlane> planes = scratch.Planes;
        List<bool> areAtJoints = scratch.AreAtJoints;
        planes.Clear();
        areAtJoints.Clear();
        foreach (PartContacts one in contacts)
        {
            bool isAtJoint = side.Compound is not null && new PartsCover(scratch, isA, one).GoesOnAtWitness(one);
            areAtJoints.Add(isAtJoint);
            if (!isAtJoint) CoveredSides.AddPlane(planes, one.Manifold, isA, side.Pose);
        }

        RemoveCoveredFaces(scratch, side, isA);
        foreach (FaceContact one in scratch.FaceContacts)
            CoveredSides.AddPlane(planes, one.Contact.Manifold, isA, side.Pose);
        int kept = 0;
        for (int i = 0; i < contacts.Count; i++)
        {
            PartContacts one = contacts[i];
            if (!IsCovered(scratch, side, isA, one, areAtJoints[i])) contacts[kept++] = one;
            else if (one.Result.Distance < 0) Replace(scratch, side, isA, one, areAtJoints[i], maxGap);
        }

        contacts.RemoveRange(kept, contacts.Count - kept);
    }

    private static void RemoveCoveredFaces(ConcaveScratch scratch, PartSide side, bool isA)
    {
        List<FaceContact> faces = scratch.FaceContacts;
        int kept = 0;
        for (int i = 0; i < faces.Count; i++)
        {
            FaceContact face = faces[i];
            if (!IsCovered(scratch, side, isA, face.Contact, false)) faces[kept++] = face;
            else if (face.Own < 0) scratch.Orphans.Add(face);
        }

        faces.RemoveRange(kept, faces.Count - kept);
    }

    private static bool IsCovered(
        ConcaveScratch scratch, PartSide side, bool isA, in PartContacts one, bool isAtJoint)
    {
        ConvexShape room = default;
        ref readonly ConvexShape part = ref side.Part(isA ? one.PartA : one.PartB, ref room);
        var cover = new PartsCover(scratch, isA, one);
        return isAtJoint
            ? !CoveredSides.StandsOn(cover.Witness(one), cover.Outward(one), part, side.Pose, scratch.Planes)
            : CoveredSides.IsBuried(one.Manifold, isA, part, side.Pose, scratch.Planes, cover);
    }

    /// <summary>What holds two parts that overlap, if they need it: the way that the union shows, or else their
    /// own.</summary>
    private static void Replace(
        ConcaveScratch scratch, PartSide side, bool isA, in PartContacts one, bool isAtJoint, float maxGap)
    {
        PartSide otherSide = isA ? scratch.B : scratch.A;
        int other = isA ? one.PartB : one.PartA;
        ConvexShape roomA = default, roomB = default;
        ref readonly ConvexShape partA = ref scratch.A.Part(Math.Max(one.PartA, 0), ref roomA);
        ref readonly ConvexShape partB = ref scratch.B.Part(Math.Max(one.PartB, 0), ref roomB);
        var cover = new PartsCover(scratch, isA, one);
        Double3 way = isAtJoint
            ? CoveredSides.WayFrom(cover.Witness(one), cover.Outward(one), -one.Result.Distance, cover)
            : default;
        PartContacts held = one;
        if (Judge(otherSide, other, -way) == ContactFit.Stays && CoveredSides.TryAlong(
            ref held, isA, partA, scratch.A.Pose, partB, scratch.B.Pose, maxGap, way))
        {
            var pair = new PartDistance(one.Result, one.PartA, one.PartB);
            scratch.FaceContacts.Add(new FaceContact(held, pair, isA, one.Result));
        }
        else
        {
            scratch.Orphans.Add(new FaceContact(one));
        }
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
        RotationD toSolid = new(solid.Pose.Rotation);
        int triangle = isConvexA ? pair.PartB : pair.PartA;
        if (!MeshClimb.TryFind(solid.Mesh!, triangle, toSolid.InverseRotate(-outward), out int corner)) return false;
        Double3 local = solid.Mesh!.GetCorner(corner), tip = toSolid.Rotate(local) + solid.Pose.Position;
        ref readonly ConvexShape shape = ref isConvexA ? ref shapeA : ref shapeB;
        if (!ConvexQuery.Contains(shape, convex.Pose, (Vector3)tip)) return false;
        ManifoldPoint point = CoveredSides.Under(shape, convex.Pose, outward, tip, (Vector3)local);
        if (!(point.Gap <= 0)) return false;
        ContactManifold manifold = default;
        manifold.Begin((Vector3)normal);
        manifold.Add(isConvexA ? point : point.Swapped);
        int partA = isConvexA ? pair.PartA : corner / 3, partB = isConvexA ? corner / 3 : pair.PartB;
        var contact = new PartContacts(partA, partB, DeepestPoint.Result(manifold, result), manifold);
        scratch.FaceContacts.Add(new FaceContact(contact, pair, isConvexA, result));
        return true;
    }
}
