namespace Gjk.Core.Tests.Batch;

/// <summary>Batches of concave pairs, warm and cold, on one thread or many, are single queries.</summary>
public class ConcaveBatchTests
{
    private const int Count = 16;

    [Fact]
    public void ABatchSaysWhatSingleQueriesSay()
    {
        using var workers = new Workers(3);
        var random = new Rng(1);
        AnyShape[] shapes = [.. Enumerable.Range(0, Count).Select(_ => ConcaveShapes.Any(random))];
        RigidPose[] poses = [.. shapes.Select(_ => ConcaveShapes.Pose(random, 2))];
        ObjectPair[] pairs =
        [
            .. from a in Enumerable.Range(0, Count) from b in Enumerable.Range(0, Count) where a != b
               select new ObjectPair(a, b),
        ];
        var results = new PairDistance[pairs.Length];
        var warmStarts = new PartWarmStart[pairs.Length];
        var scratch = new ConcaveScratch();
        for (int frame = 0; frame < 4; frame++)
        {
            PairDistance[] expected =
            [
                .. pairs.Select(p => ConcaveQuery.Distance(
                    shapes[p.A], poses[p.A], shapes[p.B], poses[p.B], scratch, 3)),
            ];
            foreach (Workers? threads in new[] { null, workers })
            {
                PairBatch.Distance(shapes, poses, pairs, results, scratch, maxDistance: 3, workers: threads);
                Assert.Equal(expected.Select(r => r.ToString()), results.Select(r => r.ToString()));
                PairBatch.Distance(shapes, poses, pairs, results, scratch, warmStarts, 3, threads);
                Assert.Equal(
                    expected.Select(r => (r.Status, r.Distance)), results.Select(r => (r.Status, r.Distance)));
            }

            Assert.Contains(expected, r => r.IsOverlapping);
            Assert.Contains(expected, r => r.Distance > 0 && r.Distance < 3);
            for (int i = 0; i < Count; i++)
                poses[i] = new RigidPose(poses[i].Rotation, poses[i].Position + random.Vector(0.05));
        }

        Assert.Equal(
            0, Allocation.Least(() => PairBatch.Distance(shapes, poses, pairs, results, scratch, warmStarts)));
    }

    [Fact]
    public void AWarmStartOfOtherShapesIsOnlyAGuess()
    {
        var random = new Rng(2);
        var scratch = new ConcaveScratch();
        PartWarmStart warm = default;
        for (int i = 0; i < 200; i++)
        {
            AnyShape a = ConcaveShapes.Any(random), b = ConcaveShapes.Any(random);
            RigidPose poseA = ConcaveShapes.Pose(random, 1.5), poseB = ConcaveShapes.Pose(random, 1.5);
            float limit = random.OneIn(2) ? 0.3f : float.PositiveInfinity;
            PairDistance cold = ConcaveQuery.Distance(a, poseA, b, poseB, scratch, limit);
            PairDistance found = ConcaveQuery.Distance(a, poseA, b, poseB, ref warm, scratch, limit);
            Assert.Equal((cold.Status, cold.Distance), (found.Status, found.Distance));
            Assert.True(found.Status == GjkStatus.BeyondMaxDistance || found.Result.LowerBound <= cold.Distance);
            if (random.OneIn(9)) warm.Clear();
        }
    }

    [Fact]
    public void BadCallsAreRefused()
    {
        AnyShape[] shapes = [AnyShape.Of(ConvexShape.Sphere(1)), AnyShape.Surface(ConcaveShapes.Grid(2))];
        RigidPose[] poses = [RigidPose.Identity, new RigidPose(new Vector3(0, 3, 0))];
        ObjectPair[] pairs = [new(0, 1)];
        var results = new PairDistance[1];
        var scratch = new ConcaveScratch();
        Assert.Throws<ArgumentNullException>(() => PairBatch.Distance(shapes, poses, pairs, results, null!));
        Assert.Throws<ArgumentException>(() => PairBatch.Distance(shapes, poses, pairs, results, scratch, []));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => PairBatch.Distance(shapes, poses, pairs, results, scratch, maxDistance: float.NaN));
        Assert.Throws<ArgumentException>(
            () => PairBatch.Distance(shapes, poses, [new(0, 2)], results, scratch));
        PairBatch.Distance(shapes, poses, pairs, results, scratch);
        Assert.Equal(2, results[0].Distance);
    }
}
