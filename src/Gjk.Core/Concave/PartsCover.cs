namespace Gjk.Core;

/// <summary>What may go on where a contact is.</summary>
internal interface ICover
{
    /// <summary>Whether a part of it holds a point of the world and reaches beyond it.</summary>
    bool GoesOn(in Double3 point, in Double3 direction);

    /// <summary>Whether it, or what it is around, holds a point of the world.</summary>
    bool Holds(in Double3 point);

    /// <summary>The plane in which it ends near a witness, before what is just beyond that; the way out where that is
    /// in it.</summary>
    OpenPlane EndNear(in Double3 witness, in Double3 outward);
}

/// <summary>The other parts of the body that a contact is of, as far as they are near the same part of the other body.
/// What covers a contact is among them, as it is as near.</summary>
internal readonly struct PartsCover(ConcaveScratch scratch, bool isA, in PairContacts contact) : ICover
{
    private readonly PartSide _side = scratch.SideOf(contact.Pair.A, isA);
    private readonly ObjectPair _pair = contact.Pair;
    private readonly int _own = isA ? contact.PartA : contact.PartB, _other = isA ? contact.PartB : contact.PartA;

    /// <summary>The static objects that may go on, from the first one: all of them, or the one that the body is
    /// at.</summary>
    private int First => isA ? 0 : Math.Max(_pair.A, 0);

    private int End => isA ? Math.Max(scratch.GroundCount, 1) : First + 1;

    public Double3 Witness(in PairContacts one) =>
        CoveredSides.InWorld(isA ? one.Result.LocalPointA : one.Result.LocalPointB, _side.Pose);

    public Double3 Outward(in PairContacts one) => isA ? one.Result.Normal : -one.Result.Normal;

    public bool GoesOnAtWitness(in PairContacts one) => GoesOn(Witness(one), Outward(one), true);

    public bool GoesOn(in Double3 point, in Double3 direction) => GoesOn(point, direction, false);

    /// <summary>Whether a part, or one that is no triangle of the same mesh, holds a point and reaches beyond
    /// it.</summary>
    private bool GoesOn(in Double3 point, in Double3 direction, bool isJoint)
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

    /// <summary>Whether a pair is of another part of the body and the same one of the other body.</summary>
    private bool IsBeside(in PairDistance near, PartSide side, bool isJoint)
    {
        bool isOne = near.Pair.A == _pair.A;
        if (!isA) return isOne && near.PartB != _own && near.PartA == _other;
        return near.PartB == _other && !(isOne && (near.PartA == _own || (isJoint && side.Mesh is not null)));
    }

    public bool Holds(in Double3 point)
    {
        ConvexShape room = default;
        return JoinedGrounds.IsOn(
            scratch, _side, isA, _side.Part(Math.Max(_own, 0), ref room), _side.Local(point));
    }

    public OpenPlane EndNear(in Double3 witness, in Double3 outward)
    {
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
                var pose = new RigidPose((Vector3)FlushSides.Beside(witness, outward, side.MiddleOfPart(part)));
                DistanceResult found = ConvexQuery.Distance(side.Part(part, ref room), side.Pose, shape, pose);
                if (SeamContacts.Judge(side, part, found.Normal) != ContactFit.Stays) continue;
                if (least.Status == GjkStatus.None || found.Distance < least.Distance) least = found;
            }
        }

        return new OpenPlane(least.PointA, least.Normal, 0);
    }
}
