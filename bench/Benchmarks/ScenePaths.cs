using BenchmarkDotNet.Attributes;

namespace Gjk.Bench.Benchmarks;

/// <summary>Rays and moving boxes through a whole scene at rest. The figures are per ray, or per box, with their
/// queries; the rays begin anywhere in the room and go in all directions.</summary>
[MemoryDiagnoser]
public class ScenePaths
{
    private const int Paths = 4096;
    private const ulong Seed = 71;

    private readonly RayQuery[] _rays = new RayQuery[Paths];
    private readonly RayHit[] _results = new RayHit[Paths];
    private readonly ConvexShape _box = ConvexShape.Box(new Vector3(0.5f));
    private CollisionScene _scene = new();
    private Workers? _workers;

    [Params(2_000, 100_000)]
    public int Objects { get; set; }

    [GlobalSetup]
    public void Setup()
    {
        var objects = new WorldScenes(Objects);
        var random = new Prng(Seed);
        _scene = objects.CreateScene(BroadPhaseKind.DynamicTree);
        for (int i = 0; i < Paths; i++)
        {
            Vector3 origin = objects.Poses[random.Index(Objects)].Position + random.UnitVector() * 1.5f;
            _rays[i] = new RayQuery(origin, random.UnitVector());
        }

        _workers = new Workers();
    }

    [GlobalCleanup]
    public void Cleanup() => _workers?.Dispose();

    /// <summary>The first object that each ray meets.</summary>
    [Benchmark(OperationsPerInvoke = Paths)]
    public int Rays()
    {
        _scene.FindFirstRayHits(_rays, _results);
        return _results[0].Id;
    }

    [Benchmark(OperationsPerInvoke = Paths)]
    public int RaysOnAllCores()
    {
        _scene.FindFirstRayHits(_rays, _results, _workers);
        return _results[0].Id;
    }

    /// <summary>The first object that a box of size 1 meets, on a way of 100.</summary>
    [Benchmark(OperationsPerInvoke = Paths)]
    public int Casts()
    {
        int sum = 0;
        foreach (RayQuery ray in _rays)
        {
            _scene.TryFindCastHit(_box, new RigidPose(ray.Origin), ray.Direction * 100, out CastHit hit);
            sum += hit.Id;
        }

        return sum;
    }

    /// <summary>The object nearest to a box of size 1.</summary>
    [Benchmark(OperationsPerInvoke = Paths)]
    public int Nearest()
    {
        int sum = 0;
        foreach (RayQuery ray in _rays)
        {
            _scene.TryFindNearest(_box, new RigidPose(ray.Origin), out PairDistance nearest);
            sum += nearest.Pair.B;
        }

        return sum;
    }
}
