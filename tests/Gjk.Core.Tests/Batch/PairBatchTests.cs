using System.Threading;

namespace Gjk.Core.Tests.Batch;

/// <summary>A batch is the queries one after the other, for any number of threads.</summary>
public class PairBatchTests
{
    private const int Unwritten = -1;

    [Fact]
    public void ABatchIsItsQueriesForAnyNumberOfThreads()
    {
        (ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs) = Input(1, 3000);
        string[] expected =
        [
            .. pairs.Select(
                p => ResultBits.Of(ConvexQuery.Distance(shapes[p.A], poses[p.A], shapes[p.B], poses[p.B])))
        ];
        bool[] overlapping =
            [.. pairs.Select(p => ConvexQuery.Overlaps(shapes[p.A], poses[p.A], shapes[p.B], poses[p.B]))];
        Assert.InRange(overlapping.Count(o => o) / (double)pairs.Length, 0.3, 0.7);
        foreach (int threads in new[] { 0, 1, 2, 3, 7 })
        {
            using Workers? workers = threads > 0 ? new Workers(threads) : null;
            Assert.Equal(threads, workers?.ThreadCount ?? 0);
            var distances = new DistanceResult[pairs.Length];
            var statuses = new GjkStatus[pairs.Length + 1];

            // What is there from another call is no answer.
            Array.Fill(statuses, GjkStatus.IterationLimit);
            PairBatch.Distance(shapes, poses, pairs, distances, workers: workers);
            PairBatch.Overlaps(shapes, poses, pairs, statuses, workers);
            Assert.True(
                expected.SequenceEqual(pairs.Select((p, i) => ResultBits.Of(distances[i]))),
                $"{threads} threads");
            Assert.True(
                overlapping.SequenceEqual(statuses.Take(pairs.Length).Select(s => s == GjkStatus.Overlapping)),
                $"{threads} threads");
            Assert.Equal(GjkStatus.IterationLimit, statuses[^1]);
        }
    }

    [Fact]
    public void FarPairsAreDoneEarly()
    {
        (ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs) = Input(2, 500);
        var results = new DistanceResult[pairs.Length];
        PairBatch.Distance(shapes, poses, pairs, results, 0.05f);
        Assert.True(results.All(r => r.Status == GjkStatus.BeyondMaxDistance || r.Distance <= 0.05f));
        Assert.InRange(results.Count(r => r.Status == GjkStatus.BeyondMaxDistance), 100, 400);
    }

    [Fact]
    public void ADefaultShapeOrPoseSpoilsItsPairsAlone()
    {
        ConvexShape[] shapes = [ConvexShape.Sphere(1), default, ConvexShape.Sphere(1)];
        RigidPose[] poses = [RigidPose.Identity, RigidPose.Identity, default];
        var results = new GjkStatus[4];
        PairBatch.Overlaps(shapes, poses, [new(0, 1), new(0, 0), new(2, 0), new(0, 0)], results);
        Assert.Equal(
            [GjkStatus.InvalidInput, GjkStatus.Overlapping, GjkStatus.InvalidInput, GjkStatus.Overlapping], results);
    }

    [Fact]
    public void BadArgumentsAreRefusedBeforeAnythingIsWritten()
    {
        (ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs) = Input(3, 10);
        var results = new DistanceResult[10];
        var statuses = new GjkStatus[10];
        Refused<ArgumentNullException>(
            "shapes", () => PairBatch.Overlaps(null!, poses, pairs, statuses),
            () => PairBatch.Distance(null!, poses, pairs, results));
        Refused<ArgumentNullException>(
            "poses", () => PairBatch.Overlaps(shapes, null!, pairs, statuses),
            () => PairBatch.Distance(shapes, null!, pairs, results));
        Refused<ArgumentNullException>(
            "pairs", () => PairBatch.Overlaps(shapes, poses, null!, statuses),
            () => PairBatch.Distance(shapes, poses, null!, results));
        Refused<ArgumentNullException>(
            "results", () => PairBatch.Overlaps(shapes, poses, pairs, null!),
            () => PairBatch.Distance(shapes, poses, pairs, null!));
        Refused<ArgumentException>("poses", () => PairBatch.Overlaps(shapes, [RigidPose.Identity], pairs, statuses));
        Refused<ArgumentException>(
            "results", () => PairBatch.Overlaps(shapes, poses, pairs, new GjkStatus[9]),
            () => PairBatch.Distance(shapes, poses, pairs, new DistanceResult[9]));
        Refused<ArgumentOutOfRangeException>(
            "maxDistance", () => PairBatch.Distance(shapes, poses, pairs, results, float.NaN));
        ObjectPair[] wrong =
            [new(-1, 0), new(0, -1), new(shapes.Length, 0), new(0, shapes.Length), new(int.MinValue, int.MaxValue)];
        foreach (ObjectPair bad in wrong)
        {
            pairs[7] = bad;
            Refused<ArgumentException>(
                "pairs", () => PairBatch.Overlaps(shapes, poses, pairs, statuses),
                () => PairBatch.Distance(shapes, poses, pairs, results));
            Assert.Contains(
                "Pair 7 ",
                Assert.Throws<ArgumentException>(() => PairBatch.Overlaps(shapes, poses, pairs, statuses)).Message);
        }

        Assert.All(results, r => Assert.Equal(0, r.Iterations));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(2)]
    public void ACancelledBatchThrowsAndTheWorkersStayUsable(int threads)
    {
        (ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs) = Input(4, 200_000, 200);
        using Workers? workers = threads > 0 ? new Workers(threads) : null;
        var results = new DistanceResult[pairs.Length];
        Unwrite(results);
        using var before = new CancellationTokenSource();
        before.Cancel();
        Assert.Throws<OperationCanceledException>(
            () => PairBatch.Distance(shapes, poses, pairs, results, workers: workers, cancellation: before.Token));
        Assert.DoesNotContain(results, IsWritten);

        // A thread that wakes late finds the batch done: then again.
        int tries = 0;
        while (!IsCancelledMeanwhile(shapes, poses, pairs, results, workers))
            Assert.True(++tries < 50, "never cancelled in time");
        Assert.InRange(results.Count(IsWritten), 1, pairs.Length - 1);
        PairBatch.Distance(shapes, poses, pairs, results, workers: workers);
        Assert.True(results.All(IsWritten));
    }

