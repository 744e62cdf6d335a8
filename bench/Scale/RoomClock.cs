using Gjk.Bench.Scenes;
using Gjk.Core;

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
    private double _broadMs, _narrowMs;

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
    /// <param name="workers">The threads of the narrow phase, or null.</param>
    /// <param name="seconds">How many seconds to measure after the warm-up.</param>
    public static FrameFigures Measure(int count, bool isMoving, BroadPhaseKind phase, Workers? workers, double seconds)
    {
        var objects = new WorldScenes(count);
        long before = GC.GetTotalMemory(forceFullCollection: true);
        var clock = new RoomClock(objects, isMoving, phase, workers);
        FrameLoop.WarmUp(clock.Frame);
        double memory = (GC.GetTotalMemory(forceFullCollection: true) - before) / 1e6;
        return clock.Measure(seconds, memory);
    }

    private FrameFigures Measure(double seconds, double memory)
    {
        Samples broad = new(), narrow = new(), whole = new();
        long candidates = 0, pairs = 0;
        int frames = FrameLoop.Repeat(seconds, () =>
        {
            Frame();
            broad.Add(_broadMs);
            narrow.Add(_narrowMs);
            whole.Add(_broadMs + _narrowMs);
            candidates += _candidates.Count;
            pairs += _pairs.Count;
        });
        int touching = _pairs.SelectMany(p => new[] { p.A, p.B }).Distinct().Count();
        return new FrameFigures(
            broad.Median, narrow.Median, whole.Median, (double)candidates / frames, (double)pairs / frames,
            (double)touching / _scene.Count,
            FrameLoop.BytesPerFrame(Frame, frames), memory);
    }

    /// <summary>Runs one frame. The new poses are computed before its clock starts.</summary>
    private void Frame()
    {
        if (_isMoving) _objects.Advance();
        long start = Stopwatch.GetTimestamp();
        if (_isMoving) _objects.MoveAll(_scene);
        _scene.CollectCandidates(_candidates);
        long middle = Stopwatch.GetTimestamp();
        _scene.FindOverlapsAmong(_candidates, _pairs, _workers);
        long end = Stopwatch.GetTimestamp();
        _broadMs = FrameLoop.Milliseconds(middle - start);
        _narrowMs = FrameLoop.Milliseconds(end - middle);
    }
}
