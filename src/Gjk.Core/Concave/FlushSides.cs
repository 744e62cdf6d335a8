namespace Gjk.Core;

/// <summary>Finds planes in which parts of a union end together, where a contact's way leads to more of the union. A
/// body's contact with one of the parts is along such a plane, with all points that the union shows.</summary>
internal static class FlushSides
{
    /// <summary>Ratio of the step aside to the step beyond a witness: a larger one gets behind steep neighbours, a
    /// smaller one may be rounded to their edge. Four times more or less is as good for SeamCornerTests.</summary>
    private const double Aside = 1.0 / 16;

    /// <summary>Cosine: steeper neighbours are not seen from just beyond a witness, which is rounded. Four times more
    /// or less is as good for SeamCornerTests.</summary>
    private const double Steepest = 0.01;

    /// <summary>A point just beyond a witness and a little towards the middle of the neighbour there, so that it is
    /// over the neighbour's inside and not its edge.</summary>
    public static Double3 PointBeside(in Double3 witness, in Double3 outward, in Double3 middle)
    {
        Double3 to = middle - witness, across = to - outward * Double3.Dot(to, outward);
        double length = across.Length, step = StepAt(witness, to.Length);
        return witness + outward * step + across * (length > step ? Aside * step / length : 0);
    }

    /// <summary>A point just beyond another, for a part of the given size.</summary>
    public static Double3 JustBeyond(in Double3 point, in Double3 outward, double size) =>
        point + outward * StepAt(point, size);

    public static double StepAt(in Double3 point, double size) =>
        CoveredSides.Beyond * (CoveredSides.Room * size + CoveredSides.RoundingAt(point));

    /// <summary>Adds the plane in which the union ends near a witness, if all of the union ends there.</summary>
    /// <param name="ends">Gets the plane.</param>
    /// <param name="cover">The union around the contact.</param>
    /// <param name="isNear">Whether the contact is no deeper than the gap of the pairs, so that the neighbours are
    /// among these.</param>
    public static void AddEnd(List<OpenPlane> ends, in PartsCover cover, bool isNear)
    {
        OpenPlane end = cover.FindEnd();
        if (!(Double3.Dot(end.Normal, cover.Outward) > Steepest)) return;
        ConvexShape room = default;
        bool goesOn = cover.GoesOn(end.Foot, end.Normal)
            || CoveredSides.GoesOn(
                cover.OwnShape(ref room), cover.Side.ToLocal(end.Foot), cover.Side.ToLocalDirection(end.Normal),
                cover.Side.Rounding)
            || (!isNear && cover.GoesOnAfar(end.Foot, end.Normal));
        if (!goesOn) CoveredSides.Add(ends, end);
    }

    /// <summary>Gives a contact at a joint, whose way leads into the union, the direction in which the body ends there.
    /// If the other body is the larger one and shows a face, it is that of the face. Else it is that of a plane in
    /// which the part ends together with others: the one along which the two are least deep.</summary>
    public static bool TryFlush(ConcaveScratch scratch, bool isA, ref PairContacts one, float maxGap)
    {
        PartSide side = isA ? scratch.A : scratch.B, otherSide = isA ? scratch.B : scratch.A;
        int other = one.PartOf(!isA);
        ConvexShape room = default, otherRoom = default;
        var cover = new PartsCover(scratch, isA, one);
        ref readonly ConvexShape own = ref cover.OwnShape(ref room);
        ref readonly ConvexShape shape = ref otherSide.ShapeOf(other, ref otherRoom);
        Double3 outward = isA ? one.Manifold.Normal : -one.Manifold.Normal;
        if (otherSide.RadiusWith(shape) > side.RadiusWith(own))
        {
            Double3 face = FaceAgainst(otherSide, other, shape, outward);
            if (face.LengthSquared > 0) return TryAlong(scratch, ref one, maxGap, face, cover);
            if (!otherSide.IsConvex) return false;
        }

        PairContacts best = default;
        foreach (OpenPlane plane in scratch.Ends)
        {
            bool isOther = Double3.Dot(plane.Normal, outward) >= -CoveredSides.Room
                && (plane.Normal - outward).SumOfMagnitudes > CoveredSides.Room;
            if (!isOther || !IsFlush(own, cover, plane)) continue;
            PairContacts found = one;
            bool isThere = TryAlong(scratch, ref found, maxGap, plane.Normal, cover);
            if (isThere && (best.Manifold.Count == 0 || found.Result.Distance > best.Result.Distance)) best = found;
        }

        Double3 normal = best.Manifold.Normal;
        bool isFlush = best.Manifold.Count > 0
            && SeamContacts.Judge(otherSide, other, isA ? -normal : normal) != ContactFit.Ghost;
        if (isFlush) one = best;
        return isFlush;
    }

