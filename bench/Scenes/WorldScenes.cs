using System;
using System.Numerics;
using Gjk.Core;

namespace Gjk.Bench.Scenes;

/// <summary>
/// Any number of cubes of size 1 in a cubic room at the same density, turned at random, so that about half of them touch another. Moving, each goes one percent of its size per frame in
/// a direction of its own, turns by a degree, and is thrown back by the walls.
/// </summary>
public sealed class WorldScenes
{
    /// <summary>
    /// Units of room along each axis for one object. Two unit cubes at random orientations touch when one's centre is in a volume of 11 about the other's; with 0.69 others in it, half of
    /// the objects have none.
    /// </summary>
    private const float Spacing = 2.517f;

    private const float UnitsPerFrame = 0.01f;
    private const float RadiansPerFrame = MathF.PI / 180;
    private const ulong Seed = 2023;

    private readonly float _side;
    private readonly Vector3[] _velocities;
    private readonly Quaternion[] _turns;

    public WorldScenes(int count)
    {
        var prng = new Prng(Seed);
        _side = Spacing * MathF.Cbrt(count);
        _velocities = new Vector3[count];
        _turns = new Quaternion[count];
        Poses = new RigidPose[count];
        for (int i = 0; i < count; i++)
        {
            var position = new Vector3(prng.Range(0, _side), prng.Range(0, _side), prng.Range(0, _side));
            Poses[i] = new RigidPose(prng.Rotation(), position);
            _velocities[i] = prng.Direction() * UnitsPerFrame;
            _turns[i] = Quaternion.CreateFromAxisAngle(prng.Direction(), RadiansPerFrame);
        }
    }

    /// <summary>The one shape of all objects: the report's cube of 24 vertices.</summary>
    public ConvexShape Shape { get; } = ConvexShape.Mesh(MeshVertices.Cube(0.5f));

    /// <summary>Where the objects are in this frame.</summary>
    public RigidPose[] Poses { get; }

    /// <summary>One frame on.</summary>
    public void Advance()
    {
        for (int i = 0; i < Poses.Length; i++)
        {
            Vector3 position = Poses[i].Position + _velocities[i];
            if (position.X < 0 || position.X > _side) _velocities[i].X = -_velocities[i].X;
            if (position.Y < 0 || position.Y > _side) _velocities[i].Y = -_velocities[i].Y;
            if (position.Z < 0 || position.Z > _side) _velocities[i].Z = -_velocities[i].Z;
            Poses[i] = new RigidPose(Quaternion.Normalize(_turns[i] * Poses[i].Rotation), position);
        }
    }

    /// <summary>A scene of the objects where they are now; ids are indices.</summary>
    public CollisionScene CreateScene(BroadPhaseKind kind)
    {
        var scene = new CollisionScene(kind);
        foreach (RigidPose pose in Poses) scene.Add(Shape, pose);
        return scene;
    }

    /// <summary>Tells a scene where the objects are now.</summary>
    public void MoveAll(CollisionScene scene)
    {
        for (int i = 0; i < Poses.Length; i++) scene.Move(i, Poses[i]);
    }
}
