using Gjk.Bench.Scenes;
using Gjk.Core;

namespace Gjk.Bench.Scale;

/// <summary>Measures only the broad phases, on the worst arrangements of boxes and on ordinary ones.</summary>
internal static class WorstScale
{
    public const double DefaultSeconds = 0.5;

    private const int Many = 10_000;

    /// <summary>The number of objects if every two of them are a pair. This gives two million pairs.</summary>
    private const int Few = 2_000;

    private const string Header =
        """
        | boxes | objects | broad phase | first, ms | at rest, ms | moving, ms | moving, most | pairs | memory, MB |
        |---|--:|---|--:|--:|--:|--:|--:|--:|

        """;

    private static readonly BroadPhaseKind[] Phases = [BroadPhaseKind.SortAndSweep, BroadPhaseKind.DynamicTree];

    /// <param name="output">Receives a table in Markdown.</param>
    /// <param name="seconds">How many seconds to measure a row at rest, and as many again while it moves.</param>
    public static void Run(TextWriter output, double seconds)
    {
        // This warm-up keeps the compiler's work out of the first row.
        foreach (BroadPhaseKind phase in Phases) Measure("cubes", Few, phase, seconds);
        output.Write(Header);
        foreach (string kind in WorstBoxes.Sparse.Concat(WorstBoxes.Dense))
        {
            int count = WorstBoxes.Dense.Contains(kind) ? Few : Many;
            foreach (BroadPhaseKind phase in Phases) output.Write(Measure(kind, count, phase, seconds));
        }

        output.Write("\nMedians; memory is what the broad phase and the list of pairs hold at the end.\n");
    }

    private static string Measure(string kind, int count, BroadPhaseKind phaseKind, double seconds)
    {
        long before = GC.GetTotalMemory(forceFullCollection: true);
        var boxes = new WorstBoxes(kind, count);
        IBroadPhase phase = Create(phaseKind);
        List<ObjectPair> pairs = [];
        void Ask() => phase.CollectPairs(0, pairs);
        void PlaceAndAsk()
        {
            boxes.Place(phase);
            Ask();
        }

        double first = Milliseconds(PlaceAndAsk);
        double rest = Frames(seconds, () => { }, Ask, out _);
        double moving = Frames(seconds, boxes.Advance, PlaceAndAsk, out double most);
        double memory = (GC.GetTotalMemory(forceFullCollection: true) - before) / 1e6;
        GC.KeepAlive(phase);
        CultureInfo invariant = CultureInfo.InvariantCulture;
        string name = ScaleReport.PhaseName(phaseKind);
        string row = string.Create(invariant, $"| {kind} | {count:#,0} | {name} | {first:0.0} |");
        return string.Create(
            invariant, $"{row} {rest:0.000} | {moving:0.000} | {most:0.0} | {pairs.Count:#,0} | {memory:0.0} |\n");
    }

    /// <summary>Returns the median time of many frames, and the longest time of one frame.</summary>
    private static double Frames(double seconds, Action prepare, Action frame, out double most)
    {
        var samples = new Samples();
        double longest = 0;
        FrameLoop.Repeat(seconds, () =>
        {
            prepare();
            double time = Milliseconds(frame);
            samples.Add(time);
            longest = Math.Max(longest, time);
        });
        most = longest;
        return samples.Median;
    }

    private static double Milliseconds(Action work)
    {
        long start = Stopwatch.GetTimestamp();
        work();
        return FrameLoop.Milliseconds(Stopwatch.GetTimestamp() - start);
    }

    private static IBroadPhase Create(BroadPhaseKind kind) =>
        kind == BroadPhaseKind.SortAndSweep ? new SortAndSweep() : new DynamicAabbTree();
}
