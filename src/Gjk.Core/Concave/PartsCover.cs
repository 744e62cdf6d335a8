namespace Gjk.Core;

/// <summary>The other parts of the body that a contact is of, as far as they are near the same part of the other body.
/// What covers a contact is among them, as it is as near.</summary>
internal readonly struct PartsCover(ConcaveScratch scratch, bool isA, in PairContacts contact)
{
    private readonly ObjectPair _pair = contact.Pair;
    private readonly int _other = contact.PartOf(!isA);
    private readonly Vector3 _witness = isA ? contact.Result.LocalPointA : contact.Result.LocalPointB;

    /// <summary>The body.</summary>
    public readonly PartSide Side = scratch.SideOf(contact.Pair.A, isA);

    /// <summary>The part that has the contact.</summary>
    public readonly int Own = contact.PartOf(isA);

    /// <summary>From the body to the other one, along the contact.</summary>
    public readonly Double3 Outward = isA ? contact.Result.Normal : -contact.Result.Normal;

    public bool IsA => isA;

    /// <summary>The body's point of the contact, in the world.</summary>
    public Double3 Witness => CoveredSides.InWorld(_witness, Side.Pose);

    /// <summary>The static objects that may go on, from the first one: all of them, or the one that the body is
    /// at.</summary>
    private int First => isA ? 0 : Math.Max(_pair.A, 0);

    private int End => isA ? Math.Max(scratch.GroundCount, 1) : First + 1;

    /// <summary>The part that has the contact; it may be written to the room that is given.</summary>
    public ref readonly ConvexShape Part(ref ConvexShape room) => ref Side.Part(Own, ref room);

    /// <summary>Whether another part holds a point of the world and reaches beyond it.</summary>
    /// <param name="point">The point.</param>
    /// <param name="direction">Where beyond is.</param>
    /// <param name="isJoint">Whether the triangles of the same mesh are left out.</param>
    public bool GoesOn(in Double3 point, in Double3 direction, bool isJoint = false)
    {
        ConvexShape room = default;
        for (int i = First; i < End; i++)
        {
            PartSide side = scratch.SideOf(i, isA);
            if (side.IsJoined && !side.MayHold(point)) continue;
            if (i != _pair.A && JoinedGrounds.IsInside(scratch, side, point, direction)) return true;
            Double3 local = side.Local(point), along = side.Turned(direction);
            (int begin, int end) = scratch.PairsOf(i);
            for (int k = begin; k < end; k++)
            {
                PairDistance near = scratch.Pairs[k];
                int part = isA ? near.PartA : near.PartB;
                if (!IsBeside(near, side, isJoint) || CoveredSides.IsClear(side, part, local)) continue;
                if (CoveredSides.GoesOn(side.Part(part, ref room), local, along, side.Rounding)) return true;
            }
        }

        return false;
    }

    /// <summary>Whether another part does so that need not be near the same part of the other body: where the two are
    /// deep, what is beyond a witness may be further from that than pairs are looked for.</summary>
    public bool GoesOnAfar(in Double3 point, in Double3 direction) =>
        JoinedGrounds.GoesOn(scratch, Side, Own, point, direction);

    /// <summary>Whether a pair is of another part of the body and the same one of the other body.</summary>
    private bool IsBeside(in PairDistance near, PartSide side, bool isJoint)
    {
        bool isOne = near.Pair.A == _pair.A;
        if (!isA) return isOne && near.PartB != Own && near.PartA == _other;
        return near.PartB == _other && !(isOne && (near.PartA == Own || (isJoint && side.Mesh is not null)));
    }

    /// <summary>Whether the body holds a point of the world.</summary>
    public bool Holds(in Double3 point)
    {
        ConvexShape room = default;
        return JoinedGrounds.IsOn(scratch, Side, isA, Part(ref room), Side.Local(point));
    }

    /// <summary>The plane in which the body ends near the witness: before what is just beyond that, or across the way
    /// out where that is in it.</summary>
    public OpenPlane EndNear()
    {
        Double3 witness = Witness;
        var shape = ConvexShape.Point();
        DistanceResult least = default;
        ConvexShape room = default;
        for (int i = First; i < End; i++)
        {
            PartSide side = scratch.SideOf(i, isA);
            if (side.IsJoined && !side.MayHold(witness)) continue;
            (int begin, int end) = scratch.PairsOf(i);
            for (int k = begin; k < end; k++)
            {
                PairDistance near = scratch.Pairs[k];
                if (!IsBeside(near, side, true)) continue;
                int part = isA ? near.PartA : near.PartB;
                Double3 point = FlushSides.Beside(witness, Outward, side.MiddleOfPart(part));
                bool isAny = least.Status != GjkStatus.None;
                if (isAny && CoveredSides.IsClear(side, part, side.Local(point), Math.Max(least.Distance, 0))) continue;
                var pose = new RigidPose((Vector3)point);
                ref readonly ConvexShape beside = ref side.Part(part, ref room);
                DistanceResult found = ConvexQuery.Distance(beside, side.Pose, shape, pose);
                if (found.Distance == 0)
                    found = ConvexQuery.SignedDistance(beside, side.Pose, Along(beside.BoundingRadius), pose);
                if (SeamContacts.Judge(side, part, found.Normal) != ContactFit.Stays) continue;
                if (!isAny || found.Distance < least.Distance) least = found;
            }
        }

        return new OpenPlane(least.PointA, least.Normal, 0);
    }

    /// <summary>A line along the way out: of a part that it crosses it leaves across that way, and not through the side
    /// that is shared.</summary>
    private ConvexShape Along(double reach) =>
        ConvexShape.Segment((Vector3)(Outward * -reach), (Vector3)(Outward * reach));
}
