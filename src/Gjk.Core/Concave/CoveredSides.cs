namespace Gjk.Core;

/// <summary>Finds contacts at covered sides. Where the parts of a body, or static objects, are flush or overlap,
/// another part may cover the side of one, and the union does not end there.</summary>
internal static class CoveredSides
{
    /// <summary>Ratio to lengths: 2^-18, some roundings of two parts' positions. With less, a seam between rounded
    /// positions becomes a kerb.</summary>
    public const double Room = 4 * ContactCone.Slack;

    /// <summary>Ratio to a position: 2^-22, twice what rounding to float takes from two flush parts. Without it seams
    /// far from the origin become kerbs, as FarTilesTests shows; there a quarter is enough.</summary>
    private const double Rounding = 1.0 / (1 << 22);

    /// <summary>Count of <see cref="Room"/>: how far beyond a plane a part is looked for, along its side, and how far
    /// beyond a witness the union is probed. A plane across a side is tilted from it by 26 degrees or more, so the
    /// probe is 4 rooms clear of a part that ends at the plane.</summary>
    public const double Beyond = 1 / (1 - ContactCone.LeastCosine);

    /// <summary>Count: the most planes that are kept. More cost time; with fewer a buried side may keep its contact.
    /// Pinned by SeamContactTests.</summary>
    private const int MostPlanes = 32;

    /// <summary>A point of a contact on one of the two bodies, in the world.</summary>
    public static Double3 FootOf(in ManifoldPoint point, bool isA, in RigidPose pose) =>
        InWorld(isA ? point.LocalPointA : point.LocalPointB, pose);

    public static Double3 InWorld(in Double3 local, in RigidPose pose) =>
        new RotationD(pose.Rotation).Rotate(local) + pose.Position;

    /// <summary>Adds the plane of a contact, unless an equal one is there.</summary>
    public static void AddPlane(ConcaveScratch scratch, bool isA, in PairContacts one, List<OpenPlane> planes)
    {
        ManifoldPoint deepest = one.Manifold[DeepestPoint.IndexIn(one.Manifold)];
        Double3 foot = FootOf(deepest, isA, scratch.SideOf(one.Pair.A, isA).Pose);
        Double3 normal = isA ? one.Manifold.Normal : -one.Manifold.Normal;
        Add(planes, new OpenPlane(foot, normal, Math.Max(-deepest.Gap, 0)));
    }

    /// <summary>Adds a plane, unless an equal one is there that is as deep.</summary>
    public static void Add(List<OpenPlane> planes, in OpenPlane one)
    {
        if (planes.Count == MostPlanes) return;
        foreach (OpenPlane plane in planes)
        {
            Double3 to = one.Foot - plane.Foot;
            bool isAsDeep = plane.Depth >= one.Depth && (plane.Normal - one.Normal).SumOfMagnitudes <= Room;
            double least = Room * to.SumOfMagnitudes;
            if (isAsDeep && Math.Abs(Double3.Dot(to, one.Normal)) <= least) return;
        }

        planes.Add(one);
    }

    /// <summary>Whether a contact is at a side that is covered.</summary>
    /// <param name="contact">The contact's points.</param>
    /// <param name="own">The part with the side.</param>
    /// <param name="planes">Those of all contacts.</param>
    /// <param name="cover">The parts that may cover it.</param>
    public static bool IsBuried(
        in ContactManifold contact, in ConvexShape own, List<OpenPlane> planes, in PartsCover cover)
    {
        Double3 outward = cover.IsA ? contact.Normal : -contact.Normal;
        foreach (OpenPlane plane in planes)
        {
            bool isBehind = IsAcross(plane, outward);
            for (int i = 0; i < contact.Count && isBehind; i++)
                isBehind = IsBehind(plane, FootOf(contact[i], cover.IsA, cover.Side.Pose), outward, own, cover);
            if (isBehind) return true;
        }

        return false;
    }

