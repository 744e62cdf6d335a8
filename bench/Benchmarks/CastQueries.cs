using BenchmarkDotNet.Attributes;
using BenchmarkDotNet.Configs;

namespace Gjk.Bench.Benchmarks;

/// <summary>When the objects of a thousand pairs first touch, one of which moves. The figures are per pair. There is no
/// baseline, because the report's algorithm answers no casts.</summary>
[MemoryDiagnoser]
[GroupBenchmarksBy(BenchmarkLogicalGroupRule.ByParams)]
[BenchmarkCategory(Categories.Cast)]
public class CastQueries
{
    private CastScene _scene = new(isRays: false);

    public static IEnumerable<string> SetNames => CastPairs.Names;

    [ParamsSource(nameof(SetNames))]
    public string Set { get; set; } = CastPairs.Names[0];

    [GlobalSetup]
    public void Setup() => _scene = CastPairs.Create(Set);

    [Benchmark(OperationsPerInvoke = CastPairs.Count)]
    public float ColdCast() => _scene.SumOfFractions();
}
