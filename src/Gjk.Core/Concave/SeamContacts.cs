namespace Gjk.Core;

/// <summary>Finds the contact of two parts as their bodies show it: along the parts' own way out, where both bodies end
/// there; else along a triangle's face, if the pair needs a contact.</summary>
internal static class SeamContacts
{
    /// <summary>Count of <see cref="CoveredSides.Room"/>: planes that are across each other cross at 26 degrees or
    /// more, so what is within a room of both is within 2.3 of where they cross; the rest is what turning makes of a
    /// sum of magnitudes, at most the root of 3. CrossingSheetTests has a point that needs some of it.</summary>
    private const double Level = 4;

    /// <summary>Ratio to a part's radius: a part further beside a triangle is beside it in spite of rounding. More
    /// costs time only; at a quarter, contacts are lost, as FarContactTests shows.</summary>
    public const double Beside = 1.125;

    /// <summary>Finds the contact of two parts, or what may stand for it.</summary>
    /// <param name="scratch">With both sides and all pairs; gets the contacts of faces, and the orphans: pairs that
    /// overlap and have neither, with what would hold them.</param>
    /// <param name="pair">The parts.</param>
    /// <param name="maxGap">In world units.</param>
    /// <param name="contacts">Gets the contact that needs no others to be judged.</param>
    public static void Find(ConcaveScratch scratch, in PairDistance pair, float maxGap, List<PairContacts> contacts)
    {
        scratch.SelectGround(pair.Pair);
        PartSide a = scratch.A, b = scratch.B;
        if (ContactCone.IsInnerWall(a, pair.PartA) || ContactCone.IsInnerWall(b, pair.PartB)) return;
        ConvexShape roomA = default, roomB = default;
        ref readonly ConvexShape shapeA = ref a.ShapeOf(pair.PartA, ref roomA);
        ref readonly ConvexShape shapeB = ref b.ShapeOf(pair.PartB, ref roomB);
        ContactPlane plane = default;
        DistanceResult result = ConvexQuery.Contacts(
            shapeA, a.Pose, shapeB, b.Pose, maxGap, ref plane, out ContactManifold manifold);
        if (manifold.Count == 0) return;
        Double3 normal = plane.Normal.LengthSquared > 0
            ? plane.NormalOfQuery
            : (Double3)result.Normal;
        ContactFit fitA = Judge(a, pair.PartA, normal), fitB = Judge(b, pair.PartB, -normal);
        if (!a.IsConvex || !b.IsConvex) DeepestPoint.MoveToFront(ref manifold);
        var own = new PairContacts(pair.PartA, pair.PartB, result, manifold, pair.Pair);
        if (fitA == ContactFit.Stays && fitB == ContactFit.Stays)
        {
            if (!OutwardContact.TryReplace(scratch, own, normal, maxGap)) contacts.Add(own);
            return;
        }

        bool isBeside = IsBeside(a, pair.PartA, fitA, b, shapeB, result)
            || IsBeside(b, pair.PartB, fitB, a, shapeA, result);
        if (isBeside) return;
        scratch.Searched++;
        if (TryConvex(scratch, true, own, normal, fitB, shapeA, contacts)
            || TryConvex(scratch, false, own, normal, fitA, shapeB, contacts))
        {
            return;
        }

        var search = new FaceSearch(scratch, own, plane, maxGap);
        search.Run(normal, fitA, fitB, shapeA, shapeB);
        search.Add(contacts);
    }

    /// <summary>Removes the contacts at sides that other parts of their body cover. For parts that overlap or touch, it
    /// keeps what may hold them instead: sides may cover each other where more than two meet.</summary>
    public static void RemoveCovered(ConcaveScratch scratch, float maxGap, List<PairContacts> contacts)
    {
        if (!scratch.A.IsConvex) RemoveCovered(scratch, true, maxGap, contacts);
        if (!scratch.B.IsConvex) RemoveCovered(scratch, false, maxGap, contacts);
    }

