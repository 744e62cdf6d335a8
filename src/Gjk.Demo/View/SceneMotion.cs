namespace Gjk.Demo.View;

/// <summary>The poses of a scene's objects in each frame. From the given poses, objects move and turn at constant
/// rates. They turn about the world's axes.</summary>
internal sealed class SceneMotion
{
    private readonly Scene _scene;
    private readonly string _name;

    /// <param name="scene">The scene.</param>
    /// <param name="name">The user's name for the scene. It is used if a motion is refused because it leaves the range
    /// of float.</param>
    public SceneMotion(Scene scene, string name)
    {
        _scene = scene;
        _name = name;
    }

    /// <summary>The poses of a frame. Each is computed from the first frame, so that no error accumulates. The first
    /// frame has the poses as given.</summary>
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

            Double3 by = (Double3)o.Velocity * frame;
            var position = (Vector3)(o.Pose.Position + by);
            if (!float.IsFinite(position.X + position.Y + position.Z))
                throw new RefusedException(
                    $"{_name}: $.objects[{i}].velocity: the position leaves the range of float in frame {frame}");
            Double3 spin = o.AngularVelocity;
            double speed = spin.Length;
            (double sin, double cos) = Math.SinCos(speed * frame / 2);
            poses[i] = speed > 0
                ? PoseMotion.Moved(o.Pose, by, spin * (sin / speed), cos)
                : new RigidPose(o.Pose.Rotation, position);
        }
    }
}
