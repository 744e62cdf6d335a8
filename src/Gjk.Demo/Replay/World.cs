using System.Diagnostics;
using System.Runtime.InteropServices;

namespace Gjk.Demo.Replay;

/// <summary>A scene whose objects move, and the results of its last frame.</summary>
internal sealed class World
{
    private readonly MovingObjects _objects;
    private readonly CollisionScene _scene;
    private readonly int[] _ids;
    private readonly Workers? _workers;
    private readonly List<ObjectPair> _candidates = [];
    private readonly List<ObjectPair> _pairs = [];

    /// <param name="scene">The objects. An object's id is its index.</param>
    /// <param name="settings">How the objects move and how pairs are found.</param>
    /// <param name="workers">The threads, or null.</param>
    public World(BuiltInScene scene, WorldSettings settings, Workers? workers)
    {
        var shape = ConvexShape.Mesh(scene.Vertices);
        HullVertices = shape.Hull!.VertexCount;
        _objects = new MovingObjects(scene, settings.Speed);
        _scene = new CollisionScene(settings.BroadPhase);
        _ids = [.. scene.Poses.Select(pose => _scene.Add(shape, pose))];
        _workers = workers;
    }

    public int HullVertices { get; }

    /// <summary>How many pairs the broad phase passed on to the narrow phase. This is the number of calls
    /// made.</summary>
    public int Calls => _candidates.Count;

    public ReadOnlySpan<ObjectPair> IntersectingPairs => CollectionsMarshal.AsSpan(_pairs);

    /// <summary>Ticks that the last frame took to move the objects and to find candidates.</summary>
    public long BroadTicks { get; private set; }

    /// <summary>Ticks that the last frame took to test which candidates intersect.</summary>
    public long NarrowTicks { get; private set; }

    /// <summary>Bytes that the last frame allocated on this thread.</summary>
    public long Bytes { get; private set; }

    /// <summary>Finds the pairs of this frame. The new poses of the objects were computed before.</summary>
    public void Run()
    {
        long bytes = GC.GetAllocatedBytesForCurrentThread();
        long start = Stopwatch.GetTimestamp();
        if (_objects.IsMoving) _scene.MoveAll(_ids, _objects.Poses, _workers);
        _scene.CollectCandidates(_candidates, 0, _workers);
        long middle = Stopwatch.GetTimestamp();
        _scene.FindOverlapsAmong(_candidates, _pairs, _workers);
        long end = Stopwatch.GetTimestamp();
        Bytes = GC.GetAllocatedBytesForCurrentThread() - bytes;
        BroadTicks = middle - start;
        NarrowTicks = end - middle;
    }

    /// <summary>Moves the objects on by one frame.</summary>
    public void Advance() => _objects.Advance();

    /// <summary>Goes back to the first frame and its pairs.</summary>
    public void Rewind()
    {
        _objects.Rewind();
        Run();
    }
}
