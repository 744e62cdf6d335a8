namespace Gjk.Bench.Table;

/// <summary>Runs loops in turn, with the library's loops between those of the baseline. A temporary slowdown of the
/// machine then slows all of them.</summary>
internal static class TurnTaking
{
    /// <summary>The share by which a loop must become faster to count as still warming up. A smaller gain is
    /// noise.</summary>
    private const double Improvement = 0.02;

    /// <summary>For how many seconds nothing may improve before the loops count as warm. The value is three times the
    /// tenth of a second that the runtime waits before it compiles the next tier. With a single processor the runtime
    /// waits ten times longer.</summary>
    private static double QuietSeconds => Environment.ProcessorCount == 1 ? 3 : 0.3;

    /// <summary>Runs the loops for a time span or until they are stable, with at least one turn each. The measurements
    /// are forgotten.</summary>
    public static void WarmUp(IReadOnlyCollection<ITurn> loops, double mostSeconds)
    {
        var clock = Stopwatch.StartNew();
        double lastImprovement = 0;
        do
        {
            foreach (ITurn loop in loops)
                if (loop.Turn(Improvement)) lastImprovement = clock.Elapsed.TotalSeconds;
        }
        while (clock.Elapsed.TotalSeconds < Math.Min(mostSeconds, lastImprovement + QuietSeconds));

        foreach (ITurn loop in loops) loop.Reset();
    }

    /// <summary>Measures for a time span, with at least two turns for each loop.</summary>
    public static void Measure(IReadOnlyCollection<ITurn> loops, double seconds)
    {
        var clock = Stopwatch.StartNew();
        for (int turn = 0; turn < 2 || clock.Elapsed.TotalSeconds < seconds; turn++)
            foreach (ITurn loop in loops) loop.Turn(Improvement);
    }
}
