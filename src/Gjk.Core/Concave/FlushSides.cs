namespace Gjk.Core;

/// <summary>Where a contact leads to a place at which a union goes on, the planes in which parts of it end together: a
/// body's contact with one of the parts is along such a plane, with all points that the union shows.</summary>
internal static class FlushSides
{
    /// <summary>Ratio of so far beyond a witness and so far beside it: more is behind what goes on steeply, less may be
    /// rounded to its edge. Four times more or less is as good for SeamCornerTests.</summary>
    private const double Aside = 1.0 / 16;

    /// <summary>Cosine: what goes on steeper is not seen from just beyond a witness, as that is rounded. Four times
    /// more or less is as good for SeamCornerTests.</summary>
    private const double Steepest = 0.01;

    /// <summary>A point just beyond a witness, and beside it to where the middle of what goes on there is: over that,
    /// and not over its edge.</summary>
    public static Double3 Beside(in Double3 witness, in Double3 outward, in Double3 middle)
    {
        Double3 to = middle - witness, across = to - outward * Double3.Dot(to, outward);
        double length = across.Length, step = StepAt(witness, to.Length);
        return witness + outward * step + across * (length > step ? Aside * step / length : 0);
    }

    /// <summary>A point just beyond one of a part that is so large.</summary>
    public static Double3 JustBeyond(in Double3 point, in Double3 outward, double size) =>
        point + outward * StepAt(point, size);

    private static double StepAt(in Double3 point, double size) =>
        CoveredSides.Beyond * (CoveredSides.Room * size + CoveredSides.RoundingAt(point));

    /// <summary>Adds the plane in which the union ends where it goes on from a witness, if all of it ends
    /// there.</summary>
    /// <param name="ends">Gets it.</param>
    /// <param name="cover">The union around the contact.</param>
    /// <param name="isNear">Whether the contact is no deeper than the pairs are near: what goes on is among
    /// them.</param>
    public static void AddEnd(List<OpenPlane> ends, in PartsCover cover, bool isNear)
    {
        OpenPlane end = cover.EndNear();
        if (!(Double3.Dot(end.Normal, cover.Outward) > Steepest)) return;
        ConvexShape room = default;
        bool goesOn = cover.GoesOn(end.Foot, end.Normal)
            || CoveredSides.GoesOn(
                cover.Part(ref room), cover.Side.Local(end.Foot), cover.Side.Turned(end.Normal), cover.Side.Rounding)
            || (!isNear && cover.GoesOnAfar(end.Foot, end.Normal));
        if (!goesOn) CoveredSides.Add(ends, end);
    }

    /// <summary>Gives a contact at a joint, whose way leads to where the union goes on, the direction in which the body
    /// ends there: where the other body is the larger one and shows a face, that face's; else of all planes in which
    /// the part ends with what is flush with it, the one along which the two are least deep.</summary>
    public static bool TryFlush(ConcaveScratch scratch, bool isA, ref PairContacts one, float maxGap)
    {
        PartSide side = isA ? scratch.A : scratch.B, otherSide = isA ? scratch.B : scratch.A;
        int other = one.PartOf(!isA);
        ConvexShape room = default, otherRoom = default;
        var cover = new PartsCover(scratch, isA, one);
        ref readonly ConvexShape own = ref cover.Part(ref room);
        ref readonly ConvexShape shape = ref otherSide.Part(other, ref otherRoom);
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
            if (!isOther || !IsFlush(own, side, plane)) continue;
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

    /// <summary>The contact of two parts along a way, with the points where the union ends just beyond them.</summary>
    private static bool TryAlong(
        ConcaveScratch scratch, ref PairContacts contact, float maxGap, in Double3 way, in PartsCover cover)
    {
        bool isA = cover.IsA;
        if (!CoveredSides.TryPoints(scratch, isA, contact, maxGap, way, out ContactManifold manifold, out _))
            return false;
        ConvexShape room = default;
        double size = cover.Part(ref room).BoundingRadius;
        ContactManifold shown = default;
        shown.Begin((Vector3)(isA ? way : -way));
        for (int i = 0; i < manifold.Count; i++)
        {
            Double3 foot = CoveredSides.FootOf(manifold[i], isA, cover.Side.Pose);
            if (!cover.GoesOn(JustBeyond(foot, way, size), way)) shown.Add(manifold[i]);
        }

        if (shown.Count == 0) return false;
        contact = DeepestPoint.Contact(contact.PartA, contact.PartB, shown, contact);
        return true;
    }

    /// <summary>Takes out the points lower than a contact's deepest one over which the body goes on, as at the slanting
    /// edge of a wall's triangle.</summary>
    public static void KeepShown(ref PairContacts one, in PartsCover cover)
    {
        ContactManifold manifold = one.Manifold, shown = default;
        if (manifold.Count < 2 || !cover.Side.HasJoints) return;
        Double3 top = CoveredSides.FootOf(manifold[DeepestPoint.Of(manifold)], cover.IsA, cover.Side.Pose);
        ConvexShape room = default;
        double size = cover.Part(ref room).BoundingRadius;
        shown.Begin(manifold.Normal);
        for (int i = 0; i < manifold.Count; i++)
        {
            Double3 foot = CoveredSides.FootOf(manifold[i], cover.IsA, cover.Side.Pose), to = foot - top;
            bool isLower = Double3.Dot(to, cover.Outward) < -CoveredSides.RoomOf(top, to, cover.Side);
            if (!isLower || !cover.GoesOn(JustBeyond(foot, cover.Outward, size), cover.Outward)) shown.Add(manifold[i]);
        }

        if (shown.Count < manifold.Count) one = new PairContacts(one.PartA, one.PartB, one.Result, shown, one.Pair);
    }

    /// <summary>Whether a part ends in a plane.</summary>
    private static bool IsFlush(in ConvexShape own, PartSide side, in OpenPlane plane)
    {
        RigidPose pose = side.Pose;

        // A triangle ends at its edges too, but it is no wall there.
        if (own.Kind == ShapeKind.Triangle
            && MetFeatures.Of(own, pose, (Vector3)plane.Normal, out _) != MetFeature.Face)
        {
            return false;
        }

        RotationD turn = new(pose.Rotation);
        own.Support(turn.InverseRotate(plane.Normal), out Double3 most);
        Double3 top = turn.Rotate(own.Center + most) + pose.Position + plane.Normal * own.Margin;
        Double3 to = top - plane.Foot;
        return Math.Abs(Double3.Dot(to, plane.Normal)) <= CoveredSides.RoomOf(plane.Foot, to, side);
    }

    /// <summary>The direction against the face that a part shows to a direction, if that is near; else 0.</summary>
    private static Double3 FaceAgainst(PartSide side, int part, in ConvexShape shape, in Double3 direction)
    {
        if (side.Mesh is null)
        {
            bool isFace = MetFeatures.Of(shape, side.Pose, (Vector3)(-direction), out bool isRound) == MetFeature.Face;
            return isFace && !isRound ? direction : default;
        }

        Double3 normal = new RotationD(side.Pose.Rotation).Rotate(ContactCone.NormalOf(side, part));
        double along = Double3.Dot(normal, direction);
        if (!side.IsSolid && along > 0) (normal, along) = (-normal, -along);
        return along <= -ContactCone.LeastCosine ? -normal : default;
    }
}
