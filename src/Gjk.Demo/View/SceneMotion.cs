using System;
using System.Numerics;
using Gjk.Core;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.View;

/// <summary>Where the objects of a scene are in each of its frames: moved evenly, and turned evenly about the world's axes, from the poses given.</summary>
internal sealed class SceneMotion
{
    private readonly Scene _scene;
    private readonly string _name;

    /// <param name="scene">The scene.</param>
    /// <param name="name">What the user calls it, for the refusal of a motion that leaves the range of float.</param>
    public SceneMotion(Scene scene, string name)
    {
        _scene = scene;
        _name = name;
    }

    /// <summary>The poses of a frame, each worked out from the first, so that no error grows; the first has the poses as given.</summary>
    /// <exception cref="RefusedException">A position is beyond the range of float.</exception>
    public void Poses(int frame, Span<RigidPose> poses)
    {
        for (int i = 0; i < poses.Length; i++)
        {
            SceneObject o = _scene.Objects[i];
            if (frame == 0 || (o.Velocity == Vector3.Zero && o.AngularVelocity == Vector3.Zero))
            {
                poses[i] = o.Pose;
                continue;
            }

            var position = (Vector3)(o.Pose.Position + (Vector3D)o.Velocity * frame);
            if (!float.IsFinite(position.X + position.Y + position.Z))
                throw new RefusedException($"{_name}: $.objects[{i}].velocity: the position leaves the range of float in frame {frame}");
            poses[i] = new RigidPose(Turned(o.Pose.Rotation, o.AngularVelocity, frame), position);
        }
    }

    private static Quaternion Turned(Quaternion q, Vector3D perFrame, int frames)
    {
        double speed = perFrame.Length;
        if (speed == 0) return q;
        (double s, double c) = Math.SinCos(speed * frames / 2);
        double tx = perFrame.X / speed * s, ty = perFrame.Y / speed * s, tz = perFrame.Z / speed * s;
        double x = c * q.X + tx * q.W + ty * q.Z - tz * q.Y;
        double y = c * q.Y + ty * q.W + tz * q.X - tx * q.Z;
        double z = c * q.Z + tz * q.W + tx * q.Y - ty * q.X;
        double w = c * q.W - tx * q.X - ty * q.Y - tz * q.Z;
        double unit = 1 / Math.Sqrt(x * x + y * y + z * z + w * w);
        return new Quaternion((float)(x * unit), (float)(y * unit), (float)(z * unit), (float)(w * unit));
    }
}
