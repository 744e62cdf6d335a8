using System;
using System.Diagnostics;
using System.Reflection;
using Gjk.Targets;

namespace Gjk.Unity.Checks;

/// <summary>Runs the package's tests and counts what the components allocate per frame, on the runtime that started
/// this. With "frames" it runs the frames alone.</summary>
internal static class Program
{
    private const int WarmUpFrames = 200, Frames = 200;

    private static int Main(string[] args)
    {
        int passed = 0, failed = 0;
        if (args.Length == 0)
        {
            foreach (MethodInfo test in PackageTestRunner.TestsOf(typeof(Tests.AdapterTests).Assembly))
                Count(PackageTestRunner.NameOf(test), () => PackageTestRunner.Run(test), ref passed, ref failed);
        }

        Count("frames allocate nothing", CheckFrames, ref passed, ref failed);
        Console.WriteLine($"{passed} passed, {failed} failed");
        return failed == 0 ? 0 : 1;
    }

    private static void Count(string name, Action test, ref int passed, ref int failed)
    {
        try
        {
            test();
            passed++;
        }
        catch (Exception exception)
        {
            failed++;
            Console.WriteLine($"{name}: {exception}");
        }
    }

    private static void CheckFrames()
    {
        using var load = new FrameLoad();
        for (int i = 0; i < WarmUpFrames; i++) load.Frame();
        if (load.Near.Least == load.Near.Most) throw new InvalidOperationException("Nothing came near or left.");
        if (load.Distance.Problem is { } problem) throw new InvalidOperationException(problem);

        // Mono ends a collection that the tests before have begun whenever it likes.
        GC.Collect();
        int collections = GC.CollectionCount(0);
        var clock = Stopwatch.StartNew();
        long before = AllocatedBytes.Now();
        for (int i = 0; i < Frames; i++) load.Frame();
        long bytes = AllocatedBytes.Now() - before;
        double microseconds = clock.Elapsed.TotalMilliseconds * 1000 / Frames;
        Console.WriteLine(FormattableString.Invariant(
            $"{bytes} bytes in {Frames} frames, {microseconds:F0} us a frame, {load.Sensor.WatchedCount} colliders"));
        if (bytes != 0 || GC.CollectionCount(0) != collections)
            throw new InvalidOperationException($"{bytes} bytes were allocated.");
    }
}
