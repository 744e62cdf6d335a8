namespace Gjk.Core.Tests.Support;

/// <summary>How many bytes a piece of work allocates on the thread that does it.</summary>
internal static class Allocation
{
    private const int Attempts = 3;

    /// <summary>The fewest bytes of several runs. The first run compiles and warms up, and the runtime allocates on its
    /// own now and then. What the work itself allocates, it allocates every time.</summary>
    public static long Least(Action work)
    {
        work();
        long least = long.MaxValue;
        for (int attempt = 0; attempt < Attempts; attempt++) least = Math.Min(least, Of(work));
        return least;
    }

    /// <summary>The bytes of one run, for work that cannot be repeated.</summary>
    public static long Of(Action work)
    {
        long before = GC.GetAllocatedBytesForCurrentThread();
        work();
        return GC.GetAllocatedBytesForCurrentThread() - before;
    }
}
