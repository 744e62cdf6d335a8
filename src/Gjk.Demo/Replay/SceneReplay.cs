using System;
using System.Diagnostics;
using System.Threading;
using Gjk.Core;
using Gjk.Demo.Scenes;
using Gjk.Demo.Timing;

namespace Gjk.Demo.Replay;

/// <summary>Runs one of the built-in scenes frame by frame. Each frame asks for all pairs, as the report did.</summary>
internal static class SceneReplay
{
    private const double NsPerMs = 1e6;

    /// <param name="scene">The scene.</param>
    /// <param name="length">How long to measure, after the warm-up.</param>
    /// <param name="progress">Receives the completed share, from 0 to 1, between the frames.</param>
    /// <param name="cancel">Ends the work. The scene's results are thrown away.</param>
    public static SceneReport Run(
        BuiltInScene scene, ReplayLength length, Action<double> progress, CancellationToken cancel)
    {
        Scene objects = Scene.From(scene);
        var pairs = new PairLoop(objects, cancel);
        var results = new DistanceResult[pairs.Count];
        WarmUp.Run(() => pairs.Distances(results), length.Frames is null ? WarmUp.Usual : WarmUp.Short, cancel);
        Samples frames = Measure(pairs, results, length, progress, cancel, out long bytes);
        double supportShare = new SupportReplay(objects, cancel).Share();
        return new SceneReport(scene, objects.Objects[0].Shape.Hull!.VertexCount, pairs.A, pairs.B, results)
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
        PairLoop pairs, DistanceResult[] results, ReplayLength length, Action<double> progress,
        CancellationToken cancel, out long bytes)
    {
        var frames = new Samples();
        bytes = 0;
        long start = Stopwatch.GetTimestamp();
        while (length.Done(frames.Count, Stopwatch.GetElapsedTime(start)) < 1 || frames.Count == 0)
        {
            cancel.ThrowIfCancellationRequested();
            long bytesBefore = GC.GetAllocatedBytesForCurrentThread();
            long before = Stopwatch.GetTimestamp();
            pairs.Distances(results);
            long after = Stopwatch.GetTimestamp();
            bytes += GC.GetAllocatedBytesForCurrentThread() - bytesBefore;
            frames.Add(after - before);
            progress(length.Done(frames.Count, Stopwatch.GetElapsedTime(start, after)));
        }

        return frames;
    }
}
