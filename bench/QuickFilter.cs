using BenchmarkDotNet.Filters;
using BenchmarkDotNet.Running;
using Gjk.Bench.Benchmarks;

namespace Gjk.Bench;

/// <summary>
/// Selects the benchmarks of <c>--quick</c>. These are the report's experiment with the library's distance (cold and
/// warm), and the baseline; and the depths of overlapping boxes and hulls.
/// </summary>
public sealed class QuickFilter : IFilter
{
    public bool Predicate(BenchmarkCase benchmarkCase) =>
        benchmarkCase.Descriptor.HasCategory(Categories.Depth)
            || (benchmarkCase.Descriptor.Type == typeof(ReportSceneFrames)
                && benchmarkCase.Descriptor.HasCategory(Categories.Distance));
}
