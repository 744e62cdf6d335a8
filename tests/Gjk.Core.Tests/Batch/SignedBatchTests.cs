namespace Gjk.Core.Tests.Batch;

/// <summary>The batch of signed distances: the bits of the single query, on any number of threads.</summary>
public class SignedBatchTests
{
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(3)]
    public void EachPairHasTheBitsOfItsQuery(int threads)
    {
        (ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs) = Objects();
        var results = new DistanceResult[pairs.Length];
        using Workers? workers = threads == 0 ? null : new Workers(threads);
        PairBatch.SignedDistance(shapes, poses, pairs, results, workers);
        for (int i = 0; i < pairs.Length; i++)
        {
            int a = pairs[i].A, b = pairs[i].B;
            DistanceResult single = ConvexQuery.SignedDistance(shapes[a], poses[a], shapes[b], poses[b]);
            Assert.True(ResultBits.AreSame(single, results[i]), $"pair {i}: {results[i]}, alone {single}");
        }

        Assert.Contains(results, r => r.Distance < 0);
        Assert.Contains(results, r => r.Distance > 0);
    }

    [Fact]
    public void WhatDoesNotFitIsRefused()
    {
        (ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs) = Objects();
        Assert.Throws<ArgumentNullException>(() => PairBatch.SignedDistance(shapes, poses, pairs, null!));
        Assert.Throws<ArgumentException>(
            () => PairBatch.SignedDistance(shapes, poses, pairs, new DistanceResult[pairs.Length - 1]));
        ObjectPair[] stray = [new(0, shapes.Length)];
        Assert.Contains(
            "Pair 0",
            Assert.Throws<ArgumentException>(
                () => PairBatch.SignedDistance(shapes, poses, stray, new DistanceResult[1])).Message);
    }

    private static (ConvexShape[] Shapes, RigidPose[] Poses, ObjectPair[] Pairs) Objects()
    {
        TestPair[] pairs =
            [.. Enumerable.Range(0, 400).Select(i => Generators.Pair(83_000 + (ulong)i, Generators.AllKinds, 0.8))];
        var shapes = new List<ConvexShape>();
        var poses = new List<RigidPose>();
        foreach (TestPair p in pairs)
        {
            shapes.AddRange([p.A.Shape, p.B.Shape]);
            poses.AddRange([p.PoseA, p.PoseB]);
        }

        ObjectPair[] indices = [.. Enumerable.Range(0, pairs.Length).Select(i => new ObjectPair(2 * i, 2 * i + 1))];
        return ([.. shapes], [.. poses], indices);
    }
}
