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
        CoveredSides.Beyond * CoveredSides.Room * (point.SumOfMagnitudes + size);

    /// <summary>Adds the plane in which the union ends where it goes on from a witness, if all of it ends
    /// there.</summary>
    public static void AddEnd<T>(
        List<OpenPlane> ends, in Double3 witness, in Double3 outward, in ConvexShape own, in RigidPose pose, T cover)
        where T : struct, ICover
    {
        OpenPlane end = cover.EndNear(witness, outward);
        if (!(Double3.Dot(end.Normal, outward) > Steepest)) return;
        RotationD turn = new(pose.Rotation);
        bool goesOn = cover.GoesOn(end.Foot, end.Normal)
            || CoveredSides.GoesOn(
                own, turn.InverseRotate(end.Foot - pose.Position), turn.InverseRotate(end.Normal),
                CoveredSides.RoundingAt(pose.Position));
        if (!goesOn) CoveredSides.Add(ends, end);
    }

    /// <summary>The contact of two parts along a plane in which one of them ends with what is flush with it: of all
    /// such planes the one along which they are least deep.</summary>
    /// <param name="contact">Along their own way, which leads to where the union goes on.</param>
    /// <param name="isA">Whether the side is of A.</param>
    /// <param name="a">The part of A.</param>
    /// <param name="poseA">Its pose.</param>
    /// <param name="b">The part of B.</param>
    /// <param name="poseB">Its pose.</param>
    /// <param name="maxGap">In world units.</param>
    /// <param name="planes">In which the union ends.</param>
    /// <param name="cover">The union's other parts.</param>
    public static bool TryFlush<T>(
        ref PairContacts contact, bool isA, in ConvexShape a, in RigidPose poseA, in ConvexShape b,
        in RigidPose poseB, float maxGap, List<OpenPlane> planes, T cover)
        where T : struct, ICover
    {
        ref readonly ConvexShape own = ref isA ? ref a : ref b;
        RigidPose pose = isA ? poseA : poseB;
        PairContacts best = contact;
        Double3 outward = isA ? contact.Manifold.Normal : -contact.Manifold.Normal;
        bool isAny = false;
        foreach (OpenPlane plane in planes)
        {
            bool isOther = Double3.Dot(plane.Normal, outward) >= -CoveredSides.Room
                && (plane.Normal - outward).SumOfMagnitudes > CoveredSides.Room;
            if (!isOther || !IsFlush(own, pose, plane)) continue;
            PairContacts found = contact;
            bool isThere = TryAlong(ref found, isA, a, poseA, b, poseB, maxGap, plane.Normal, cover);
            if (!isThere || (isAny && found.Result.Distance <= best.Result.Distance)) continue;
            (best, isAny) = (found, true);
        }

        contact = best;
        return isAny;
    }

    /// <summary>The contact of two parts along a way, with the points where the union ends just beyond them.</summary>
    /// <param name="contact">Along their own way.</param>
    /// <param name="isA">Whether the side is of A.</param>
    /// <param name="a">The part of A.</param>
    /// <param name="poseA">Its pose.</param>
    /// <param name="b">The part of B.</param>
    /// <param name="poseB">Its pose.</param>
    /// <param name="maxGap">In world units.</param>
    /// <param name="way">From the side to the other body, of unit length.</param>
    /// <param name="cover">The union's other parts.</param>
    public static bool TryAlong<T>(
        ref PairContacts contact, bool isA, in ConvexShape a, in RigidPose poseA, in ConvexShape b,
        in RigidPose poseB, float maxGap, in Double3 way, T cover)
        where T : struct, ICover
    {
        ContactPlane plane = default;
        ConvexQuery.Contacts(a, poseA, b, poseB, maxGap, ref plane, out ContactManifold manifold);
        if (plane.Normal.LengthSquared == 0) return false;
        ConvexQuery.ContactsAlong(a, poseA, b, poseB, isA ? way : -way, maxGap, ref plane, out manifold);
        ManifoldPoint tip = isA ? CoveredSides.Tip(a, poseA, b, poseB, way) : CoveredSides.Tip(b, poseB, a, poseA, way);
        if (manifold.Count == 0 && tip.Gap <= Math.Max(maxGap, 0) && CoveredSides.IsOn(isA ? a : b, tip.LocalPointA))
            manifold.Add(isA ? tip : tip.Swapped);
        ContactManifold shown = default;
        shown.Begin((Vector3)(isA ? way : -way));
        RigidPose pose = isA ? poseA : poseB;
        for (int i = 0; i < manifold.Count; i++)
        {
            Double3 foot = CoveredSides.FootOf(manifold[i], isA, pose);
            if (!cover.GoesOn(JustBeyond(foot, way, (isA ? a : b).BoundingRadius), way)) shown.Add(manifold[i]);
        }

        if (shown.Count == 0) return false;
        DeepestPoint.Lead(ref shown);
        contact = new PairContacts(
            contact.PartA, contact.PartB, DeepestPoint.Result(shown, contact.Result), shown, contact.Pair);
        return true;
    }

    /// <summary>Whether a part ends in a plane.</summary>
    private static bool IsFlush(in ConvexShape own, in RigidPose pose, in OpenPlane plane)
    {
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
        return Math.Abs(Double3.Dot(to, plane.Normal)) <= CoveredSides.RoomOf(plane.Foot, to, pose);
    }

    /// <summary>Gives a contact at a joint the direction in which the body ends there; where the other body is the
    /// larger one and shows a face, that face's.</summary>
    public static bool TryFlush(ConcaveScratch scratch, bool isA, ref PairContacts one, float maxGap)
    {
        PartSide side = isA ? scratch.A : scratch.B, otherSide = isA ? scratch.B : scratch.A;
        ConvexShape roomA = default, roomB = default;
        ref readonly ConvexShape a = ref scratch.A.Part(Math.Max(one.PartA, 0), ref roomA);
        ref readonly ConvexShape b = ref scratch.B.Part(Math.Max(one.PartB, 0), ref roomB);
        var cover = new PartsCover(scratch, isA, one);
        int other = isA ? one.PartB : one.PartA;
        Double3 outward = isA ? one.Manifold.Normal : -one.Manifold.Normal;
        if (otherSide.RadiusWith(isA ? b : a) > side.RadiusWith(isA ? a : b))
        {
            Double3 face = FaceAgainst(otherSide, other, isA ? b : a, outward);
            if (face.LengthSquared > 0 || !otherSide.IsConvex)
            {
                return face.LengthSquared > 0 && TryAlong(
                    ref one, isA, a, scratch.A.Pose, b, scratch.B.Pose, maxGap, face, cover);
            }
        }

        PairContacts flush = one;
        bool isThere = TryFlush(
            ref flush, isA, a, scratch.A.Pose, b, scratch.B.Pose, maxGap, scratch.Ends, cover);
        Double3 normal = flush.Manifold.Normal;
        if (!isThere || SeamContacts.Judge(otherSide, other, isA ? -normal : normal) == ContactFit.Ghost) return false;
        one = flush;
        return true;
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