    /// <summary>Replaces a contact by one along another way, with the points where the union ends just beyond
    /// them.</summary>
    private static bool TryAlong(
        ConcaveScratch scratch, ref PairContacts contact, float maxGap, in Double3 way, in PartsCover cover)
    {
        bool isA = cover.IsA;
        if (!CoveredSides.TryPoints(scratch, isA, contact, maxGap, way, out ContactManifold manifold, out _))
            return false;
        ContactManifold shown = ShownPoints(manifold, way, cover);
        if (shown.Count == 0) return false;
        contact = DeepestPoint.MakeContact(contact.PartA, contact.PartB, shown, contact);
        return true;
    }

    /// <summary>Removes points lower than a contact's deepest one over which the body goes on, as at the slanting edge
    /// of a wall's triangle.</summary>
    public static void KeepShown(ref PairContacts one, in PartsCover cover)
    {
        ContactManifold manifold = one.Manifold;
        if (manifold.Count < 2 || !cover.Side.HasJoints) return;
        ContactManifold shown = ShownPoints(manifold, cover.Outward, cover, onlyLower: true);
        if (shown.Count < manifold.Count) one = new PairContacts(one.PartA, one.PartB, one.Result, shown, one.Pair);
    }

    /// <summary>The points of a manifold that the body shows: without those just beyond which the body goes
    /// on.</summary>
    /// <param name="points">The points.</param>
    /// <param name="way">From the body to the other one, of unit length.</param>
    /// <param name="cover">The union around the contact.</param>
    /// <param name="isFar">Whether the part that goes on may be far from the other body's part.</param>
    /// <param name="onlyLower">Whether only points lower than the deepest one are left out.</param>
    public static ContactManifold ShownPoints(
        in ContactManifold points, in Double3 way, in PartsCover cover, bool isFar = false, bool onlyLower = false)
    {
        ConvexShape room = default;
        double size = cover.OwnShape(ref room).BoundingRadius;
        RigidPose pose = cover.Side.Pose;
        Double3 top = CoveredSides.FootOf(points[DeepestPoint.IndexIn(points)], cover.IsA, pose);
        ContactManifold shown = default;
        shown.Begin(points.Normal);
        for (int i = 0; i < points.Count; i++)
        {
            Double3 foot = CoveredSides.FootOf(points[i], cover.IsA, pose), to = foot - top;
            Double3 beyond = JustBeyond(foot, way, size);
            bool mayHide = !onlyLower || Double3.Dot(to, way) < -CoveredSides.RoomOf(top, to, cover.Side);
            if (!mayHide || !(isFar ? cover.GoesOnAfar(beyond, way) : cover.GoesOn(beyond, way))) shown.Add(points[i]);
        }

        return shown;
    }

    /// <summary>The point of a part that is furthest along a direction, in the world.</summary>
    public static Double3 Furthest(in ConvexShape own, in RigidPose pose, in Double3 direction)
    {
        RotationD turn = new(pose.Rotation);
        own.Support(turn.InverseRotate(direction), out Double3 most);
        return turn.Rotate(own.Center + most) + pose.Position + direction * own.Margin;
    }

    /// <summary>Whether a part shows a face in a direction of the world. A triangle also ends at its edges, but is no
    /// wall there; one of a solid shows its face outward only.</summary>
    public static bool ShowsFace(PartSide side, int part, in Double3 direction)
    {
        if (!side.IsTriangle(part)) return true;
        Double3 face = side.ToWorldDirection(ContactCone.NormalOf(side, part));
        if (side.OutwardOf(part) == 0 && Double3.Dot(face, direction) < 0) face = -face;
        return (face - direction).SumOfMagnitudes <= CoveredSides.Room;
    }

    /// <summary>Whether a part ends in a plane.</summary>
    private static bool IsFlush(in ConvexShape own, in PartsCover cover, in OpenPlane plane)
    {
        if (!ShowsFace(cover.Side, cover.Own, plane.Normal)) return false;
        Double3 to = Furthest(own, cover.Side.Pose, plane.Normal) - plane.Foot;
        double room = CoveredSides.Room * own.BoundingRadius + CoveredSides.RoomOf(plane.Foot, to, cover.Side);
        return Math.Abs(Double3.Dot(to, plane.Normal)) <= room;
    }

    /// <summary>The direction against the face that a part shows, if that is close to the given direction; else
    /// 0.</summary>
    private static Double3 FaceAgainst(PartSide side, int part, in ConvexShape shape, in Double3 direction)
    {
        if (side.Mesh is null)
        {
            bool isFace = MetFeatures.Of(shape, side.Pose, (Vector3)(-direction), out bool isRound) == MetFeature.Face;
            return isFace && !isRound ? direction : default;
        }

        Double3 normal = side.ToWorldDirection(ContactCone.NormalOf(side, part));
        double along = Double3.Dot(normal, direction);
        if (!side.IsSolid && along > 0) (normal, along) = (-normal, -along);
        return along <= -ContactCone.LeastCosine ? -normal : default;
    }
}
