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
        _distance = Repeated(RecordedStep.Of(scene, nearest: true).Where(s => s.Count == Vertices));
        _overlap = Repeated(RecordedStep.Of(scene, nearest: false).Where(s => s.Count == Vertices));
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
    public double Nearest()
    {
        double sum = 0;
        foreach (ref readonly RecordedStep step in _distance.AsSpan())
        {
            FeatureVertices vertices = step.Vertices;
            ClosestFeature feature = default;
            if (Core.NextSimplex.TryAdvance(ref vertices, step.Newest, ref feature, nearest: true))
                sum += feature.Height;
        }

        return sum;
    }

    /// <summary>The step of the boolean query, which takes the first face that the origin sees.</summary>
    [Benchmark(OperationsPerInvoke = StepCount)]
    public double First()
    {
        double sum = 0;
        foreach (ref readonly RecordedStep step in _overlap.AsSpan())
        {
            FeatureVertices vertices = step.Vertices;
            ClosestFeature feature = default;
            if (Core.NextSimplex.TryAdvance(ref vertices, step.Newest, ref feature, nearest: false))
                sum += feature.Normal.X;
        }

        return sum;
    }

    /// <summary>The time that the others spend on copies. The solver does not make these copies.</summary>
    [Benchmark(OperationsPerInvoke = StepCount)]
    public double Copy()
    {
        double sum = 0;
        foreach (ref readonly RecordedStep step in _distance.AsSpan())
        {
            FeatureVertices vertices = step.Vertices;
            sum += Touch(ref vertices);
        }

        return sum;
    }

    /// <summary>Not inlined, so that the copies are really made.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static double Touch(ref FeatureVertices vertices) => vertices.Winding + vertices.Count;

    private static RecordedStep[] Repeated(IEnumerable<RecordedStep> steps)
    {
        RecordedStep[] found = [.. steps.Take(StepCount)];
        if (found.Length == 0) throw new InvalidOperationException($"Set {Set} has no step of this kind.");
        return [.. Enumerable.Range(0, StepCount).Select(i => found[i % found.Length])];
    }
}
