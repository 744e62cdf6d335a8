using System;
using System.Numerics;
using Gjk.Core;

namespace Gjk.Bench.Scenes;

/// <summary>
/// Poses of a scene over a few frames, walked to and fro so that they never run out: the second object of each pair turns by a degree about an axis of its
/// own and moves by one percent of a size of 1; the first one rests. For scenes that use an object in one pair only.
/// </summary>
public sealed class Motion
{
    private const int FrameCount = 8;
    private const float RadiansPerFrame = MathF.PI / 180;
    private const float UnitsPerFrame = 0.01f;
    private const ulong Seed = 41;

    private readonly RigidPose[][] _frames = new RigidPose[FrameCount][];
    private int _frame;
    private int _step = 1;

    public Motion(BenchScene scene)
    {
        for (int i = 0; i < FrameCount; i++) _frames[i] = [.. scene.Poses];
        var prng = new Prng(Seed);
        foreach (BenchScene.Pair pair in scene.Pairs)
        {
            RigidPose start = scene.Poses[pair.B];
            Vector3 axis = prng.Direction(), course = prng.Direction() * UnitsPerFrame;
            for (int i = 0; i < FrameCount; i++)
            {
                Quaternion turn = Quaternion.CreateFromAxisAngle(axis, i * RadiansPerFrame);
                _frames[i][pair.B] = new RigidPose(Quaternion.Normalize(turn * start.Rotation), start.Position + i * course);
            }
        }
    }

    /// <summary>One frame on from the last.</summary>
    public RigidPose[] Next()
    {
        if (_frame + _step is < 0 or >= FrameCount) _step = -_step;
        _frame += _step;
        return _frames[_frame];
    }
}
