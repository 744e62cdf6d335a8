namespace Gjk.Exact.Scenes;

/// <summary>Changes poses. The computation is in double.</summary>
public static class PoseMotion
{
    /// <summary>Moves a pose, and turns it about the object's own position. If the position would leave the range of
    /// float, the pose is only turned.</summary>
    /// <param name="pose">Where the object was.</param>
    /// <param name="by">The displacement in world units.</param>
    /// <param name="turn">The imaginary part of the quaternion that turns the pose. The quaternion need not have unit
    /// length. The axis times the tangent of half the angle is enough, with a real part of 1.</param>
    /// <param name="turnW">The real part of that quaternion.</param>
    public static RigidPose Moved(in RigidPose pose, in Double3 by, in Double3 turn, double turnW)
    {
        Quaternion q = pose.Rotation;
        double x = turnW * q.X + turn.X * q.W + turn.Y * q.Z - turn.Z * q.Y;
        double y = turnW * q.Y + turn.Y * q.W + turn.Z * q.X - turn.X * q.Z;
        double z = turnW * q.Z + turn.Z * q.W + turn.X * q.Y - turn.Y * q.X;
        double w = turnW * q.W - turn.X * q.X - turn.Y * q.Y - turn.Z * q.Z;
        double unit = 1 / Math.Sqrt(x * x + y * y + z * z + w * w);
        var rotation = new Quaternion((float)(x * unit), (float)(y * unit), (float)(z * unit), (float)(w * unit));
        var position = (Vector3)(pose.Position + by);
        return new RigidPose(rotation, ((Double3)position).IsFinite ? position : pose.Position);
    }
}
