using System.Numerics;
using BenchmarkDotNet.Attributes;
using BenchmarkDotNet.Configs;
using Gjk.Bench.Scenes;
using Gjk.Core;

namespace Gjk.Bench.Benchmarks;

/// <summary>Primitives through the generic path, cold. The figures are per pair; the baseline has a mesh of the same shape.</summary>
[MemoryDiagnoser]
[GroupBenchmarksBy(BenchmarkLogicalGroupRule.ByCategory)]
public class Primitives
{
    private TypedPairs<SphereShape> _spheres = null!;
    private TypedPairs<CapsuleShape> _capsules = null!;
    private TypedPairs<BoxShape> _cubes = null!;
    private TypedPairs<BoxShape> _boxes = null!;

    [GlobalSetup]
    public void Setup()
    {
        Vector3[] sphere = MeshVertices.Sphere(0.3f), capsule = MeshVertices.Capsule(0.2f, 0.3f), cube = MeshVertices.Cube(0.35f);
        _spheres = new(21, _ => (new SphereShape(0.3f), sphere));
        _capsules = new(22, _ => (new CapsuleShape(0.2f, 0.3f), capsule));
        _cubes = new(23, _ => (new BoxShape(new Vector3(0.35f)), cube));
        _boxes = new(24, prng =>
        {
            var half = new Vector3(prng.Range(0.15f, 0.5f), prng.Range(0.15f, 0.5f), prng.Range(0.15f, 0.5f));
            return (new BoxShape(half), MeshVertices.Box(half));
        });
    }

    [Benchmark(Baseline = true, OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.SphereSphere)]
    public float BaselineSphereMesh() => _spheres.BaselineDistance();

    [Benchmark(OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.SphereSphere)]
    public float SphereSphere() => _spheres.Distance();

    [Benchmark(Baseline = true, OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.CapsuleCapsule)]
    public float BaselineCapsuleMesh() => _capsules.BaselineDistance();

    [Benchmark(OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.CapsuleCapsule)]
    public float CapsuleCapsule() => _capsules.Distance();

    [Benchmark(Baseline = true, OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.Cubes)]
    public float BaselineCubeMesh() => _cubes.BaselineDistance();

    [Benchmark(OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.Cubes)]
    public float CubeCube() => _cubes.Distance();

    [Benchmark(Baseline = true, OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.Boxes)]
    public float BaselineBoxMesh() => _boxes.BaselineDistance();

    [Benchmark(OperationsPerInvoke = RandomPairs.Count), BenchmarkCategory(Categories.Boxes)]
    public float BoxBox() => _boxes.Distance();
}
