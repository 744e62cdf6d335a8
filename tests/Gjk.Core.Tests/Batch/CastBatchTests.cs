using System.Threading;

namespace Gjk.Core.Tests.Batch;

/// <summary>Casts and rays in bulk: the bits of the single query, on any number of threads.</summary>
public class CastBatchTests
{
    private const int Pairs = 400;

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(3)]
    public void EachPairHasTheBitsOfItsCast(int threads)
    {
        Make(out ConvexShape[] shapes, out RigidPose[] poses, out Vector3[] motions, out ObjectPair[] pairs);
        motions[5] = new Vector3(float.NaN);
        var results = new CastResult[Pairs + 1];
        using Workers? workers = threads == 0 ? null : new Workers(threads);
        CastOptions options = threads == 1 ? CastOptions.OnlyDeeper(0.1f) : default;
        PairBatch.Cast(shapes, poses, motions, pairs, results, 1.5f, workers, default, options);
        for (int i = 0; i < Pairs; i++)
        {
            (int a, int b) = (pairs[i].A, pairs[i].B);
            CastResult single = ConvexQuery.Cast(
                shapes[a], poses[a], motions[a], shapes[b], poses[b], motions[b], 1.5f, options);
            Assert.True(CastBits.AreSame(single, results[i]), $"pair {i}: {results[i]}, alone {single}");
        }

        Assert.Equal(CastStatus.InvalidInput, results[2].Status);
        Assert.Equal(CastStatus.None, results[Pairs].Status);
        Assert.InRange(results.Count(r => r.IsHit), Pairs * 3 / 10, Pairs * 9 / 10);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(3)]
    public void EachRayHasTheBitsOfItsCast(int threads)
    {
        var rng = new Rng(8);
        using Workers? workers = threads == 0 ? null : new Workers(threads);
        CastOptions options = threads == 0 ? CastOptions.OnlyDeeper(0.1f) : default;
        foreach (string kind in Generators.AllKinds)
        {
            ConvexShape shape = Generators.Shape(rng, kind).Shape;
            RigidPose pose = Generators.Pose(rng, rng.Vector(-1, 1));
            RayQuery[] rays = [.. Enumerable.Range(0, 300).Select(
                _ => new RayQuery(rng.Vector(-3, 3), rng.UnitVector(), rng.Float(0, 6)))];
            var results = new RayCastResult[300];
            RayBatch.RayCast(shape, pose, rays, results, workers, default, options);
            for (int i = 0; i < rays.Length; i++)
            {
                RayCastResult single = ConvexQuery.RayCast(
                    shape, pose, rays[i].Origin, rays[i].Direction, rays[i].MaxDistance, options);
                Assert.True(CastBits.AreSame(single, results[i]), $"{kind}, ray {i}: {results[i]}, alone {single}");
            }
        }
    }

    [Fact]
    public void WhatDoesNotFitIsRefused()
    {
        Make(out ConvexShape[] shapes, out RigidPose[] poses, out Vector3[] motions, out ObjectPair[] pairs);
        var results = new CastResult[Pairs];
        Refused<ArgumentNullException>("shapes", () => PairBatch.Cast(null!, poses, motions, pairs, results));
        Refused<ArgumentNullException>("poses", () => PairBatch.Cast(shapes, null!, motions, pairs, results));
        Refused<ArgumentNullException>("translations", () => PairBatch.Cast(shapes, poses, null!, pairs, results));
        Refused<ArgumentNullException>("pairs", () => PairBatch.Cast(shapes, poses, motions, null!, results));
        Refused<ArgumentNullException>("results", () => PairBatch.Cast(shapes, poses, motions, pairs, null!));
        Refused<ArgumentException>("translations", () => PairBatch.Cast(shapes, poses, motions[1..], pairs, results));
        Refused<ArgumentException>("results", () => PairBatch.Cast(shapes, poses, motions, pairs, results[1..]));
        Refused<ArgumentException>(
            "pairs", () => PairBatch.Cast(shapes, poses, motions, [new(0, shapes.Length)], results));
        Refused<ArgumentOutOfRangeException>(
            "maxFraction", () => PairBatch.Cast(shapes, poses, motions, pairs, results, float.NaN));
        using var cancelled = new CancellationTokenSource();
        cancelled.Cancel();
        Assert.Throws<OperationCanceledException>(
            () => PairBatch.Cast(shapes, poses, motions, pairs, results, cancellation: cancelled.Token));
        Assert.All(results, r => Assert.Equal(CastStatus.None, r.Status));

        RayQuery[] rays = [new(default, Vector3.UnitX), default];
        var hits = new RayCastResult[2];
        Refused<ArgumentNullException>("rays", () => RayBatch.RayCast(shapes[0], poses[0], null!, hits));
        Refused<ArgumentNullException>("results", () => RayBatch.RayCast(shapes[0], poses[0], rays, null!));
        Refused<ArgumentException>("results", () => RayBatch.RayCast(shapes[0], poses[0], rays, hits[1..]));
        Refused<ArgumentException>("rays", () => RayBatch.RayCast(shapes[0], poses[0], rays, hits));
        Assert.Throws<OperationCanceledException>(
            () => RayBatch.RayCast(shapes[0], poses[0], rays[..1], hits, null, cancelled.Token));
        Assert.Equal(CastStatus.None, hits[0].Status);
        RayBatch.RayCast(default, poses[0], rays[..1], hits);
        Assert.Equal(CastStatus.InvalidInput, hits[0].Status);
    }

    private static void Refused<T>(string name, Action call)
        where T : ArgumentException => Assert.Equal(name, Assert.Throws<T>(call).ParamName);

    /// <summary>Pairs that begin apart; one shape flies past, or into, the other.</summary>
    private static void Make(
        out ConvexShape[] shapes, out RigidPose[] poses, out Vector3[] motions, out ObjectPair[] pairs)
    {
        (shapes, poses, motions) = (new ConvexShape[2 * Pairs], new RigidPose[2 * Pairs], new Vector3[2 * Pairs]);
        pairs = new ObjectPair[Pairs];
        for (int i = 0; i < Pairs; i++)
        {
            TestPair pair = Generators.Pair(91_000 + (ulong)i, Generators.AllKinds, 2);
            var rng = new Rng((ulong)i);
            pairs[i] = new ObjectPair(2 * i, 2 * i + 1);
            (shapes[2 * i], shapes[2 * i + 1]) = (pair.A.Shape, pair.B.Shape);
            (poses[2 * i], poses[2 * i + 1]) = (pair.PoseA, pair.PoseB);
            motions[2 * i] = (pair.PoseB.Position - pair.PoseA.Position) + rng.Vector(-0.5, 0.5);
            motions[2 * i + 1] = rng.Vector(-0.5, 0.5);
        }
    }
}
