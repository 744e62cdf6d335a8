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
    private readonly PartSide _side = isA ? scratch.A : scratch.B;
    private readonly int _own = isA ? contact.PartA : contact.PartB, _other = isA ? contact.PartB : contact.PartA;

    public Double3 Witness(in PairContacts one) =>
        CoveredSides.InWorld(isA ? one.Result.LocalPointA : one.Result.LocalPointB, _side.Pose);

    public Double3 Outward(in PairContacts one) => isA ? one.Result.Normal : -one.Result.Normal;

    public bool GoesOnAtWitness(in PairContacts one) => GoesOn(Witness(one), Outward(one));

    public bool GoesOn(in Double3 point, in Double3 direction)
    {
        RotationD turn = new(_side.Pose.Rotation);
        Double3 local = turn.InverseRotate(point - _side.Pose.Position), along = turn.InverseRotate(direction);
        ConvexShape room = default;
        foreach (PairDistance near in scratch.Pairs)
        {
            int part = isA ? near.PartA : near.PartB;
            if (part == _own || (isA ? near.PartB : near.PartA) != _other) continue;
            if (CoveredSides.IsClear(_side, part, local)) continue;
            if (CoveredSides.GoesOn(_side.Part(part, ref room), local, along)) return true;
        }

        return false;
    }

    public bool Holds(in Double3 point)
    {
        ConvexShape room = default;
        Double3 local = new RotationD(_side.Pose.Rotation).InverseRotate(point - _side.Pose.Position);
        return SeamContacts.IsOn(scratch, isA, _side.Part(_own, ref room), local);
    }

    public OpenPlane EndNear(in Double3 witness, in Double3 outward)
    {
        var shape = ConvexShape.Point();
        DistanceResult least = default;
        ConvexShape room = default;
        foreach (PairDistance near in scratch.Pairs)
        {
            int part = isA ? near.PartA : near.PartB;
            if (part == _own || (isA ? near.PartB : near.PartA) != _other) continue;
            (Double3 min, Double3 max) = _side.Compound!.Boxes[part];
            Double3 middle = CoveredSides.InWorld((min + max) * 0.5, _side.Pose);
            var pose = new RigidPose((Vector3)FlushSides.Beside(witness, outward, middle));
            DistanceResult found = ConvexQuery.Distance(_side.Part(part, ref room), _side.Pose, shape, pose);
            if (least.Status == GjkStatus.None || found.Distance < least.Distance) least = found;
        }

        return new OpenPlane(least.PointA, least.Normal, 0);
    }
}
