using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using Gjk.Bench.Baseline;
using Gjk.Bench.Benchmarks;
using Gjk.Bench.Scenes;
using Gjk.Core;

namespace Gjk.Bench;

/// <summary>
/// Compares the library with the baseline in one process. They run in turn, so that a busy or slow machine slows both.
/// The factor is that of the two fastest samples, because a disturbance can only add time.
/// </summary>
public static class FactorCheck
{
    /// <summary>
    /// How many times faster than the baseline the library must be on cubes of 24 vertices. This is a guard and not a
    /// goal. The goals and the reached factors are printed by --table. A busy machine changes the factor by a third, so
    /// the guard is well below it. An allocation, or a simplex copied in the loop, still fails the check.
    /// </summary>
    private const double MinFactorCubes = 1.8;

    /// <summary>
    /// How many times faster than the baseline the library must be on spheres of 515 vertices. The margin is as wide.
    /// Nearly all of the baseline's time is the linear search. Below this factor the library has fallen back to a
    /// linear search too.
    /// </summary>
    private const double MinFactorSpheres = 6;

    /// <summary>
    /// Units, on objects of size 1. The baseline stops while it can still gain up to its
    /// <see cref="ReportGjk.ProgressEpsilon"/> divided by the distance.
    /// </summary>
    private const float DistanceTolerance = 1e-3f;

    /// <summary>Both scenes have five pairs that overlap by construction.</summary>
    private const int OverlappingPairs = 5;

    /// <summary>
    /// Seconds per algorithm and scene. After this time the runtime has optimised both with the profile it collected.
    /// </summary>
    private const double WarmUpSeconds = 1.0;

    /// <summary>Seconds per scene for both algorithms.</summary>
    private const double MeasureSeconds = 3.0;

    /// <summary>
    /// Milliseconds per sample. This is long compared with the clock's resolution, and short compared with a time slice
    /// of the scheduler.
    /// </summary>
    private const double SampleMilliseconds = 1.0;

    /// <summary>Prints a line per scene. Returns false if a factor is below its minimum.</summary>
    /// <exception cref="FactorCheckException">The answers differ.</exception>
    public static bool Run(TextWriter output)
    {
        bool cubes = RunScene(output, ReportScenes.Cubes, MinFactorCubes);
        bool spheres = RunScene(output, ReportScenes.Spheres, MinFactorSpheres);
        return cubes && spheres;
    }

    /// <summary>Checks that all four queries give the same flags, and that the distances agree.</summary>
    /// <exception cref="FactorCheckException">The answers differ.</exception>
    public static void CheckAgreement(string name, BenchScene scene)
    {
        int overlapping = 0;
        foreach (BenchScene.Pair pair in scene.Pairs)
        {
            ref ConvexShape a = ref scene.Shapes[pair.A], b = ref scene.Shapes[pair.B];
            DistanceResult distance = ConvexQuery.Distance(a, scene.Poses[pair.A], b, scene.Poses[pair.B]);
            bool overlaps = ConvexQuery.Overlaps(a, scene.Poses[pair.A], b, scene.Poses[pair.B]);
            ReportResult expected = ReportGjk.Distance(scene.Colliders[pair.A], scene.Colliders[pair.B]);
            bool intersects = ReportGjk.Intersects(scene.Colliders[pair.A], scene.Colliders[pair.B]);

            bool known = distance.Status is GjkStatus.Separated or GjkStatus.Overlapping;
            bool sameFlags = distance.IsOverlapping == overlaps
                && overlaps == intersects
                && intersects == expected.Intersects;
            if (!known || !sameFlags || !(MathF.Abs(distance.Distance - expected.Distance) <= DistanceTolerance))
            {
                throw new FactorCheckException(string.Create(
                    CultureInfo.InvariantCulture,
                    $"{name}, pair {pair.A}-{pair.B}: library {distance.Status}, {distance.Distance}, "
                    + $"overlaps {overlaps}; baseline {expected.Intersects}, {expected.Distance}, "
                    + $"intersects {intersects}"));
            }

            if (overlaps) overlapping++;
        }

        if (overlapping != OverlappingPairs)
        {
            throw new FactorCheckException(FormattableString.Invariant(
                $"{name}: {overlapping} pairs overlap; the scene should have {OverlappingPairs}"));
        }
    }

    private static bool RunScene(TextWriter output, string name, double minFactor)
    {
        BenchScene scene = ReportScenes.Create(name);
        CheckAgreement(name, scene);

        Func<BenchScene, float> baseline = SceneQueries.BaselineDistance, library = SceneQueries.Distance;
        int baselineFrames = WarmUp(baseline, scene), libraryFrames = WarmUp(library, scene);
        var baselineSamples = new Samples();
        var librarySamples = new Samples();
        for (var clock = Stopwatch.StartNew(); clock.Elapsed.TotalSeconds < MeasureSeconds;)
        {
            baselineSamples.Add(NanosecondsPerFrame(baseline, scene, baselineFrames) / scene.Pairs.Length);
            librarySamples.Add(NanosecondsPerFrame(library, scene, libraryFrames) / scene.Pairs.Length);
        }

        double factor = baselineSamples.Minimum / librarySamples.Minimum;
        bool passed = factor >= minFactor;
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{name,-8} ns per pair: baseline {baselineSamples}, library {librarySamples}; "
            + $"factor {factor:0.00}, wanted {minFactor:0.0}: {(passed ? "passed" : "FAILED")}"));
        return passed;
    }

    /// <summary>Warms up, and returns how many frames fill a sample.</summary>
    private static int WarmUp(Func<BenchScene, float> frame, BenchScene scene)
    {
        for (var clock = Stopwatch.StartNew(); clock.Elapsed.TotalSeconds < WarmUpSeconds;)
            NanosecondsPerFrame(frame, scene, 1);
        double milliseconds = NanosecondsPerFrame(frame, scene, 10) * 1e-6;
        return Math.Max(1, (int)Math.Ceiling(SampleMilliseconds / milliseconds));
    }

    private static double NanosecondsPerFrame(Func<BenchScene, float> frame, BenchScene scene, int frames)
    {
        long start = Stopwatch.GetTimestamp();
        float sum = 0;
        for (int i = 0; i < frames; i++) sum += frame(scene);
        double elapsed = Stopwatch.GetElapsedTime(start).TotalNanoseconds;
        return float.IsNaN(sum) ? throw new FactorCheckException("A distance was NaN") : elapsed / frames;
    }
}
