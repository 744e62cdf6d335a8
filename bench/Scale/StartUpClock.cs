namespace Gjk.Bench.Scale;

/// <summary>Measures the first frames of a program: moving cubes, all pairs within a distance. The runtime compiles a
/// method when it is first called and again when it was called often, so the first frames take longer than the later
/// ones. This is measured before anything else in the process has called the library.</summary>
internal static class StartUpClock
{
    private const int Objects = 500, Frames = 1000;

    /// <summary>The length of the cubes' edges is 1.</summary>
    private const float Distance = 0.5f;

    /// <summary>Frames: each figure but the first call is the median of so many.</summary>
    private const int Around = 9;

    private static readonly int[] Shown = [10, 30, 100, 300, Frames - Around];

    /// <summary>Measures and returns the row as text.</summary>
    public static string Measure()
    {
        var objects = new WorldScenes(Objects);
        CollisionScene scene = objects.CreateScene(BroadPhaseKind.DynamicTree);
        var pairs = new List<PairDistance>();
        double[] times = new double[Frames];
        for (int i = 0; i < Frames; i++)
        {
            objects.Advance();
            long start = Stopwatch.GetTimestamp();
            objects.MoveAll(scene);
            scene.FindPairsWithin(Distance, pairs);
            times[i] = FrameLoop.Milliseconds(Stopwatch.GetTimestamp() - start);
        }

        IEnumerable<string> figures = Shown.Select(
            i => string.Create(CultureInfo.InvariantCulture, $"frame {i} {Median(times, i):0.00} ms"));
        return string.Create(
            CultureInfo.InvariantCulture,
            $"Start-up, {Objects} moving cubes, {pairs.Count} pairs within {Distance}: first call {times[0]:0.0} ms, "
            + $"{string.Join(", ", figures)}.\n");
    }

    private static double Median(double[] times, int frame)
    {
        var samples = new Samples();
        foreach (double time in times.AsSpan(frame - Around / 2, Around)) samples.Add(time);
        return samples.Median;
    }
}
