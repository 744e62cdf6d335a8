using BenchmarkDotNet.Attributes;
using BenchmarkDotNet.Configs;

namespace Gjk.Bench.Benchmarks;

/// <summary>Primitives through the generic path, without warm starts. The figures are per pair. The baseline has a mesh
/// of the same shape.</summary>
[MemoryDiagnoser]
[GroupBenchmarksBy(BenchmarkLogicalGroupRule.ByCategory)]
public class Primitives
{
    private PrimitivePairs _pairs = null!;

    [GlobalSetup]
    public void Setup() => _pairs = new PrimitivePairs();

    [Benchmark(Baseline = true, OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.SphereSphere)]
    public float BaselineSphereMesh() => _pairs.Spheres.BaselineDistance();

    [Benchmark(OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.SphereSphere)]
    public float SphereSphere() => _pairs.Spheres.Distance();

    [Benchmark(Baseline = true, OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.CapsuleCapsule)]
    public float BaselineCapsuleMesh() => _pairs.Capsules.BaselineDistance();

    [Benchmark(OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.CapsuleCapsule)]
    public float CapsuleCapsule() => _pairs.Capsules.Distance();

    [Benchmark(Baseline = true, OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.Cubes)]
    public float BaselineCubeMesh() => _pairs.Cubes.BaselineDistance();

    [Benchmark(OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.Cubes)]
    public float CubeCube() => _pairs.Cubes.Distance();

    [Benchmark(Baseline = true, OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.Boxes)]
    public float BaselineBoxMesh() => _pairs.Boxes.BaselineDistance();

    [Benchmark(OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.Boxes)]
    public float BoxBox() => _pairs.Boxes.Distance();
}
