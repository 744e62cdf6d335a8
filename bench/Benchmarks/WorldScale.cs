using System.Collections.Generic;
using BenchmarkDotNet.Attributes;
using Gjk.Bench.Scenes;
using Gjk.Core;

namespace Gjk.Bench.Benchmarks;

/// <summary>
/// A frame of a whole scene: the objects move, and the overlapping pairs are found. The figures are per frame. For
/// moving objects they include the computation of the new poses, about 50 ns per object. <see cref="Scale.ScaleRun"/>
/// leaves that out and shows the parts.
/// </summary>
[MemoryDiagnoser]
public class WorldScale
{
    private readonly List<ObjectPair> _candidates = [];
    private readonly List<ObjectPair> _pairs = [];
    private WorldScenes _objects = new(0);
    private CollisionScene _scene = new();
    private Workers? _workers;

    [Params(20, 200, 2_000, 20_000, 100_000)]
    public int Objects { get; set; }

    [Params(BroadPhaseKind.SortAndSweep, BroadPhaseKind.DynamicTree)]
    public BroadPhaseKind Phase { get; set; }

    [Params(false, true)]
    public bool Moving { get; set; }

    [GlobalSetup]
    public void Setup()
    {
        _objects = new WorldScenes(Objects);
        _scene = _objects.CreateScene(Phase);
        _workers = new Workers();
    }

    [GlobalCleanup]
    public void Cleanup() => _workers?.Dispose();

    [Benchmark]
    public int Broad()
    {
        Move();
        _scene.CollectCandidates(_candidates);
        return _candidates.Count;
    }

    [Benchmark]
    public int Frame()
    {
        Move();
        _scene.FindOverlaps(_pairs);
        return _pairs.Count;
    }

    [Benchmark]
    public int FrameOnAllCores()
    {
        Move();
        _scene.FindOverlaps(_pairs, _workers);
        return _pairs.Count;
    }

    private void Move()
    {
        if (!Moving) return;
        _objects.Advance();
        _objects.MoveAll(_scene);
    }
}
