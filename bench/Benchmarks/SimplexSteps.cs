using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Runtime.CompilerServices;
using BenchmarkDotNet.Attributes;
using BenchmarkDotNet.Configs;
using Gjk.Bench.Baseline;
using Gjk.Bench.Scenes;
using Gjk.Core;

namespace Gjk.Bench.Benchmarks;

/// <summary>
/// The step from one simplex to the next, without the support calls. The simplices are recorded from walks over random
/// hulls and grouped by their number of vertices. The figures are per step. A step changes its simplex, so each step
/// gets a copy. The copy has a benchmark of its own, whose time must be subtracted.
/// </summary>
[MemoryDiagnoser]
[GroupBenchmarksBy(BenchmarkLogicalGroupRule.ByCategory, BenchmarkLogicalGroupRule.ByParams)]
[BenchmarkCategory(Categories.Simplex)]
public class SimplexSteps
{
    /// <summary>
    /// The number of recorded steps. It is too large for a branch predictor to learn, and small enough for a
    /// second-level cache.
    /// </summary>
    private const int StepCount = 1024;

    private const string Set = "hull32";

    private RecordedStep[] _distance = [];
    private RecordedStep[] _overlap = [];
    private MinkowskiPoint[][] _report = [];

    [Params(2, 3, 4)]
    public int Vertices { get; set; }

    [GlobalSetup]
    public void Setup()
    {
        BenchScene scene = RandomPairs.Create(Set);
        _distance = Repeated(RecordedStep.OfDistance(scene).Where(s => s.Simplex.Count == Vertices));
        _overlap = Repeated(RecordedStep.OfOverlap(scene).Where(s => s.Simplex.Count == Vertices));
        _report = [.. _overlap.Select(s => s.ForReport())];
    }

    /// <summary>The report's step. It fills a list with the simplex and uses the same cases.</summary>
    [Benchmark(Baseline = true, OperationsPerInvoke = StepCount)]
    public float ReportStep()
    {
        float sum = 0;
        foreach (MinkowskiPoint[] points in _report)
        {
            var simplex = new List<MinkowskiPoint>(points);
            Vector3 direction = default;
            if (!Baseline.NextSimplex.Update(simplex, ref direction)) sum += direction.X;
        }

        return sum;
    }

    /// <summary>The step of the distance query. It finds the nearest feature and its normal.</summary>
    [Benchmark(OperationsPerInvoke = StepCount)]
    public double Reduce()
    {
        double sum = 0;
        foreach (ref readonly RecordedStep step in _distance.AsSpan())
        {
            Simplex simplex = step.Simplex;
            ClosestFeature feature = step.Feature;
            if (ClosestFeatureStep.Reduce(ref simplex, ref feature)) sum += feature.Height;
        }

        return sum;
    }

    /// <summary>The step of a warm start. It does the same for a simplex of which nothing is known.</summary>
    [Benchmark(OperationsPerInvoke = StepCount)]
    public double ReduceAny()
    {
        double sum = 0;
        foreach (ref readonly RecordedStep step in _distance.AsSpan())
        {
            Simplex simplex = step.Simplex;
            ClosestFeature feature = step.Feature;
            if (ClosestFeatureStep.ReduceAny(ref simplex, ref feature)) sum += feature.Height;
        }

        return sum;
    }

    /// <summary>Muratori's step, which the boolean query uses.</summary>
    [Benchmark(OperationsPerInvoke = StepCount)]
    public double Advance()
    {
        double sum = 0;
        foreach (ref readonly RecordedStep step in _overlap.AsSpan())
        {
            Simplex simplex = step.Simplex;
            Vector3D normal = step.Feature.Normal;
            if (!Core.NextSimplex.Advance(ref simplex, ref normal)) sum += normal.X;
        }

        return sum;
    }

    /// <summary>The time that <see cref="Reduce"/> spends on copies. The solver does not make these copies.</summary>
    [Benchmark(OperationsPerInvoke = StepCount)]
    public double Copy()
    {
        double sum = 0;
        foreach (ref readonly RecordedStep step in _distance.AsSpan())
        {
            Simplex simplex = step.Simplex;
            ClosestFeature feature = step.Feature;
            sum += Touch(ref simplex, ref feature);
        }

        return sum;
    }

    /// <summary>Not inlined, so that the copies are really made.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static double Touch(ref Simplex simplex, ref ClosestFeature feature) => feature.Height + simplex.Count;

    private static RecordedStep[] Repeated(IEnumerable<RecordedStep> steps)
    {
        RecordedStep[] found = [.. steps.Take(StepCount)];
        if (found.Length == 0) throw new InvalidOperationException($"Set {Set} has no step of this kind.");
        return [.. Enumerable.Range(0, StepCount).Select(i => found[i % found.Length])];
    }
}
