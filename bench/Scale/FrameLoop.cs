namespace Gjk.Bench.Scale;

/// <summary>Repeats frames.</summary>
internal static class FrameLoop
{
    /// <summary>Seconds. Nothing should be allocated after the first second. By then the runtime has also
    /// optimised the code with the profile it collected.</summary>
    private const double WarmUpSeconds = 1;

    /// <summary>Frames. The least number to run if a frame is so slow that the seconds do not allow more.</summary>
    private const int LeastFrames = 5;

    public static void WarmUp(Action frame) => Repeat(WarmUpSeconds, frame);

    /// <summary>Repeats a frame and returns how often it ran.</summary>
    public static int Repeat(double seconds, Action frame)
    {
        int runs = 0;
        for (var clock = Stopwatch.StartNew(); runs < LeastFrames || clock.Elapsed.TotalSeconds < seconds; runs++)
            frame();
        return runs;
    }

    /// <summary>The bytes that frames allocate, on all threads together. These are not the timed frames, because an
    /// exact count stops all threads.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="timed">How many frames were timed. A tenth of that number is run again.</param>
    public static double BytesPerFrame(Action frame, int timed)
    {
        int count = Math.Max(timed / 10, LeastFrames);
        long before = GC.GetTotalAllocatedBytes(precise: true);
        for (int i = 0; i < count; i++) frame();
        return (double)(GC.GetTotalAllocatedBytes(precise: true) - before) / count;
    }

    /// <summary>Converts ticks in double. A TimeSpan counts in steps of 100 ns, which is a large part of the smallest
    /// frames.</summary>
    public static double Milliseconds(long ticks) => ticks * 1e3 / Stopwatch.Frequency;
}
