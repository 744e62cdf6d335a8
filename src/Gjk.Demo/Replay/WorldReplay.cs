using System;
using System.Diagnostics;
using System.Threading;
using Gjk.Core;
using Gjk.Demo.Queries;
using Gjk.Demo.Scenes;
using Gjk.Demo.Timing;

namespace Gjk.Demo.Replay;

/// <summary>Replays a scene as a world: in each frame the objects move, and the intersecting pairs are found.</summary>
internal static class WorldReplay
{
    /// <summary>
    /// Frames whose pairs are counted and hashed where the frames are not counted by the user: always as many, so that what does not depend on the machine's speed does not
    /// depend on it here; few, so that comparing all pairs of many objects can be waited for.
    /// </summary>
    private const int CountedFrames = 10;

    private const double NsPerMs = 1e6;

    /// <param name="scene">Which one.</param>
    /// <param name="settings">How.</param>
    /// <param name="length">How long to measure, after the warm-up; at least the counted frames.</param>
    /// <param name="progress">Is told how much is done, from 0 to 1, between the frames.</param>
    /// <param name="cancel">Throws the scene away.</param>
    public static WorldReport Run(BuiltInScene scene, WorldSettings settings, ReplayLength length, Action<double> progress, CancellationToken cancel)
    {
        using Workers? workers = settings.Threads > 1 ? new Workers(settings.Threads) : null;
        var world = new World(scene, settings, workers);
        WarmUp.Run(
            () =>
            {
                world.Run();
                world.Advance();
            },
            length.Frames is null ? WarmUp.Usual : WarmUp.Short,
            cancel);
        world.Rewind();
        var report = new WorldReport(scene, world.HullVertices, settings);
        Measure(world, report, length, progress, cancel);
        return report;
    }

    private static void Measure(World world, WorldReport report, ReplayLength length, Action<double> progress, CancellationToken cancel)
    {
        var hash = new ResultHash();
        Samples broad = new(), narrow = new(), whole = new();
        long bytes = 0;
        int counted = length.Frames ?? CountedFrames;
        long start = Stopwatch.GetTimestamp();
        for (int frame = 0; frame < counted || length.Done(frame, Stopwatch.GetElapsedTime(start)) < 1; frame++)
        {
            cancel.ThrowIfCancellationRequested();
            world.Run();
            broad.Add(world.BroadTicks);
            narrow.Add(world.NarrowTicks);
            whole.Add(world.BroadTicks + world.NarrowTicks);
            bytes += world.Bytes;
            if (frame < counted)
            {
                hash.Add(world.IntersectingPairs);
                report.Count(world);
            }

            world.Advance();
            progress(length.Done(frame + 1, Stopwatch.GetElapsedTime(start)));
        }

        report.Frames = whole.Count;
        report.Hash = hash.ToString();
        report.BroadMs = broad.MedianNs / NsPerMs;
        report.NarrowMs = narrow.MedianNs / NsPerMs;
        report.MedianMs = whole.MedianNs / NsPerMs;
        report.P99Ms = whole.PercentileNs(0.99) / NsPerMs;
        report.BytesPerFrame = (double)bytes / whole.Count;
    }
}
