using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Runtime.InteropServices;
using Gjk.Core;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.Replay;

/// <summary>A scene whose objects move, and what its last frame found.</summary>
internal sealed class World
{
    private readonly MovingObjects _objects;
    private readonly CollisionScene _scene;
    private readonly Workers? _workers;
    private readonly List<ObjectPair> _candidates = [];
    private readonly List<ObjectPair> _pairs = [];

    /// <param name="scene">The objects; an id is an index.</param>
    /// <param name="settings">How to move them and to find pairs.</param>
    /// <param name="workers">The threads, or null.</param>
    public World(BuiltInScene scene, WorldSettings settings, Workers? workers)
    {
        var shape = ConvexShape.Mesh(scene.Vertices);
        HullVertices = shape.Hull!.VertexCount;
        _objects = new MovingObjects(scene, settings.Speed);
        _scene = new CollisionScene(settings.BroadPhase);
        foreach (RigidPose pose in scene.Poses) _scene.Add(shape, pose);
        _workers = workers;
    }

    public int HullVertices { get; }

    /// <summary>Pairs that the broad phase left to the narrow one: the calls made.</summary>
    public int Calls => _candidates.Count;

    public ReadOnlySpan<ObjectPair> IntersectingPairs => CollectionsMarshal.AsSpan(_pairs);

    /// <summary>Ticks that the last frame took to move the objects and find candidates.</summary>
    public long BroadTicks { get; private set; }

    /// <summary>Ticks that the last frame took to ask which candidates intersect.</summary>
    public long NarrowTicks { get; private set; }

    /// <summary>Bytes that the last frame allocated on this thread.</summary>
    public long Bytes { get; private set; }

    /// <summary>Finds the pairs of this frame. Where the objects go was worked out before.</summary>
    public void Run()
    {
        long bytes = GC.GetAllocatedBytesForCurrentThread();
        long start = Stopwatch.GetTimestamp();
        RigidPose[] poses = _objects.Poses;
        for (int i = 0; _objects.IsMoving && i < poses.Length; i++) _scene.Move(i, poses[i]);
        _scene.CollectCandidates(_candidates);
        long middle = Stopwatch.GetTimestamp();
        _scene.FindOverlapsAmong(_candidates, _pairs, _workers);
        long end = Stopwatch.GetTimestamp();
        Bytes = GC.GetAllocatedBytesForCurrentThread() - bytes;
        BroadTicks = middle - start;
        NarrowTicks = end - middle;
    }

    /// <summary>One frame on.</summary>
    public void Advance() => _objects.Advance();

    /// <summary>Back to the first frame, and its pairs.</summary>
    public void Rewind()
    {
        _objects.Rewind();
        Run();
    }
}