    /// <summary>Whether a contact's part stands beyond the plane of another contact, as a wall on a floor. At the
    /// part's witness the union goes on.</summary>
    /// <param name="own">The part.</param>
    /// <param name="planes">Those of all contacts.</param>
    /// <param name="cover">The union around the part.</param>
    public static bool StandsOn(in ConvexShape own, List<OpenPlane> planes, in PartsCover cover)
    {
        Double3 witness = cover.Witness;
        foreach (OpenPlane plane in planes)
        {
            if (!IsAcross(plane, cover.Outward)) continue;
            Double3 to = plane.Foot - witness;
            if (Math.Abs(Double3.Dot(plane.Normal, to)) <= RoomOf(witness, to, cover.Side)
                && ReachesBeyond(plane, witness, cover.Outward, own, cover.Side))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Replaces the covered contact of two overlapping parts by one along the way that the union shows, if
    /// they have points there.</summary>
    /// <inheritdoc cref="TryPoints"/>
    public static bool TryReplaceAlong(
        ConcaveScratch scratch, bool isA, ref PairContacts contact, float maxGap, in Double3 way)
    {
        bool isThere = TryPoints(scratch, isA, contact, maxGap, way, out ContactManifold manifold, out double tip)
            && tip < 0 && FaceSearch.IsAsDeep(manifold, tip);
        if (!isThere) return false;
        contact = DeepestPoint.MakeContact(contact.PartA, contact.PartB, manifold, contact);
        FlushSides.KeepShown(ref contact, new PartsCover(scratch, isA, contact));
        return true;
    }

    /// <summary>The points of two parts along another way than their own. If none is as deep as the other part's tip,
    /// as at a steep edge, it is the tip, where that is over the side's part.</summary>
    /// <param name="scratch">With both bodies.</param>
    /// <param name="isA">Whether the side is of A.</param>
    /// <param name="contact">The two parts.</param>
    /// <param name="maxGap">In world units.</param>
    /// <param name="way">The direction from the side to the other body, of unit length; 0 has no points.</param>
    /// <param name="manifold">The points.</param>
    /// <param name="tip">How far the tip is from the side.</param>
    public static bool TryPoints(
        ConcaveScratch scratch, bool isA, in PairContacts contact, float maxGap, in Double3 way,
        out ContactManifold manifold, out double tip)
    {
        ConvexShape roomA = default, roomB = default;
        ref readonly ConvexShape a = ref scratch.A.ShapeOf(contact.PartA, ref roomA);
        ref readonly ConvexShape b = ref scratch.B.ShapeOf(contact.PartB, ref roomB);
        RigidPose poseA = scratch.A.Pose, poseB = scratch.B.Pose;
        ContactPlane plane = default;
        tip = double.PositiveInfinity;
        ConvexQuery.Contacts(a, poseA, b, poseB, maxGap, ref plane, out manifold);
        manifold = default;
        if (way.LengthSquared == 0 || plane.Normal.LengthSquared == 0) return false;
        ConvexQuery.ContactsAlong(a, poseA, b, poseB, isA ? way : -way, maxGap, ref plane, out manifold);
        ManifoldPoint point = isA ? Tip(a, poseA, b, poseB, way) : Tip(b, poseB, a, poseA, way);
        tip = point.Gap;
        if (manifold.Count > 0 && FaceSearch.IsAsDeep(manifold, tip, share: 0)) return true;
        double room = Room * ((isA ? a : b).BoundingRadius + ((Double3)point.LocalPointA).SumOfMagnitudes);
        if (!(tip <= Math.Max(maxGap, 0)) || !IsWithin(isA ? a : b, point.LocalPointA, room)) return manifold.Count > 0;
        manifold.Begin((Vector3)(isA ? way : -way));
        manifold.Add(isA ? point : point.Swapped);
        return true;
    }

    /// <summary>A body's tip against a direction, and the point opposite it.</summary>
    public static ManifoldPoint Tip(
        in ConvexShape own, in RigidPose pose, in ConvexShape other, in RigidPose otherPose, in Double3 way)
    {
        RotationD turn = new(otherPose.Rotation);
        Double3 against = turn.InverseRotate(-way);
        other.Support(against, out Double3 point);
        Double3 local = other.Center + point + against * other.Margin;
        return Under(own, pose, way, InWorld(local, otherPose), (Vector3)local);
    }

    /// <summary>Whether a point of a shape's frame is in it, or on it but for rounding.</summary>
    public static bool IsOn(in ConvexShape shape, in Double3 point) =>
        IsWithin(shape, point, Room * point.SumOfMagnitudes);

    /// <summary>A point of another body, and the point opposite it on the plane through a part's furthest
    /// point.</summary>
    public static ManifoldPoint Under(
        in ConvexShape own, in RigidPose pose, in Double3 outward, in Double3 tip, Vector3 localTip)
    {
        double gap = Double3.Dot(outward, tip - FlushSides.Furthest(own, pose, outward));
        Double3 foot = tip - outward * gap;
        var local = (Vector3)new RotationD(pose.Rotation).InverseRotate(foot - pose.Position);
        return new ManifoldPoint((Vector3)foot, (Vector3)tip, local, localTip, (float)gap, 0);
    }

    /// <summary>Whether a part other than the given one holds a point of the world and reaches beyond it.</summary>
    public static bool GoesOn(ConcaveScratch scratch, PartSide side, int but, in Double3 inWorld, in Double3 along)
    {
        Double3 point = side.ToLocal(inWorld), direction = side.ToLocalDirection(along);
        double rounding = side.Rounding;
        if (side.Mesh is null && side.Compound is null) return GoesOn(side.ConvexPart(0), point, direction, rounding);
        if (JoinedGrounds.IsInside(scratch, side, inWorld, along)) return true;
        ConvexShape room = default;
        foreach (int part in scratch.AtPoint.FindParts(side, point))
        {
            if (part == but || IsClear(side, part, point)) continue;
            if (GoesOn(side.ShapeOf(part, ref room), point, direction, rounding)) return true;
        }

        return false;
    }

    /// <summary>Whether a shape holds a point of its frame and reaches beyond it.</summary>
    public static bool GoesOn(in ConvexShape shape, in Double3 point, in Double3 direction, double rounding)
    {
        shape.Support(direction, out Double3 most);
        Double3 to = shape.Center + most + direction * shape.Margin - point;
        double length = to.Length;
        if (!(Double3.Dot(to, direction) > 2 * (Room * length + rounding))) return false;
        return IsWithin(shape, point, Room * (length + point.Length) + rounding);
    }

    /// <summary>Whether a part of a mesh or compound is certainly further from a point than a gap.</summary>
    public static bool IsClear(PartSide side, int part, in Double3 point, double gap = 0)
    {
        if (side.Compound is { } compound)
        {
            Double3 below = compound.Boxes[part].Min - point, above = point - compound.Boxes[part].Max;
            double room = 2 * Room * (below.SumOfMagnitudes + above.SumOfMagnitudes + point.SumOfMagnitudes)
                + 2 * side.Rounding + gap;
            return Math.Max(Math.Max(below.X, above.X), Math.Max(below.Y, above.Y)) > room
                || Math.Max(below.Z, above.Z) > room;
        }

        if (side.Mesh is null) return false;
        side.Mesh.GetCorners(part, out Double3 a, out Double3 b, out Double3 c);
        var reach = new TriangleReach(a, b, c, point);
        return reach.IsBeyond(2 * (Room * (reach.Size + point.SumOfMagnitudes) + side.Rounding) + gap);
    }

    /// <summary>Whether any plane is across a contact's direction. Only such a plane buries it.</summary>
    public static bool IsAnyAcross(List<OpenPlane> planes, in Double3 outward)
    {
        foreach (OpenPlane plane in planes)
            if (IsAcross(plane, outward)) return true;
        return false;
    }

    private static bool IsAcross(in OpenPlane plane, in Double3 outward) =>
        Math.Abs(Double3.Dot(plane.Normal, outward)) < ContactCone.LeastCosine;

    /// <summary>World units: by so much rounding may shift what is at a place.</summary>
    public static double RoundingAt(in Double3 place) => Rounding * place.SumOfMagnitudes;

    public static double RoomOf(in Double3 point, in Double3 to, PartSide side) =>
        Room * ((point - side.Pose.Position).SumOfMagnitudes + to.SumOfMagnitudes) + side.Rounding;

    /// <summary>Whether a point of a side is behind a plane by no more than the other body is pushed out of it, and is
    /// covered there.</summary>
    private static bool IsBehind(
        in OpenPlane plane, in Double3 foot, in Double3 outward, in ConvexShape own, in PartsCover cover)
    {
        Double3 to = plane.Foot - foot;
        double behind = Double3.Dot(plane.Normal, to), room = RoomOf(foot, to, cover.Side);
        if (!(Math.Abs(behind - plane.Depth / 2) <= plane.Depth / 2 + room)) return false;
        Double3 lifted = foot + plane.Normal * behind;
        return cover.GoesOn(lifted, outward) && !ReachesBeyond(plane, lifted, outward, own, cover.Side);
    }

    /// <summary>Whether a part reaches beyond a plane, along its normal or along the side that the part shows at a
    /// point of it.</summary>
    private static bool ReachesBeyond(
        in OpenPlane plane, in Double3 point, in Double3 outward, in ConvexShape own, PartSide side)
    {
        Double3 along = plane.Normal - outward * Double3.Dot(plane.Normal, outward);
        return Holds(own, side, point, plane.Normal) || Holds(own, side, point, along * (1 / along.Length));
    }

    /// <summary>Whether a part holds what is just beyond a point.</summary>
    private static bool Holds(in ConvexShape own, PartSide side, in Double3 point, in Double3 direction)
    {
        Double3 local = side.ToLocal(point), beyond = side.ToLocalDirection(direction);
        own.Support(beyond, out Double3 most);
        double length = (own.Center - local).Length + most.Length + own.Margin + local.Length;
        double room = Room * length + side.Rounding;
        return IsWithin(own, local + beyond * (Beyond * room), room);
    }

    /// <summary>Whether a shape is no further than a distance from a point of its frame, which is rounded to float.
    /// Most parts are far from the point: the distance query stops at twice that.</summary>
    public static bool IsWithin(in ConvexShape shape, in Double3 point, double room)
    {
        var at = (Vector3)point;
        if (shape.Kind == ShapeKind.Triangle && shape.Margin == 0 && shape.TryGetVertex(0, out Double3 a)
            && shape.TryGetVertex(1, out Double3 b) && shape.TryGetVertex(2, out Double3 c))
        {
            var reach = new TriangleReach(a, b, c, at - shape.Center);
            if (reach.IsWithin(room / 2)) return true;
            if (reach.IsBeyond(2 * room)) return false;
        }

        return ConvexQuery.Distance(shape, RigidPose.Identity, at, (float)(2 * room)).Distance <= room;
    }
}
