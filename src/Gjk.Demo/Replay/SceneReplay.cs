using System.Diagnostics;
using Gjk.Demo.Timing;

namespace Gjk.Demo.Replay;

/// <summary>Runs a scene frame by frame. Each frame asks for all pairs, as the report did.</summary>
internal static class SceneReplay
{
    private const double NsPerMs = 1e6;

    /// <param name="scene">The scene.</param>
    /// <param name="length">How long to measure, after the warm-up.</param>
    /// <param name="progress">Receives the completed share, from 0 to 1, between the frames.</param>
    /// <param name="cancel">Ends the work. The scene's results are thrown away.</param>
    public static SceneReport Run(
        ReplayScene scene, ReplayLength length, Action<double> progress, CancellationToken cancel)
    {
        var pairs = new PairLoop(scene.Scene, cancel);
        var results = new DistanceResult[pairs.Count];
        Action ask = () => pairs.Distances(results);
        if (!scene.Scene.IsConvex)
        {
            var concave = new ConcaveLoop(scene.Scene, cancel);
            ask = () => concave.Distances(null, results);
        }

        WarmUp.Run(ask, length.Frames is null ? WarmUp.Usual : WarmUp.Short, cancel);
        Samples frames = Measure(ask, length, progress, cancel, out long bytes);
        double? supportShare = scene.HasPlainMeshes ? new SupportShare(scene.Scene, cancel).Measure() : null;
        return new SceneReport(scene, pairs.A, pairs.B, results)
        {
            Frames = frames.Count,
            MedianMs = frames.MedianNs / NsPerMs,
            P99Ms = frames.PercentileNs(0.99) / NsPerMs,
            SupportShare = supportShare,
            BytesPerCall = (double)bytes / ((long)frames.Count * pairs.Count),
        };
    }

    /// <summary>Times the frames. Work between the frames counts neither in the times nor in the bytes.</summary>
    private static Samples Measure(
        Action ask, ReplayLength length, Action<double> progress, CancellationToken cancel, out long bytes)
    {
        var frames = new Samples();
        bytes = 0;
        long start = Stopwatch.GetTimestamp();
        while (length.Done(frames.Count, Stopwatch.GetElapsedTime(start)) < 1 || frames.Count == 0)
        {
            cancel.ThrowIfCancellationRequested();
            long bytesBefore = GC.GetAllocatedBytesForCurrentThread();
            long before = Stopwatch.GetTimestamp();
            ask();
            long after = Stopwatch.GetTimestamp();
            bytes += GC.GetAllocatedBytesForCurrentThread() - bytesBefore;
            frames.Add(after - before);
            progress(length.Done(frames.Count, Stopwatch.GetElapsedTime(start, after)));
        }

        return frames;
    }
}
