using System;
using System.Diagnostics;
using System.Threading;

namespace Gjk.Demo.Timing;

/// <summary>
/// Repeats a pass until it no longer gets faster. The runtime compiles in tiers, in the background, after calls have stopped being new for a
/// while; so neither a number of passes nor a span of time alone is enough.
/// </summary>
internal static class WarmUp
{
    /// <summary>By how much a pass must beat the best one to count as faster; less is noise.</summary>
    private const double Improvement = 0.02;

    private const int LeastPasses = 3;

    /// <summary>Enough for the tiers of one scene.</summary>
    public static TimeSpan Usual => TimeSpan.FromSeconds(8 * QuietSeconds);

    /// <summary>Where few frames are asked for: enough for the first tiers, on a machine that is not busy for all.</summary>
    public static TimeSpan Short => TimeSpan.FromSeconds(3 * QuietSeconds);

    /// <summary>
    /// For how long, in seconds, nothing may improve: three times the tenth of a second that the runtime waits before it compiles again. With a
    /// single processor it waits ten times longer.
    /// </summary>
    private static double QuietSeconds => Environment.ProcessorCount == 1 ? 3 : 0.3;

    /// <summary>Runs the pass until it is stable, or the limit is reached; at least three times, so that it has run at all.</summary>
    public static void Run(Action pass, TimeSpan limit, CancellationToken cancel)
    {
        long start = Stopwatch.GetTimestamp(), lastImprovement = start;
        double best = double.PositiveInfinity;
        for (int passes = 0; ; passes++)
        {
            cancel.ThrowIfCancellationRequested();
            long before = Stopwatch.GetTimestamp();
            if (passes >= LeastPasses)
            {
                if (Stopwatch.GetElapsedTime(start, before) > limit) return;
                if (Stopwatch.GetElapsedTime(lastImprovement, before).TotalSeconds > QuietSeconds) return;
            }

            pass();
            double took = Stopwatch.GetElapsedTime(before).TotalSeconds;
            if (took >= best * (1 - Improvement)) continue;
            best = took;
            lastImprovement = Stopwatch.GetTimestamp();
        }
    }
}
