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

    public Double3 WayTo(in Double3 point)
    {
        var pose = new RigidPose((Vector3)point);
        DistanceResult least = default;
        foreach (int other in others)
        {
            DistanceResult found = objects.Parts.Distance(
                ConvexShape.Point(), pose, other, float.PositiveInfinity).Result;
            if (least.Status == GjkStatus.None || found.Distance < least.Distance) least = found;
        }

        return -least.Normal;
    }
}
