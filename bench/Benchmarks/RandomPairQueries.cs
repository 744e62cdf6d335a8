using BenchmarkDotNet.Attributes;
using BenchmarkDotNet.Configs;

namespace Gjk.Bench.Benchmarks;

/// <summary>A thousand random pairs per set. The figures are per pair.</summary>
[MemoryDiagnoser]
[GroupBenchmarksBy(BenchmarkLogicalGroupRule.ByCategory, BenchmarkLogicalGroupRule.ByParams)]
public class RandomPairQueries
{
    private BenchScene _scene = new();
    private Motion _motion = null!;
    private WarmStart[] _warmStarts = [];

    public static IEnumerable<string> SetNames => RandomPairs.Names;

    [ParamsSource(nameof(SetNames))]
    public string Set { get; set; } = RandomPairs.Names[0];

    [GlobalSetup]
    public void Setup()
    {
        _scene = RandomPairs.Create(Set);
        _motion = new Motion(_scene);
        _warmStarts = new WarmStart[_scene.Pairs.Length];
    }

    [Benchmark(Baseline = true, OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.Distance)]
    public float BaselineDistance() => SceneQueries.BaselineDistance(_scene);

    [Benchmark(OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.Distance)]
    public float ColdDistance() => SceneQueries.Distance(_scene);

    /// <summary>Nothing moves between the calls.</summary>
    [Benchmark(OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.Distance)]
    public float WarmDistance() => SceneQueries.WarmDistance(_scene, _scene.Poses, _warmStarts);

    /// <summary>Every object turns by one degree and moves by a hundredth of its size between the calls.</summary>
    [Benchmark(OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.Distance)]
    public float MovingDistance() => SceneQueries.WarmDistance(_scene, _motion.Next(), _warmStarts);

    [Benchmark(Baseline = true, OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.Overlap)]
    public int BaselineOverlap() => SceneQueries.BaselineOverlaps(_scene);

    [Benchmark(OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.Overlap)]
    public int Overlap() => SceneQueries.Overlaps(_scene);
}
