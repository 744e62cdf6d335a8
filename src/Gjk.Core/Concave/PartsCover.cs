namespace Gjk.Core;

/// <summary>The neighbours of a contact's part: the other parts of its body that are near the same part of the other
/// body. Whatever covers the contact is as near, so it is among them.</summary>
internal readonly struct PartsCover(ConcaveScratch scratch, bool isA, in PairContacts contact)
{
    /// <summary>Count of steps from a witness to the point beyond it: the union's end is looked for so near, and then
    /// further and further. What is not near is more than half as far from that point, with 4 or more. More costs time
    /// only.</summary>
    private const double NearSteps = 8;

    private readonly ObjectPair _pair = contact.Pair;
    private readonly int _other = contact.PartOf(!isA);
    private readonly Vector3 _witness = isA ? contact.Result.LocalPointA : contact.Result.LocalPointB;

    /// <summary>The body with the contact's part.</summary>
    public readonly PartSide Side = scratch.SideOf(contact.Pair.A, isA);

    /// <summary>The part that has the contact.</summary>
    public readonly int Own = contact.PartOf(isA);

    /// <summary>The contact's normal, from the body to the other one.</summary>
    public readonly Double3 Outward = isA ? contact.Result.Normal : -contact.Result.Normal;

    public bool IsA => isA;

    /// <summary>The contact's point on the body, in the world.</summary>
    public Double3 Witness => Side.ToWorld(_witness);

    /// <summary>The range of static objects that may cover the part: all of them, or only the one that the pair is
    /// of.</summary>
    private int FirstGround => isA ? 0 : Math.Max(_pair.A, 0);

    private int EndGround => isA ? Math.Max(scratch.GroundCount, 1) : FirstGround + 1;

    /// <summary>The part's shape. A triangle is written to <paramref name="room"/>.</summary>
    public ref readonly ConvexShape OwnShape(ref ConvexShape room) => ref Side.ShapeOf(Own, ref room);

    /// <summary>Whether another part holds a point of the world and reaches beyond it.</summary>
    /// <param name="point">The point.</param>
    /// <param name="direction">The direction beyond the point.</param>
    /// <param name="isJoint">Whether the triangles of the same mesh are left out.</param>
    public bool GoesOn(in Double3 point, in Double3 direction, bool isJoint = false)
    {
        ConvexShape room = default;
        for (int i = FirstGround; i < EndGround; i++)
        {
            PartSide side = scratch.SideOf(i, isA);
            if (side.IsJoined && !side.MayHold(point)) continue;
            if (i != _pair.A && JoinedGrounds.IsInside(scratch, side, point, direction)) return true;
            Double3 local = side.ToLocal(point), along = side.ToLocalDirection(direction);
            foreach (int k in scratch.AtPoint.Find(scratch, i, isA, _other, local))
            {
                PairDistance near = scratch.Pairs[k];
                if (IsOwn(near, side, isJoint)) continue;
                int part = isA ? near.PartA : near.PartB;
                if (CoveredSides.GoesOn(side.ShapeOf(part, ref room), local, along, side.Rounding)) return true;
            }
        }

        return false;
    }

    /// <summary>Whether another part holds a point and reaches beyond it, that need not be near the same part of the
    /// other body. Where the two are deep, the point may be outside the gap of the pairs.</summary>
    public bool GoesOnAfar(in Double3 point, in Double3 direction) =>
        JoinedGrounds.GoesOn(scratch, Side, Own, point, direction);

    /// <summary>Whether a pair is of the contact's part, or of its mesh where that does not count.</summary>
    private bool IsOwn(in PairDistance near, PartSide side, bool isJoint) => isA
        ? near.Pair.A == _pair.A && (near.PartA == Own || (isJoint && side.Mesh is not null))
        : near.PartB == Own;

    /// <summary>Whether the body holds a point of the world.</summary>
    public bool Holds(in Double3 point)
    {
        ConvexShape room = default;
        return JoinedGrounds.IsOn(scratch, Side, isA, OwnShape(ref room), Side.ToLocal(point));
    }

    /// <summary>The plane in which the body ends near the witness: in front of the point just beyond it, or across the
    /// way out where that point is inside.</summary>
    public OpenPlane FindEnd()
    {
        OpenPlane end;
        for (double steps = NearSteps; !TryFindEnd(steps, out end) && !double.IsInfinity(steps); steps *= steps) { }
        return end;
    }

    /// <summary>Finds the plane among the parts that are near the witness.</summary>
    /// <param name="steps">How many steps from the witness to the point beyond it count as near; infinite for
    /// all.</param>
    /// <param name="end">The plane; none where no part is near.</param>
    /// <returns>False where a part that is not near may end nearer.</returns>
    private bool TryFindEnd(double steps, out OpenPlane end)
    {
        Double3 witness = Witness;
        double sure = double.PositiveInfinity;
        var shape = ConvexShape.Point();
        DistanceResult least = default;
        Double3 foot = default;
        ConvexShape room = default;
        for (int i = FirstGround; i < EndGround; i++)
        {
            PartSide side = scratch.SideOf(i, isA);
            if (side.IsJoined && !side.MayHold(witness)) continue;
            Double3 local = side.ToLocal(witness);
            double step = FlushSides.StepAt(witness, (local - side.Tree.Origin).Length + side.Tree.Radius);
            double gap = PairsAtPoint.AreFew(scratch, i) ? double.PositiveInfinity : steps * step;
            sure = Math.Min(sure, gap / 2);
            foreach (int k in scratch.AtPoint.Find(scratch, i, isA, _other, local, gap))
            {
                PairDistance near = scratch.Pairs[k];
                if (IsOwn(near, side, true)) continue;
                int part = isA ? near.PartA : near.PartB;
                Double3 point = FlushSides.PointBeside(witness, Outward, side.MiddleOfPart(part));
                bool isAny = least.Status != GjkStatus.None;
                double limit = Math.Max(least.Distance, 0);
                if (isAny && CoveredSides.IsClear(side, part, side.ToLocal(point), limit)) continue;
                var pose = new RigidPose((Vector3)point);
                ref readonly ConvexShape beside = ref side.ShapeOf(part, ref room);
                DistanceResult found = ConvexQuery.Distance(beside, side.Pose, shape, pose);
                if (found.Distance == 0)
                    found = ConvexQuery.SignedDistance(beside, side.Pose, LineAlong(beside.BoundingRadius), pose);
                if (!FlushSides.ShowsFace(side, part, found.Normal) || (isAny && found.Distance >= least.Distance))
                    continue;

                // The point in the world is rounded by more than parts near their compound's origin may differ.
                (least, foot) = (found, side.ToWorld(found.LocalPointA));
            }
        }

        end = new OpenPlane(foot, least.Normal, 0);
        return double.IsInfinity(sure) || (least.Status != GjkStatus.None && least.Distance <= sure);
    }

    /// <summary>A line along the contact's normal. A part that it crosses it leaves across its end, and not through the
    /// side that it shares with the next part.</summary>
    private ConvexShape LineAlong(double reach) =>
        ConvexShape.Segment((Vector3)(Outward * -reach), (Vector3)(Outward * reach));
}

/// <summary>A plane that another body is kept or pushed out of.</summary>
internal readonly struct OpenPlane(in Double3 foot, in Double3 normal, double depth)
{
    public readonly Double3 Foot = foot, Normal = normal;

    /// <summary>How far the other body is behind the plane; 0 where it is not.</summary>
    public readonly double Depth = depth;
}
