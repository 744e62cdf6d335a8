using Gjk.Bench.Scenes;
using Gjk.Core;

namespace Gjk.Bench.Worst;

/// <summary>Measures the worst clouds: building their hulls, supports and distances.</summary>
internal static class WorstRun
{
    /// <summary>The numbers of points of a cloud. The goals are for the last one.</summary>
    public static readonly int[] Sizes = [10_000, 100_000];

    /// <summary>How often a small hull is built. The fastest time counts. Large hulls are built once.</summary>
    private const int SmallBuilds = 3;

    /// <summary>Points of the clouds that are used first, while the runtime optimises the code.</summary>
    private const int WarmUpPoints = 1_000;

    /// <param name="progress">Receives a line per family.</param>
    public static List<WorstRow> Run(TextWriter progress)
    {
        progress.WriteLine("warming up");
        foreach (string family in WorstClouds.Names) Measure(family, WarmUpPoints, 1);
        var rows = new List<WorstRow>();
        foreach (string family in WorstClouds.Names)
        {
            progress.WriteLine(family);
            rows.AddRange(Sizes.Select(points => Measure(family, points, points == Sizes[0] ? SmallBuilds : 1)));
        }

        return rows;
    }

    private static WorstRow Measure(string family, int points, int builds)
    {
        Vector3[] cloud = WorstClouds.Create(family, points);
        ConvexHull hull = Fastest(builds, () => new ConvexHull(cloud), out double buildMs);
        DistinctPoints distinct = Fastest(builds, () => new DistinctPoints(cloud), out double distinctMs);
        Fastest(builds, () => ConvexHullBuilder.Build(distinct.Points), out double surfaceMs);
        return new WorstRow(
            family,
            cloud.Length,
            distinct.Points.Length,
            hull.VertexCount,
            buildMs,
            distinctMs + surfaceMs,
            SupportClock.AlongRandom(hull),
            SupportClock.AlongNormals(hull),
            SupportClock.NearNormals(hull),
            QueryClock.Slowest(hull));
    }

    private static T Fastest<T>(int times, Func<T> build, out double milliseconds)
    {
        milliseconds = double.PositiveInfinity;
        T result = default!;
        for (int i = 0; i < times; i++)
        {
            GC.Collect();
            long start = Stopwatch.GetTimestamp();
            result = build();
            milliseconds = Math.Min(milliseconds, Stopwatch.GetElapsedTime(start).TotalMilliseconds);
        }

        return result;
    }
}
