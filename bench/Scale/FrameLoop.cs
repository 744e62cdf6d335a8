using System;
using System.Diagnostics;

namespace Gjk.Bench.Scale;

/// <summary>Repeats frames.</summary>
internal static class FrameLoop
{
    /// <summary>Seconds: the goal is that nothing is allocated after the first one. By then the runtime has optimised the code with what it saw, too.</summary>
    private const double WarmUpSeconds = 1;

    /// <summary>Frames, where one takes longer than the seconds allow.</summary>
    private const int LeastFrames = 5;

    public static void WarmUp(Action frame) => Repeat(WarmUpSeconds, frame);

    /// <summary>How often it ran.</summary>
    public static int Repeat(double seconds, Action frame)
    {
        int runs = 0;
        for (var clock = Stopwatch.StartNew(); runs < LeastFrames || clock.Elapsed.TotalSeconds < seconds; runs++) frame();
        return runs;
    }

    /// <summary>What frames allocate, on all threads together; apart from the timed ones, as an exact count stops all threads.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="timed">How many were timed; a tenth of them is run again.</param>
    public static double BytesPerFrame(Action frame, int timed)
    {
        int count = Math.Max(timed / 10, LeastFrames);
        long before = GC.GetTotalAllocatedBytes(precise: true);
        for (int i = 0; i < count; i++) frame();
        return (double)(GC.GetTotalAllocatedBytes(precise: true) - before) / count;
    }

    /// <summary>In double: a TimeSpan counts in steps of 100 ns, a good part of the smallest frames.</summary>
    public static double Milliseconds(long ticks) => ticks * 1e3 / Stopwatch.Frequency;
}