    private static void RemoveCovered(ConcaveScratch scratch, bool isA, float maxGap, List<PairContacts> contacts)
    {
        List<OpenPlane> planes = scratch.Planes;
        List<bool> areAtJoints = scratch.AreAtJoints, areOpen = scratch.AreOpen;
        planes.Clear();
        areAtJoints.Clear();
        areOpen.Clear();
        foreach (PairContacts one in contacts)
        {
            bool isNear = IsNear(one, maxGap), isAtJoint = IsAtJoint(scratch, isA, one, isNear);
            areAtJoints.Add(isAtJoint);
            bool isOpen = !isAtJoint && !IsAtJoint(scratch, !isA, one, isNear);
            areOpen.Add(isOpen);
            if (isOpen) CoveredSides.AddPlane(scratch, isA, one, planes);
        }

        RemoveCoveredFaces(scratch, isA);
        List<OpenPlane> ends = scratch.Ends;
        ends.Clear();
        for (int i = 0; i < contacts.Count; i++)
        {
            if (areAtJoints[i])
                FlushSides.AddEnd(ends, new PartsCover(scratch, isA, contacts[i]), IsNear(contacts[i], maxGap));
            else if (areOpen[i] && !IsCovered(scratch, isA, contacts[i], false))
                CoveredSides.AddPlane(scratch, isA, contacts[i], ends);
        }

        foreach (FaceContact one in scratch.FaceContacts)
        {
            // A face much deeper than its pair pushes only where nothing else does.
            if (one.IsOfA == isA && !(one.Own > one.Contact.Result.Distance * ContactPush.MuchLess))
                CoveredSides.AddPlane(scratch, isA, one.Contact, planes);
        }

        int kept = 0;
        for (int i = 0; i < contacts.Count; i++)
        {
            PairContacts one = contacts[i];
            scratch.SelectGround(one.Pair);
            if (!IsCovered(scratch, isA, one, areAtJoints[i]))
            {
                FlushSides.KeepShown(ref one, new PartsCover(scratch, isA, one));
                contacts[kept++] = one;
            }
            else if (areAtJoints[i] && FlushSides.TryFlush(scratch, isA, ref one, maxGap)) contacts[kept++] = one;
            else if (AreLevel(scratch, one, isA)) Replace(scratch, isA, one, areAtJoints[i], maxGap);
        }

        contacts.RemoveRange(kept, contacts.Count - kept);
    }

    /// <summary>Whether a contact is no deeper than the gap of the pairs.</summary>
    private static bool IsNear(in PairContacts one, float maxGap) => !(-one.Result.Distance > maxGap);

    private static void RemoveCoveredFaces(ConcaveScratch scratch, bool isA)
    {
        List<FaceContact> faces = scratch.FaceContacts;
        int kept = 0;
        for (int i = 0; i < faces.Count; i++)
        {
            FaceContact face = faces[i];
            bool isAtJoint = IsAtJoint(scratch, isA, face.Contact);
            if (!IsCovered(scratch, isA, face.Contact, isAtJoint)) faces[kept++] = face;
            else if (AreLevel(scratch, face.Contact, isA)) scratch.Orphans.Add(face);
        }

        faces.RemoveRange(kept, faces.Count - kept);
    }

    /// <summary>Whether two parts overlap, or are so near that each of two sides may seem behind the other.</summary>
    private static bool AreLevel(ConcaveScratch scratch, in PairContacts one, bool isA)
    {
        Double3 point = isA ? one.Result.LocalPointA : one.Result.LocalPointB;
        double rounding = scratch.SideOf(one.Pair.A, isA).Rounding;
        return one.Result.Distance <= Level * (CoveredSides.Room * point.SumOfMagnitudes + rounding);
    }

    /// <summary>World units: level parts are no further apart than this, whichever body goes on.</summary>
    public static double LevelRoomOf(in DistanceResult at)
    {
        double lengths = ((Double3)at.LocalPointA).SumOfMagnitudes + ((Double3)at.LocalPointB).SumOfMagnitudes;
        return Level * (CoveredSides.Room * lengths + CoveredSides.RoundingAt(at.PointA));
    }

    /// <summary>Whether another part of a contact's body goes on at the contact.</summary>
    /// <param name="scratch">With both bodies.</param>
    /// <param name="isA">Whether the body is A.</param>
    /// <param name="one">The contact.</param>
    /// <param name="isNear">Whether it is no deeper than the gap of the pairs, so that what covers it is among
    /// them.</param>
    private static bool IsAtJoint(ConcaveScratch scratch, bool isA, in PairContacts one, bool isNear = false)
    {
        if (!scratch.SideOf(one.Pair.A, isA).HasJoints) return false;
        var cover = new PartsCover(scratch, isA, one);
        return isNear
            ? cover.GoesOn(cover.Witness, cover.Outward, isJoint: true)
            : JoinedGrounds.GoesOn(scratch, cover.Side, cover.Own, cover.Witness, cover.Outward);
    }

    private static bool IsCovered(ConcaveScratch scratch, bool isA, in PairContacts one, bool isAtJoint)
    {
        var cover = new PartsCover(scratch, isA, one);
        if (!CoveredSides.IsAnyAcross(scratch.Planes, cover.Outward)) return isAtJoint;
        ConvexShape room = default;
        ref readonly ConvexShape part = ref cover.OwnShape(ref room);
        return isAtJoint
            ? !CoveredSides.StandsOn(part, scratch.Planes, cover)
            : CoveredSides.IsBuried(one.Manifold, part, scratch.Planes, cover);
    }

    /// <summary>Keeps what holds two parts that overlap, if they need it: the way that the union shows, or else their
    /// own.</summary>
    private static void Replace(
        ConcaveScratch scratch, bool isA, in PairContacts one, bool isAtJoint, float maxGap)
    {
        Double3 way = isAtJoint ? new PartsCover(scratch, isA, one).FindEnd().Normal : default;
        PairContacts held = one;
        bool isThere = way.LengthSquared > 0
            && Judge(isA ? scratch.B : scratch.A, one.PartOf(!isA), -way) == ContactFit.Stays
            && IsTipShown(scratch, isA, one, way)
            && CoveredSides.TryReplaceAlong(scratch, isA, ref held, maxGap, way)
            && !IsAtJoint(scratch, isA, held);
        if (isThere) scratch.FaceContacts.Add(new FaceContact(held, one, isA));
        else scratch.Orphans.Add(new FaceContact(one));
    }

