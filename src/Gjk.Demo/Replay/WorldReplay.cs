using System.Diagnostics;
using Gjk.Demo.Timing;

namespace Gjk.Demo.Replay;

/// <summary>Replays a scene as a world. In each frame the objects move, and the intersecting pairs are found.</summary>
internal static class WorldReplay
{
    /// <summary>How many frames are counted and hashed if the user does not set the number of frames. The number is
    /// fixed, so that results which do not depend on the machine's speed stay the same on every machine. It is small,
    /// so that the user can wait for the comparison of all pairs of many objects.</summary>
    private const int CountedFrames = 10;

    private const double NsPerMs = 1e6;

    /// <param name="scene">The scene.</param>
    /// <param name="settings">How the objects move and how pairs are found.</param>
    /// <param name="length">How long to measure, after the warm-up. At least the counted frames are run.</param>
    /// <param name="progress">Receives the completed share, from 0 to 1, between the frames.</param>
    /// <param name="cancel">Ends the work. The scene's results are thrown away.</param>
    public static WorldReport Run(
        BuiltInScene scene, WorldSettings settings, ReplayLength length, Action<double> progress,
        CancellationToken cancel)
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

    private static void Measure(
        World world, WorldReport report, ReplayLength length, Action<double> progress, CancellationToken cancel)
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
