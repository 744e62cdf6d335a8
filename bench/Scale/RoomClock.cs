namespace Gjk.Bench.Scale;

/// <summary>Measures the frames of a room of cubes.</summary>
internal sealed class RoomClock
{
    private readonly WorldScenes _objects;
    private readonly bool _isMoving;
    private readonly CollisionScene _scene;
    private readonly Workers? _workers;
    private readonly List<ObjectPair> _candidates = [];
    private readonly List<ObjectPair> _pairs = [];

    private RoomClock(WorldScenes objects, bool isMoving, BroadPhaseKind phase, Workers? workers)
    {
        _objects = objects;
        _isMoving = isMoving;
        _scene = objects.CreateScene(phase);
        _workers = workers;
    }

    /// <param name="count">How many cubes there are.</param>
    /// <param name="isMoving">True if all of them move, false if none does.</param>
    /// <param name="phase">How pairs are found.</param>
    /// <param name="workers">The threads, or null.</param>
    /// <param name="seconds">How many seconds to measure after the warm-up.</param>
    public static FrameFigures Measure(int count, bool isMoving, BroadPhaseKind phase, Workers? workers, double seconds)
    {
        var objects = new WorldScenes(count);
        long before = GC.GetTotalMemory(forceFullCollection: true);
        var clock = new RoomClock(objects, isMoving, phase, workers);
        FrameLoop.WarmUp(() => clock.Frame());
        double memory = (GC.GetTotalMemory(forceFullCollection: true) - before) / 1e6;
        return clock.Measure(seconds, memory);
    }

    private FrameFigures Measure(double seconds, double memory)
    {
        Samples broad = new(), whole = new();
        long candidates = 0, pairs = 0;
        int frames = FrameLoop.Repeat(seconds, () =>
        {
            broad.Add(BroadFrame());
            whole.Add(Frame());
            candidates += _candidates.Count;
            pairs += _pairs.Count;
        });
        int touching = _pairs.SelectMany(p => new[] { p.A, p.B }).Distinct().Count();
        return new FrameFigures(
            broad.Median, whole.Median - broad.Median, whole.Median, (double)candidates / frames,
            (double)pairs / frames, (double)touching / _scene.Count,
            FrameLoop.BytesPerFrame(() => Frame(), frames), memory);
    }

    /// <summary>Runs one frame and returns its milliseconds. The new poses are computed before its clock
    /// starts.</summary>
    private double Frame() => Clocked(() => _scene.FindOverlaps(_pairs, _workers));

    /// <summary>The same without the narrow phase.</summary>
    private double BroadFrame() => Clocked(() => _scene.CollectCandidates(_candidates, 0, _workers));

    private double Clocked(Action question)
    {
        if (_isMoving) _objects.Advance();
        long start = Stopwatch.GetTimestamp();
        if (_isMoving) _objects.MoveAll(_scene, _workers);
        question();
        return FrameLoop.Milliseconds(Stopwatch.GetTimestamp() - start);
    }
}
