namespace Gjk.Core;

/// <summary>What of two shapes meets: in this order one of several contacts at the same fraction is taken, so that a
/// body that meets a seam between flat faces gets the normal of a face.</summary>
internal enum MetFeature : byte
{
    Face,
    Edge,
    Corner,

    /// <summary>Nothing is known, as where a search ended at its limit.</summary>
    None,
}

/// <summary>Tells which features meet at a contact.</summary>
internal static class MetFeatures
{
    /// <summary>Ratio to a face's size: 2^-18, some 60 roundings of a normal to float. A normal that is tilted by no
    /// more looks along the face; the seams of CastSeamTests tilt it by a thousand times that.</summary>
    private const double Level = 1.0 / (1 << 18);

    /// <summary>The better of both shapes' features. A round one says nothing beside a flat one.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Its pose at the contact.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Its pose.</param>
    /// <param name="normal">From A to B, in the world.</param>
    public static MetFeature Of(
        in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB, Vector3 normal)
    {
        MetFeature first = Of(a, poseA, normal, out bool isRoundA);
        MetFeature second = Of(b, poseB, -normal, out bool isRoundB);
        return isRoundA ? second : isRoundB || first < second ? first : second;
    }

    /// <summary>Whether one of the shapes shows a face, or is round, where both meet.</summary>
    public static bool AnyIsFace(
        in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB, Vector3 normal) =>
        Of(a, poseA, normal, out _) == MetFeature.Face || Of(b, poseB, -normal, out _) == MetFeature.Face;

    /// <summary>The feature that a shape shows in a direction.</summary>
    public static unsafe MetFeature Of(in ConvexShape shape, in RigidPose pose, Vector3 normal, out bool isRound)
    {
        isRound = false;
        if (!Guard.IsFinite(normal) || normal == Vector3.Zero) return MetFeature.None;
        FaceCorner* memory = stackalloc FaceCorner[FaceCorners.Capacity];
        var corners = new FaceCorners(memory);
        Double3 direction = new RotationD(pose.Rotation).InverseRotate(normal);
        shape.GetFace(direction, ref corners);
        double most = double.NegativeInfinity, size = 0;
        for (int i = 0; i < corners.Count; i++)
        {
            most = Math.Max(most, Double3.Dot(direction, corners[i]));
            size = Math.Max(size, (corners[i] - corners[0]).SumOfMagnitudes);
        }

        int level = 0;
        for (int i = 0; i < corners.Count; i++)
            if (Double3.Dot(direction, corners[i]) >= most - Level * size) level++;
        isRound = level < 3 && (corners.Count == 0 || corners.Side != RoundSide.None || shape.Margin > 0);
        return isRound || level > 2 ? MetFeature.Face : level == 2 ? MetFeature.Edge : MetFeature.Corner;
    }
}
