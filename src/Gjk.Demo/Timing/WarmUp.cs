using System.Diagnostics;

namespace Gjk.Demo.Timing;

/// <summary>Repeats a pass until it no longer gets faster. The runtime compiles in tiers, in the background, some time
/// after a method was first called. So neither a number of passes nor a time span alone is enough.</summary>
internal static class WarmUp
{
    /// <summary>By which share a pass must beat the best one to count as faster. A smaller gain is noise.</summary>
    private const double Improvement = 0.02;

    private const int LeastPasses = 3;

    /// <summary>Enough time for all tiers of one scene.</summary>
    public static TimeSpan Usual => TimeSpan.FromSeconds(8 * QuietSeconds);

    /// <summary>The limit when few frames are asked for. It is enough for the first tiers, and on an idle machine for
    /// all.</summary>
    public static TimeSpan Short => TimeSpan.FromSeconds(3 * QuietSeconds);

    /// <summary>For how many seconds no pass may improve. The value is three times the tenth of a second that the
    /// runtime waits before it compiles again. With a single processor the runtime waits ten times longer.</summary>
    private static double QuietSeconds => Environment.ProcessorCount == 1 ? 3 : 0.3;

    /// <summary>Runs the pass until it is stable or the limit is reached. It runs at least three times.</summary>
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
