namespace Gjk.Core;

/// <summary>Where convex parts are flush or in each other, a contact with one of them may be at a face that another one
/// covers: their union does not end there.</summary>
internal static class CompoundJoints
{
    /// <summary>Ratio to lengths: 2^-18, some roundings of the places of two parts. Less makes a kerb of a seam between
    /// parts whose places are rounded.</summary>
    public const double Room = 4 * ContactCone.Slack;

    /// <summary>Count: so many joints meet at a corner of a box. More are not worth the time.</summary>
    private const int MostJoints = 3;

    /// <summary>Whether another part of a compound covers a point of one.</summary>
    /// <param name="scratch">With both sides.</param>
    /// <param name="side">The side that may be a compound.</param>
    /// <param name="part">The part that the point is of.</param>
    /// <param name="witness">In the side's frame.</param>
    /// <param name="outward">From the side to the other one, in the world.</param>
    public static bool Covers(
        ConcaveScratch scratch, PartSide side, int part, in Double3 witness, in Double3 outward) =>
        CoverOf(scratch, side, part, witness, outward) >= 0;

    private static int CoverOf(
        ConcaveScratch scratch, PartSide side, int part, in Double3 witness, in Double3 outward)
    {
        if (side.Compound is null) return PartSide.NoPart;
        Double3 direction = new RotationD(side.Pose.Rotation).InverseRotate(outward);
        return FindAt(scratch, side.Compound, witness, part, direction);
    }

    /// <summary>The way out of a part of a compound where other parts cover the shortest: that of the other shape when
    /// it is moved off the joints, to the part's middle.</summary>
    /// <param name="scratch">With both sides.</param>
    /// <param name="isA">Whether the compound is A.</param>
    /// <param name="own">The contact that is covered.</param>
    /// <param name="shapeA">The part of A.</param>
    /// <param name="shapeB">The part of B.</param>
    /// <param name="way">From A to B in the world: the covered way, and then the other one.</param>
    public static bool TryOver(
        ConcaveScratch scratch, bool isA, in PartContacts own, in ConvexShape shapeA, in ConvexShape shapeB,
        ref Double3 way)
    {
        PartSide side = isA ? scratch.A : scratch.B;
        ref readonly ConvexShape part = ref isA ? ref shapeA : ref shapeB;
        RigidPose moved = scratch.B.Pose;
        DistanceResult result = own.Result;
        for (int step = 0; result.Distance < 0; step++)
        {
            Double3 witness = isA ? result.LocalPointA : result.LocalPointB;
            int cover = CoverOf(scratch, side, isA ? own.PartA : own.PartB, witness, isA ? way : -way);
            if (cover < 0) return true;
            if (step == MostJoints) return false;
            Double3 joint = ConvexQuery.SignedDistance(
                part, RigidPose.Identity, side.Compound!.Parts[cover], RigidPose.Identity).Normal;
            part.Support(joint, out Double3 front);
            part.Support(-joint, out Double3 back);
            double half = 0.5 * Double3.Dot(joint, front - back) + part.Margin;
            Double3 by = new RotationD(side.Pose.Rotation).Rotate(joint) * (isA ? -half : half);
            moved = new RigidPose(moved.Rotation, (Vector3)(moved.Position + by));
            result = ConvexQuery.SignedDistance(shapeA, scratch.A.Pose, shapeB, moved);
            way = result.Normal;
        }

        return false;
    }

    /// <summary>Whether a point is on a side's convex part, or on any part of its compound.</summary>
    /// <param name="scratch">With both sides.</param>
    /// <param name="side">One of them.</param>
    /// <param name="shape">The part.</param>
    /// <param name="point">In the side's frame.</param>
    public static bool IsOn(ConcaveScratch scratch, PartSide side, in ConvexShape shape, in Double3 point)
    {
        if (side.Compound is not null) return FindAt(scratch, side.Compound, point, PartSide.NoPart, default) >= 0;
        float room = RoomAt(point);
        return ConvexQuery.Distance(shape, RigidPose.Identity, (Vector3)point, room).Distance <= room;
    }

    private static float RoomAt(in Double3 point) => (float)(2 * Room * (1 + point.Length));

    /// <summary>A part, but not a given one, that is at a point, and reaches beyond it if there is a
    /// direction.</summary>
    private static int FindAt(
        ConcaveScratch scratch, CompoundShape compound, in Double3 point, int but, in Double3 direction)
    {
        ConcaveScratch other = scratch.Rent();
        ConcaveQuery.FindPairsWithin(
            AnyShape.Of(compound), RigidPose.Identity, AnyShape.Of(ConvexShape.Point()),
            new RigidPose((Vector3)point), RoomAt(point), other, other.Pairs);
        int found = PartSide.NoPart;
        for (int i = 0; i < other.Pairs.Count && found < 0; i++)
        {
            int part = other.Pairs[i].PartA;
            bool isIt = part != but
                && (direction.LengthSquared == 0 || GoesOn(compound.Parts[part], point, direction));
            if (isIt) found = part;
        }

        scratch.Return(other);
        return found;
    }

    /// <summary>Whether a shape holds a point and reaches beyond it.</summary>
    public static bool GoesOn(in ConvexShape shape, in Double3 point, in Double3 direction)
    {
        shape.Support(direction, out Double3 most);
        Double3 to = shape.Center + most + direction * shape.Margin - point;
        double length = to.Length;
        if (!(Double3.Dot(to, direction) > 2 * Room * length)) return false;
        float near = ConvexQuery.Distance(shape, RigidPose.Identity, (Vector3)point, (float)length).Distance;
        return near <= Room * (length + point.Length);
    }
}
