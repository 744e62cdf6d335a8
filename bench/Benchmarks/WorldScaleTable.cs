using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using Gjk.Bench.Scenes;
using Gjk.Core;

namespace Gjk.Bench.Benchmarks;

/// <summary>
/// How a frame grows with the number of objects: every broad phase, at rest and moving, without BenchmarkDotNet, in a minute or two. Each figure is the median
/// of many frames, after frames that are not measured.
/// </summary>
public static class WorldScaleTable
{
    public const string CsvHeader = "objects,motion,phase,threads,broad_ms,narrow_ms,frame_ms,candidates,pairs,touching,bytes_per_frame,memory_mb";

    /// <summary>Count: above it, comparing all pairs takes seconds per frame and shows nothing new.</summary>
    private const int MostForAllPairs = 20_000;

    /// <summary>Seconds until the runtime has optimised the code with what it saw.</summary>
    private const double WarmUpSeconds = 0.6;

    /// <summary>Seconds of frames that are measured.</summary>
    private const double MeasureSeconds = 0.8;

    /// <summary>Frames, where one takes longer than the seconds allow.</summary>
    private const int LeastFrames = 5;

    private static readonly int[] Sizes = [20, 200, 2_000, 20_000, 100_000];

    private static readonly BroadPhaseKind[] Phases =
        [BroadPhaseKind.AllPairs, BroadPhaseKind.SortAndSweep, BroadPhaseKind.SweepAndPrune, BroadPhaseKind.DynamicTree];

