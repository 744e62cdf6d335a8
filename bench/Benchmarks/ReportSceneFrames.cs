using BenchmarkDotNet.Attributes;
using BenchmarkDotNet.Configs;

namespace Gjk.Bench.Benchmarks;

/// <summary>The report's experiment. A frame makes 190 calls on each of its scenes. The figures are per
/// frame.</summary>
[MemoryDiagnoser]
[GroupBenchmarksBy(BenchmarkLogicalGroupRule.ByCategory, BenchmarkLogicalGroupRule.ByParams)]
public class ReportSceneFrames
{
    private BenchScene _scene = new();
    private WarmStart[] _warmStarts = [];

    public static IEnumerable<string> SceneNames => ReportScenes.Names;

    [ParamsSource(nameof(SceneNames))]
    public string Scene { get; set; } = ReportScenes.Cubes;

    [GlobalSetup]
    public void Setup()
    {
        _scene = ReportScenes.Create(Scene);
        _warmStarts = new WarmStart[_scene.Pairs.Length];
    }

    [Benchmark(Baseline = true), BenchmarkCategory(Categories.Distance)]
    public float BaselineDistance() => SceneQueries.BaselineDistance(_scene);

    [Benchmark, BenchmarkCategory(Categories.Distance)]
    public float ColdDistance() => SceneQueries.Distance(_scene);

    /// <summary>Nothing moves between the frames, as in the report.</summary>
    [Benchmark, BenchmarkCategory(Categories.Distance)]
    public float WarmDistance() => SceneQueries.WarmDistance(_scene, _scene.Poses, _warmStarts);

    [Benchmark(Baseline = true), BenchmarkCategory(Categories.Overlap)]
    public int BaselineOverlap() => SceneQueries.BaselineOverlaps(_scene);

    [Benchmark, BenchmarkCategory(Categories.Overlap)]
    public int Overlap() => SceneQueries.Overlaps(_scene);
}
