using System;
using System.Numerics;
using Gjk.Core;

namespace Gjk.Demo.Scenes;

/// <summary>
/// The objects of a built-in scene in motion: each goes straight on until a wall throws it back, and turns evenly about an axis of its own. Worked out without trigonometry: the same
/// bits in every run and on every machine.
/// </summary>
public sealed class MovingObjects
{
    private const ulong Seed = 0x4D_6F_74_69_6F_6E;

    private readonly BuiltInScene _scene;
    private readonly Vector3[] _firstSteps;
    private readonly Vector3[] _steps;

    /// <summary>Axis times the tangent of half the angle, per frame.</summary>
    private readonly Vector3D[] _turns;

    /// <param name="scene">Objects of unit size.</param>
    /// <param name="speed">Object sizes per frame. The turn, of about twice as many radians, moves what is half a size from the centre as far.</param>
    public MovingObjects(BuiltInScene scene, double speed)
    {
        _scene = scene;
        IsMoving = speed > 0;
        Poses = [.. scene.Poses];
        _firstSteps = new Vector3[Poses.Length];
        _turns = new Vector3D[Poses.Length];
        ulong seed = Seed;
        for (int i = 0; i < Poses.Length; i++)
        {
            _firstSteps[i] = (Vector3)(BuiltInScenes.NextDirection(ref seed) * speed);
            _turns[i] = BuiltInScenes.NextDirection(ref seed) * speed;
        }

        _steps = [.. _firstSteps];
    }

    /// <summary>Whether the speed is more than 0.</summary>
    public bool IsMoving { get; }

    /// <summary>Where the objects are in this frame; in the first as given.</summary>
    public RigidPose[] Poses { get; }

    /// <summary>One frame on.</summary>
    public void Advance()
    {
        if (!IsMoving) return;
        Aabb room = _scene.Room;
        for (int i = 0; i < Poses.Length; i++)
        {
            RigidPose moved = PoseMotion.Moved(Poses[i], (Vector3D)_steps[i], _turns[i], 1);
            Vector3 position = moved.Position;
            ref Vector3 step = ref _steps[i];
            Reflect(ref position.X, ref step.X, room.Min.X, room.Max.X);
            Reflect(ref position.Y, ref step.Y, room.Min.Y, room.Max.Y);
            Reflect(ref position.Z, ref step.Z, room.Min.Z, room.Max.Z);
            Poses[i] = new RigidPose(moved.Rotation, position);
        }
    }

    /// <summary>Back to the first frame.</summary>
    public void Rewind()
    {
        for (int i = 0; i < Poses.Length; i++) Poses[i] = _scene.Poses[i];
        _firstSteps.CopyTo(_steps, 0);
    }

    /// <summary>Mirrors at the wall that was passed; a step longer than the room ends at the other wall.</summary>
    private static void Reflect(ref float x, ref float step, float min, float max)
    {
        if (x >= min && x <= max) return;
        x = Math.Clamp(x < min ? min + (min - x) : max - (x - max), min, max);
        step = -step;
    }
}