    [Fact]
    public void DisposedWorkersAreRefused()
    {
        Assert.Equal("threadCount", Assert.Throws<ArgumentOutOfRangeException>(() => new Workers(0)).ParamName);
        var workers = new Workers(2);
        workers.Dispose();
        workers.Dispose();
        Assert.Throws<ObjectDisposedException>(() => PairBatch.Overlaps([], [], [], [], workers));
        var scene = new CollisionScene();
        Assert.Throws<ObjectDisposedException>(() => scene.FindOverlaps([], workers));
    }

    [Fact]
    public void ManyCallersShareWorkers()
    {
        (ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs) = Input(6, 1000, 100);
        var expected = new GjkStatus[pairs.Length];
        PairBatch.Overlaps(shapes, poses, pairs, expected);
        using var workers = new Workers(3);
        int wrong = 0;
        Thread[] callers = [.. Enumerable.Range(0, 4).Select(_ => new Thread(() =>
        {
            var statuses = new GjkStatus[pairs.Length];
            for (int i = 0; i < 100; i++)
            {
                Array.Clear(statuses);
                PairBatch.Overlaps(shapes, poses, pairs, statuses, workers);
                if (!expected.SequenceEqual(statuses)) Interlocked.Increment(ref wrong);
            }
        }))];
        foreach (Thread caller in callers) caller.Start();
        foreach (Thread caller in callers) caller.Join();
        Assert.Equal(0, wrong);
    }

    [Fact]
    public void WarmBatchesAreTheWarmQueries()
    {
        (ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs) = Input(3, 800);
        WarmStart[] batch = new WarmStart[pairs.Length], alone = new WarmStart[pairs.Length];
        var results = new DistanceResult[pairs.Length];
        using var workers = new Workers(2);
        for (int frame = 0; frame < 3; frame++)
        {
            PairBatch.Distance(
                shapes, poses, pairs, results, batch, frame == 2 ? 0.1f : float.PositiveInfinity,
                frame == 1 ? workers : null);
            for (int i = 0; i < pairs.Length; i++)
            {
                (int a, int b) = (pairs[i].A, pairs[i].B);
                DistanceResult expected = ConvexQuery.Distance(
                    shapes[a], poses[a], shapes[b], poses[b], ref alone[i], frame == 2 ? 0.1f : float.PositiveInfinity);
                Assert.True(ResultBits.AreSame(expected, results[i]), $"frame {frame}, pair {i}");
            }
        }
    }

    [Fact]
    public void ThereMustBeAWarmStartForEachPair()
    {
        (ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs) = Input(3, 8);
        var results = new DistanceResult[8];
        Assert.Throws<ArgumentException>(
            "warmStarts", () => PairBatch.Distance(shapes, poses, pairs, results, new WarmStart[7]));
        Assert.Throws<ArgumentNullException>(
            "warmStarts", () => PairBatch.Distance(shapes, poses, pairs, results, null!));
        Assert.Equal(GjkStatus.None, results[0].Status);
    }

    private static (ConvexShape[] Shapes, RigidPose[] Poses, ObjectPair[] Pairs) Input(
        ulong seed, int count, int objects = 40)
    {
        var world = new MovingWorld(seed, objects, Generators.AllKinds, side: 1.2f);
        ObjectPair[] pairs =
        [
            .. Enumerable.Range(0, count).Select(
                _ => new ObjectPair(world.Rng.Below(objects), world.Rng.Below(objects)))
        ];
        return ([.. world.Shapes], [.. world.Poses], pairs);
    }

    private static bool IsCancelledMeanwhile(
        ConvexShape[] shapes, RigidPose[] poses, ObjectPair[] pairs, DistanceResult[] results, Workers? workers)
    {
        Unwrite(results);
        using var cancellation = new CancellationTokenSource();
        var canceller = new Thread(() =>
        {
            // The first result is written: the batch runs.
            while (Volatile.Read(ref results[0].IterationsOf()) == Unwritten) Thread.Yield();
            cancellation.Cancel();
        });
        canceller.Start();
        try
        {
            PairBatch.Distance(shapes, poses, pairs, results, workers: workers, cancellation: cancellation.Token);
            return false;
        }
        catch (OperationCanceledException e)
        {
            Assert.Equal(cancellation.Token, e.CancellationToken);
            return !results.All(IsWritten);
        }
        finally
        {
            canceller.Join();
        }
    }

    /// <summary>Marks results with a count of iterations that no query gives.</summary>
    private static void Unwrite(DistanceResult[] results)
    {
        for (int i = 0; i < results.Length; i++) results[i].IterationsOf() = Unwritten;
    }

    private static bool IsWritten(DistanceResult result) => result.Iterations != Unwritten;

    private static void Refused<T>(string parameter, params Action[] calls)
        where T : ArgumentException
    {
        foreach (Action call in calls) Assert.Equal(parameter, Assert.Throws<T>(call).ParamName);
    }
}

internal static class DistanceResultFields
{
    /// <summary>The field itself, for a look from another thread.</summary>
    public static ref int IterationsOf(this ref DistanceResult result) =>
        ref System.Runtime.CompilerServices.Unsafe.AsRef(in result.Iterations);
}
