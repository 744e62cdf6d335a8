using BenchmarkDotNet.Attributes;
using BenchmarkDotNet.Configs;

namespace Gjk.Bench.Benchmarks;

/// <summary>How deep a thousand overlapping pairs are, boxes and hulls. The figures are per pair. There is no baseline,
/// because the report's algorithm answers no depths.</summary>
[MemoryDiagnoser]
[GroupBenchmarksBy(BenchmarkLogicalGroupRule.ByParams)]
[BenchmarkCategory(Categories.Depth)]
public class DepthQueries
{
    private BenchScene _scene = new();
    private Sliding _sliding = null!;
    private WarmStart[] _warmStarts = [];

    public static IEnumerable<string> SetNames => DepthPairs.EvenNames;

    [ParamsSource(nameof(SetNames))]
    public string Set { get; set; } = DepthPairs.EvenNames[0];

    [GlobalSetup]
    public void Setup()
    {
        _scene = DepthPairs.Create(Set);
        _sliding = new Sliding(_scene);
        _warmStarts = new WarmStart[_scene.Pairs.Length];
    }

    [Benchmark(OperationsPerInvoke = DepthPairs.Count)]
    public float ColdDepth() => SceneQueries.Depth(_scene);

    /// <summary>One object of every pair moves by a hundredth of its size between the calls.</summary>
    [Benchmark(OperationsPerInvoke = DepthPairs.Count)]
    public float MovingDepth() => SceneQueries.WarmDepth(_scene, _sliding.Next(), _warmStarts);
}
