using System;
using System.Numerics;
using Gjk.Core;

namespace Gjk.Demo.Scenes;

/// <summary>Poses that change, worked out in double.</summary>
internal static class PoseMotion
{
    /// <summary>A pose moved and turned about the object's own place; where the position would leave the numbers of float, only turned.</summary>
    /// <param name="pose">Where the object was.</param>
    /// <param name="by">World units.</param>
    /// <param name="turn">The imaginary part of the quaternion that turns it, which need not have unit length: the axis times the tangent of half the angle will do, with a real part of 1.</param>
    /// <param name="turnW">Its real part.</param>
    public static RigidPose Moved(in RigidPose pose, in Vector3D by, in Vector3D turn, double turnW)
    {
        Quaternion q = pose.Rotation;
        double x = turnW * q.X + turn.X * q.W + turn.Y * q.Z - turn.Z * q.Y;
        double y = turnW * q.Y + turn.Y * q.W + turn.Z * q.X - turn.X * q.Z;
        double z = turnW * q.Z + turn.Z * q.W + turn.X * q.Y - turn.Y * q.X;
        double w = turnW * q.W - turn.X * q.X - turn.Y * q.Y - turn.Z * q.Z;
        double unit = 1 / Math.Sqrt(x * x + y * y + z * z + w * w);
        var rotation = new Quaternion((float)(x * unit), (float)(y * unit), (float)(z * unit), (float)(w * unit));
        var position = (Vector3)(pose.Position + by);
        return new RigidPose(rotation, IsFinite(position) ? position : pose.Position);
    }

    private static bool IsFinite(Vector3 v) => float.IsFinite(v.X) && float.IsFinite(v.Y) && float.IsFinite(v.Z);
}