    /// <summary>Measures all sizes up to a largest one and prints a Markdown table, row by row.</summary>
    /// <param name="output">Where to.</param>
    /// <param name="maxObjects">Sizes above it are left out.</param>
    /// <param name="csv">Gets the same rows with more columns; null for none.</param>
    public static void Run(TextWriter output, int maxObjects = 100_000, TextWriter? csv = null)
    {
        using var workers = new Workers();
        output.WriteLine("| objects | motion | broad phase | threads | move + broad ms | narrow ms | frame ms | candidates | pairs | touching % | bytes/frame | memory MB |");
        output.WriteLine("|---:|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
        csv?.WriteLine(CsvHeader);
        foreach (int count in Sizes.Where(size => size <= maxObjects))
        {
            foreach (bool moving in new[] { false, true })
            {
                foreach (BroadPhaseKind phase in Phases.Where(p => p != BroadPhaseKind.AllPairs || count <= MostForAllPairs))
                {
                    Write(output, csv, Measure(count, moving, phase, null));
                    if (workers.ThreadCount > 1) Write(output, csv, Measure(count, moving, phase, workers));
                }
            }
        }

        output.WriteLine();
        RunReportScenes(output);
    }

    /// <summary>The report's scenes of 20 objects through a <see cref="CollisionScene"/>: which pairs intersect, with everything moved; all 190 distances, at rest and moved.</summary>
    public static void RunReportScenes(TextWriter output)
    {
        output.WriteLine("| report's scene | intersecting pairs, objects moved, ms | 190 distances, warm, at rest, ms | 190 distances, warm, moved, ms |");
        output.WriteLine("|---|---:|---:|---:|");
        foreach (string name in ReportScenes.Names)
        {
            BenchScene objects = ReportScenes.Create(name);
            double overlaps = ReportFrame(objects, moving: true, distances: false), rest = ReportFrame(objects, moving: false, distances: true);
            double moved = ReportFrame(objects, moving: true, distances: true);
            output.WriteLine(FormattableString.Invariant($"| {name} | {overlaps:0.0000} | {rest:0.0000} | {moved:0.0000} |"));
        }
    }

    private static Row Measure(int count, bool moving, BroadPhaseKind phase, Workers? workers)
    {
        long before = GC.GetTotalMemory(forceFullCollection: true);
        var objects = new WorldScenes(count);
        CollisionScene scene = objects.CreateScene(phase);
        List<ObjectPair> candidates = [], pairs = [];
        var clock = new Stopwatch();
        Repeat(WarmUpSeconds, () => Frame(objects, scene, moving, workers, candidates, pairs, clock, out _, out _));
        double memory = (GC.GetTotalMemory(forceFullCollection: true) - before) / 1e6;

        var broad = new Samples();
        var narrow = new Samples();
        var whole = new Samples();
        long allocated = 0, candidateCount = 0, pairCount = 0, touching = 0;
        int frames = Repeat(MeasureSeconds, () =>
        {
            allocated += Frame(objects, scene, moving, workers, candidates, pairs, clock, out double broadMs, out double narrowMs);
            broad.Add(broadMs);
            narrow.Add(narrowMs);
            whole.Add(broadMs + narrowMs);
            candidateCount += candidates.Count;
            pairCount += pairs.Count;
        });
        touching = pairs.SelectMany(p => new[] { p.A, p.B }).Distinct().Count();
        return new Row(
            count, moving, phase, workers?.ThreadCount ?? 1, broad.Median, narrow.Median, whole.Median, candidateCount / frames, pairCount / frames,
            100.0 * touching / count, allocated / frames, memory);
    }

    /// <summary>One frame; the bytes that it allocated on all threads where it uses several, on this one otherwise.</summary>
    private static long Frame(
        WorldScenes objects, CollisionScene scene, bool moving, Workers? workers, List<ObjectPair> candidates, List<ObjectPair> pairs, Stopwatch clock,
        out double broadMs, out double narrowMs)
    {
        if (moving) objects.Advance();
        long before = workers is null ? GC.GetAllocatedBytesForCurrentThread() : GC.GetTotalAllocatedBytes();
        clock.Restart();
        if (moving) objects.MoveAll(scene);
        scene.CollectCandidates(candidates);
        broadMs = clock.Elapsed.TotalMilliseconds;
        scene.OverlapsOf(candidates, pairs, workers);
        narrowMs = clock.Elapsed.TotalMilliseconds - broadMs;
        return (workers is null ? GC.GetAllocatedBytesForCurrentThread() : GC.GetTotalAllocatedBytes()) - before;
    }

    private static double ReportFrame(BenchScene objects, bool moving, bool distances)
    {
        var scene = new CollisionScene(BroadPhaseKind.AllPairs);
        for (int i = 0; i < objects.Shapes.Length; i++) scene.Add(objects.Shapes[i], objects.Poses[i]);
        RigidPose[][] frames = [objects.Poses, [.. objects.Poses.Select(p => new RigidPose(p.Rotation, p.Position + new System.Numerics.Vector3(0.01f, 0, 0.01f)))]];
        List<ObjectPair> pairs = [];
        var sum = default(Sum);
        int frame = 0;
        void Run()
        {
            RigidPose[] poses = frames[frame++ & 1];
            for (int i = 0; moving && i < poses.Length; i++) scene.Move(i, poses[i]);
            if (distances) scene.PairsWithin(float.PositiveInfinity, ref sum);
            else scene.Overlaps(pairs);
        }

        Repeat(WarmUpSeconds, Run);
        const int Batch = 50;
        var samples = new Samples();
        Repeat(MeasureSeconds, () =>
        {
            long start = Stopwatch.GetTimestamp();
            for (int i = 0; i < Batch; i++) Run();
            samples.Add(Stopwatch.GetElapsedTime(start).TotalMilliseconds / Batch);
        });
        return samples.Median;
    }

    /// <summary>How often it ran.</summary>
    private static int Repeat(double seconds, Action work)
    {
        int runs = 0;
        for (var clock = Stopwatch.StartNew(); runs < LeastFrames || clock.Elapsed.TotalSeconds < seconds; runs++) work();
        return runs;
    }

    private static void Write(TextWriter output, TextWriter? csv, in Row row)
    {
        string motion = row.Moving ? "moving" : "static";
        output.WriteLine(string.Create(CultureInfo.InvariantCulture,
            $"| {row.Objects} | {motion} | {row.Phase} | {row.Threads} | {row.BroadMs:0.0000} | {row.NarrowMs:0.0000} | {row.FrameMs:0.0000} | {row.Candidates} | {row.Pairs} | {row.TouchingPercent:0} | {row.Bytes} | {row.MemoryMb:0.0} |"));
        output.Flush();
        csv?.WriteLine(string.Create(CultureInfo.InvariantCulture,
            $"{row.Objects},{motion},{row.Phase},{row.Threads},{row.BroadMs:0.#####},{row.NarrowMs:0.#####},{row.FrameMs:0.#####},{row.Candidates},{row.Pairs},{row.TouchingPercent:0.#},{row.Bytes},{row.MemoryMb:0.##}"));
    }

    private readonly record struct Row(
        int Objects, bool Moving, BroadPhaseKind Phase, int Threads, double BroadMs, double NarrowMs, double FrameMs, long Candidates, long Pairs,
        double TouchingPercent, long Bytes, double MemoryMb);

    private struct Sum : IPairDistanceVisitor
    {
        public float Total { get; private set; }

        public void Visit(ObjectPair pair, in DistanceResult result) => Total += result.Distance;
    }
}
