using System;
using System.Collections.Generic;
using System.Diagnostics;

namespace Gjk.Bench.Table;

/// <summary>Runs loops in turn, the library's between the baseline's, so that whatever slows the machine down for a while slows all of them.</summary>
internal static class TurnTaking
{
    /// <summary>By how much, as a share, a loop must become faster to count as still warming up; less is noise.</summary>
    private const double Improvement = 0.02;

    /// <summary>
    /// For how many seconds nothing may improve before the loops count as warm: three times the tenth of a second that the runtime waits before it compiles
    /// the next tier. With a single processor it waits ten times longer.
    /// </summary>
    private static double QuietSeconds => Environment.ProcessorCount == 1 ? 3 : 0.3;

    /// <summary>Runs the loops for a span of time, at least a turn each, or until they are stable, and forgets what was measured.</summary>
    public static void WarmUp(IReadOnlyCollection<TimedLoop> loops, double mostSeconds)
    {
        var clock = Stopwatch.StartNew();
        double lastImprovement = 0;
        do
        {
            foreach (TimedLoop loop in loops)
                if (loop.Turn(Improvement)) lastImprovement = clock.Elapsed.TotalSeconds;
        }
        while (clock.Elapsed.TotalSeconds < Math.Min(mostSeconds, lastImprovement + QuietSeconds));

        foreach (TimedLoop loop in loops) loop.Reset();
    }

    /// <summary>Measures for a span of time, at least two turns each.</summary>
    public static void Measure(IReadOnlyCollection<TimedLoop> loops, double seconds)
    {
        var clock = Stopwatch.StartNew();
        for (int turn = 0; turn < 2 || clock.Elapsed.TotalSeconds < seconds; turn++)
            foreach (TimedLoop loop in loops) loop.Turn(Improvement);
    }
}
