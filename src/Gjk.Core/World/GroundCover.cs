namespace Gjk.Core;

/// <summary>Static objects beside the one that a contact is with, as far as they are near.</summary>
internal readonly struct GroundCover(SceneObjects objects, List<int> others) : ICover
{
    public bool GoesOn(in Double3 point, in Double3 direction)
    {
        foreach (int other in others)
        {
            RotationD turn = new(objects.Poses[other].Rotation);
            Double3 local = turn.InverseRotate(point - objects.Poses[other].Position);
            if (objects.Parts.GoesOn(other, local, turn.InverseRotate(direction))) return true;
        }

        return false;
    }

    public bool Holds(in Double3 point)
    {
        foreach (int other in others)
        {
            RotationD turn = new(objects.Poses[other].Rotation);
            if (objects.Parts.Holds(other, turn.InverseRotate(point - objects.Poses[other].Position))) return true;
        }

        return false;
    }

    public OpenPlane EndNear(in Double3 witness, in Double3 outward)
    {
        DistanceResult least = default;
        foreach (int other in others)
        {
            Aabb box = objects.Bounds[other].BoxAt(objects.Poses[other]);
            Double3 middle = ((Double3)box.Min + box.Max) * 0.5;
            var pose = new RigidPose((Vector3)FlushSides.Beside(witness, outward, middle));
            PairDistance near = objects.Parts.Distance(
                ConvexShape.Point(), pose, other, float.PositiveInfinity);
            DistanceResult found = near.Result;
            if (!objects.Parts.Shows(other, near.PartB, -found.Normal)) continue;
            if (least.Status == GjkStatus.None || found.Distance < least.Distance) least = found;
        }

        return new OpenPlane(least.PointB, -least.Normal, 0);
    }
}