    /// <summary>Whether a part's tip is over the other body, and its own body ends there.</summary>
    private static bool IsTipShown(ConcaveScratch scratch, bool isA, in PairContacts one, in Double3 way)
    {
        PartSide side = isA ? scratch.A : scratch.B, otherSide = isA ? scratch.B : scratch.A;
        int other = one.PartOf(!isA);
        ConvexShape room = default, otherRoom = default;
        ref readonly ConvexShape own = ref side.ShapeOf(one.PartOf(isA), ref room);
        ManifoldPoint tip = CoveredSides.Tip(
            own, side.Pose, otherSide.ShapeOf(other, ref otherRoom), otherSide.Pose, way);
        return JoinedGrounds.IsOn(scratch, side, isA, own, tip.LocalPointA)
            && !JoinedGrounds.GoesOn(scratch, otherSide, other, tip.PointB, -way);
    }

    /// <summary>How the end of a body at a part fits a direction in the world.</summary>
    public static ContactFit Judge(PartSide side, int part, in Double3 direction)
    {
        if (side.Mesh is null || direction.LengthSquared == 0) return ContactFit.Stays;
        return new ContactCone(side, part, side.ToLocalDirection(direction)).Judge();
    }

    /// <summary>Whether a convex part is apart from a triangle and beside what is over or under that, where its surface
    /// goes on: then neither face meets the other's tip. It is so of most pairs that are far apart.</summary>
    private static bool IsBeside(
        PartSide mesh, int triangle, ContactFit fit, PartSide other, in ConvexShape shape, in DistanceResult own)
    {
        if (fit != ContactFit.Ghost || other.Mesh is not null || !(own.Distance > 0)) return false;
        Double3 middle = mesh.ToLocal(other.ToWorld(shape.Center));
        return new TriangleColumn(mesh, triangle, ContactCone.NormalOf(mesh, triangle))
            .IsBeside(middle, Beside * shape.BoundingRadius);
    }

    /// <summary>A pair of a convex part and a mesh that goes on: the convex part's face is the one to be pushed along,
    /// where the tip to which the mesh climbs is over it. The pair has its own contact where its triangle leans, and
    /// else the tip's, if it overlaps.</summary>
    private static bool TryConvex(
        ConcaveScratch scratch, bool isConvexA, in PairContacts own, in Double3 normal, ContactFit fit,
        in ConvexShape shape, List<PairContacts> contacts)
    {
        bool isOverlapping = own.Result.Distance < 0;
        PartSide convex = isConvexA ? scratch.A : scratch.B, other = isConvexA ? scratch.B : scratch.A;
        if (convex.IsTriangle(own.PartOf(isConvexA))) return false;
        Double3 outward = isConvexA ? normal : -normal;
        RotationD toOther = new(other.Pose.Rotation), toConvex = new(convex.Pose.Rotation);
        int triangle = own.PartOf(!isConvexA);
        if (!MeshClimb.TryFind(other.Mesh!, triangle, toOther.InverseRotate(-outward), out int corner)) return false;
        Double3 local = other.Mesh!.GetCorner(corner), tip = toOther.Rotate(local) + other.Pose.Position;
        if (JoinedGrounds.GoesOn(scratch, other, triangle, tip, -outward)) return false;
        ManifoldPoint point = CoveredSides.Under(shape, convex.Pose, outward, tip, (Vector3)local);
        Double3 inConvex = toConvex.InverseRotate(tip - convex.Pose.Position);
        if (point.Gap <= 0 && !JoinedGrounds.IsOn(scratch, convex, isConvexA, shape, inConvex)) return false;
        bool isDeep = isOverlapping && other.IsSolid && convex.IsConvex;
        if (!isDeep && !JoinedGrounds.IsOn(scratch, convex, isConvexA, shape, point.LocalPointA)) return false;
        if (!isOverlapping)
        {
            if (fit == ContactFit.Leans) contacts.Add(own);
            return true;
        }

        PairContacts contact = own;
        if (fit == ContactFit.Ghost)
        {
            // Along no face of the convex part, what the mesh climbs to may be deep where the two are not.
            if (point.Gap * ContactPush.MuchLess < own.Result.Distance
                && MetFeatures.Of(shape, convex.Pose, (Vector3)outward, out _) != MetFeature.Face)
                return false;
            ContactManifold manifold = default;
            manifold.Begin((Vector3)normal);
            manifold.Add(isConvexA ? point : point.Swapped);
            int partA = isConvexA ? own.PartA : corner / 3, partB = isConvexA ? corner / 3 : own.PartB;
            contact = DeepestPoint.MakeContact(partA, partB, manifold, own);
        }

        scratch.FaceContacts.Add(new FaceContact(contact, own, isConvexA));
        return true;
    }
}
