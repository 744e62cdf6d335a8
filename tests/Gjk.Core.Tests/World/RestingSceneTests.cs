using System.Collections.Generic;
using System.Linq;
using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests.World;

/// <summary>A pair whose objects have not moved keeps its answer; one that moved is asked again.</summary>
public class RestingSceneTests
{
    private const int Objects = 80;

    private const float Reach = 0.3f;

    [Theory]
    [InlineData(BroadPhaseKind.AllPairs, 0)]
    [InlineData(BroadPhaseKind.DynamicTree, 0)]
    [InlineData(BroadPhaseKind.DynamicTree, 2)]
    public void RestingPairsKeepTheirBitsAndMovedOnesAreAsked(BroadPhaseKind phase, int threads)
    {
        using Workers? workers = threads > 0 ? new Workers(threads) : null;
        var rng = new Rng(4);
        CollisionScene scene = Made(rng, phase);
        List<PairDistance> before = [], now = [];
        for (int frame = 0; frame < 40; frame++)
        {
            scene.FindPairsWithin(Reach, before, workers);
            var moved = new HashSet<int>();
            for (int k = rng.Below(4); k > 0; k--) moved.Add(rng.Below(Objects));
            foreach (int id in moved) scene.Move(id, Generators.Pose(rng, rng.Vector(-1.5, 1.5)));
            for (int id = 0; id < Objects; id += 7) scene.Move(id, scene.GetPose(id));
            float reach = frame % 5 == 4 ? Reach / 2 : Reach;
            scene.FindPairsWithin(reach, now, workers);
            Check(scene, before, now, moved, reach);
        }
    }

    /// <summary>A warm query of an unmoved pair would end after one support; a kept answer was won by more.</summary>
    [Fact]
    public void NothingIsAskedOfAPairThatRests()
    {
        CollisionScene scene = Made(new Rng(9), BroadPhaseKind.AllPairs);
        List<PairDistance> before = [], now = [];
        scene.FindPairsWithin(float.PositiveInfinity, before);
        Assert.Equal(Objects * (Objects - 1) / 2, before.Count);
        Assert.InRange(before.Count(p => p.Result.Iterations > 1), before.Count / 2, before.Count);
        for (int i = 0; i < 3; i++)
        {
            scene.FindPairsWithin(float.PositiveInfinity, now);
            Assert.True(before.Zip(now).All(p => ResultBits.AreSame(p.First.Result, p.Second.Result)));
        }
    }

    private static void Check(
        CollisionScene scene, List<PairDistance> before, List<PairDistance> now, HashSet<int> moved, float reach)
    {
        var last = before.ToDictionary(p => p.Pair, p => p.Result);
        foreach (PairDistance p in now)
        {
            bool rests = !moved.Contains(p.Pair.A) && !moved.Contains(p.Pair.B);
            if (rests) Assert.True(ResultBits.AreSame(last[p.Pair], p.Result));
            DistanceResult alone = ConvexQuery.Distance(
                scene.GetShape(p.Pair.A), scene.GetPose(p.Pair.A), scene.GetShape(p.Pair.B), scene.GetPose(p.Pair.B));
            Assert.Equal(alone.Status, p.Result.Status);
            Assert.Equal(alone.Distance, p.Result.Distance, 1e-6f);
        }

        IEnumerable<ObjectPair> kept = before.Where(
            p => !moved.Contains(p.Pair.A) && !moved.Contains(p.Pair.B) && p.Result.Distance <= reach)
            .Select(p => p.Pair);
        Assert.Empty(kept.Except(now.Select(p => p.Pair)));
    }

    private static CollisionScene Made(Rng rng, BroadPhaseKind phase)
    {
        var scene = new CollisionScene(phase);
        for (int i = 0; i < Objects; i++)
            scene.Add(Generators.Shape(rng, "hull").Shape, Generators.Pose(rng, rng.Vector(-1.5, 1.5)));
        return scene;
    }
}
