using Gjk.Bench.Baseline;
using Gjk.Bench.Benchmarks;

namespace Gjk.Bench;

/// <summary>Guards the cost of the library by counts, which are the same on every machine, however busy: the answers
/// agree with the baseline's, the walks take no more supports than they should, nothing is allocated, and the casts of
/// the sets that --table times are right. Times are printed by --table.</summary>
public static class FactorCheck
{
    /// <summary>Count: supports of all 190 pairs of the report's scenes, cold: what the walks take, to the support. The
    /// bits of the answers are fixed, so this is, too; a walk that takes one more has changed.</summary>
    private const int MostCubes = 590, MostSpheres = 546;

    /// <summary>Count: supports of a warm query of a pair that has not moved.</summary>
    private const int MostResting = 1;

    /// <summary>Units, on objects of size 1. The baseline stops while it can still gain up to its
    /// <see cref="ReportGjk.ProgressEpsilon"/> divided by the distance.</summary>
    private const float DistanceTolerance = 1e-3f;

    /// <summary>Both scenes have five pairs that overlap by construction.</summary>
    private const int OverlappingPairs = 5;

    /// <summary>Prints a line per scene. Returns false if a count is above its limit.</summary>
    /// <exception cref="FactorCheckException">The answers differ.</exception>
    public static bool Run(TextWriter output)
    {
        bool cubes = RunScene(output, ReportScenes.Cubes, MostCubes);
        bool spheres = RunScene(output, ReportScenes.Spheres, MostSpheres);
        foreach (string name in CastPairs.Names) CastPairs.Create(name);
        output.WriteLine(FormattableString.Invariant($"casts: {CastPairs.Names.Count} sets are answered rightly"));
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

    private static bool RunScene(TextWriter output, string name, int mostSupports)
    {
        BenchScene scene = ReportScenes.Create(name);
        CheckAgreement(name, scene);
        var warmStarts = new WarmStart[scene.Pairs.Length];
        int cold = 0, resting = 0;
        for (int i = 0; i < scene.Pairs.Length; i++)
        {
            (int a, int b) = (scene.Pairs[i].A, scene.Pairs[i].B);
            ref ConvexShape shapeA = ref scene.Shapes[a], shapeB = ref scene.Shapes[b];
            cold += ConvexQuery.Distance(shapeA, scene.Poses[a], shapeB, scene.Poses[b], ref warmStarts[i]).Iterations;
            resting = Math.Max(
                resting,
                ConvexQuery.Distance(shapeA, scene.Poses[a], shapeB, scene.Poses[b], ref warmStarts[i]).Iterations);
        }

        long before = GC.GetAllocatedBytesForCurrentThread();
        SceneQueries.Distance(scene);
        SceneQueries.Overlaps(scene);
        long bytes = GC.GetAllocatedBytesForCurrentThread() - before;
        bool passed = cold <= mostSupports && resting <= MostResting && bytes == 0;
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{name,-8} {cold} supports for {scene.Pairs.Length} pairs, at most {mostSupports}; resting {resting}, "
            + $"at most {MostResting}; {bytes} bytes allocated: {(passed ? "passed" : "FAILED")}"));
        return passed;
    }
}
