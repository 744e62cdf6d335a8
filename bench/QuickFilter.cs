using BenchmarkDotNet.Filters;
using BenchmarkDotNet.Running;
using Gjk.Bench.Benchmarks;

namespace Gjk.Bench;

/// <summary>What <c>--quick</c> leaves: the report's experiment, distance by the library (cold, warm) and the baseline.</summary>
public sealed class QuickFilter : IFilter
{
    public bool Predicate(BenchmarkCase benchmarkCase) =>
        benchmarkCase.Descriptor.Type == typeof(ReportSceneFrames) && benchmarkCase.Descriptor.HasCategory(Categories.Distance);
}
