using BenchmarkDotNet.Attributes;
using BenchmarkDotNet.Configs;
using Gjk.Bench.Baseline;

namespace Gjk.Bench.Benchmarks;

/// <summary>The furthest vertex in a random direction, found in three ways: by the library's look-up, by the plain scan
/// that defines it, and by the report's FindFurthestPoint. The last one also has to turn the direction. The figures are
/// per call.</summary>
[MemoryDiagnoser]
[GroupBenchmarksBy(BenchmarkLogicalGroupRule.ByCategory, BenchmarkLogicalGroupRule.ByParams)]
[BenchmarkCategory(Categories.Support)]
public class SupportAlone
{
    private const int DirectionCount = 1024;
    private const ulong Seed = 31;

    private readonly Vector3[] _directions = new Vector3[DirectionCount];
    private readonly Double3[] _wideDirections = new Double3[DirectionCount];
    private ConvexHull _hull = null!;
    private SupportCollider _collider = null!;

    [Params(8, 32, 128, 512, 2048, 8192, 32768, 100_000)]
    public int Vertices { get; set; }

    [GlobalSetup]
    public void Setup()
    {
        var prng = new Prng(Seed);
        Vector3[] vertices = MeshVertices.OnEllipsoid(prng, Vertices, new Vector3(0.5f));
        _hull = new ConvexHull(vertices);
        _collider = new MeshSupportCollider(vertices, prng.Rotation(), Vector3.Zero);
        for (int i = 0; i < DirectionCount; i++)
        {
            _directions[i] = prng.UnitVector();
            _wideDirections[i] = _directions[i];
        }
    }

    [Benchmark(Baseline = true, OperationsPerInvoke = DirectionCount)]
    public float ReportFindFurthestPoint()
    {
        float sum = 0;
        foreach (Vector3 direction in _directions) sum += _collider.FindFurthestPoint(direction).X;
        return sum;
    }

    [Benchmark(OperationsPerInvoke = DirectionCount)]
    public int PlainScan()
    {
        int sum = 0;
        foreach (ref readonly Double3 direction in _wideDirections.AsSpan())
            sum += Gjk.Core.Tests.Support.PlainScan.Furthest(_hull.Cells, direction);
        return sum;
    }

    [Benchmark(OperationsPerInvoke = DirectionCount)]
    public double Find()
    {
        double sum = 0;
        foreach (ref readonly Double3 direction in _wideDirections.AsSpan())
        {
            sum += HullSupport.Find(_hull.Cells, direction, out Double3 point) + point.X;
        }

        return sum;
    }
}
