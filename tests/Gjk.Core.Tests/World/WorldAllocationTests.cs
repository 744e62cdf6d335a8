using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests.World;

/// <summary>A frame allocates nothing once the buffers have their size.</summary>
public class WorldAllocationTests
{
    private const int Objects = 120, FewObjects = 60;
    private const int WarmUpFrames = 30;
    private const int Frames = 30;

    public static TheoryData<BroadPhaseKind> Scenes => CollisionSceneTests.Scenes;

    [Theory]
    [MemberData(nameof(Scenes))]
    public void NothingIsAllocatedOnOneThread(BroadPhaseKind kind)
    {
        Action frame = Frame(kind, null);
        for (int i = 0; i < WarmUpFrames; i++) frame();
        Assert.Equal(0, Allocation.Least(() =>
        {
            for (int i = 0; i < Frames; i++) frame();
        }));
    }

    /// <summary>Counts every thread of the process, so other tests must rest meanwhile.</summary>
    [Collection(nameof(Alone))]
    public class OnManyThreads
    {
        [Fact]
        public void NothingIsAllocatedInTotal()
        {
            using var workers = new Workers(2);
            Action frame = Frame(BroadPhaseKind.DynamicTree, workers, FewObjects);
            for (int i = 0; i < WarmUpFrames; i++) frame();

            Assert.True(Least(() => GC.KeepAlive(new byte[64])) >= 64, "the measure does not see an allocation");
            Assert.Equal(Least(() => { }), Least(frame));
        }

        /// <summary>What two runs, there and back, allocate in all threads, the measure's own included. The runtime and
        /// the test host allocate now and then too, hence many short tries; what the work allocates, it allocates in
        /// every one.</summary>
        private static long Least(Action work)
        {
            long least = long.MaxValue;
            for (int attempt = 0; attempt < 100; attempt++)
            {
                long before = GC.GetTotalAllocatedBytes(true);
                for (int i = 0; i < 2; i++) work();
                least = Math.Min(least, GC.GetTotalAllocatedBytes(true) - before);
            }

            return least;
        }
    }

    /// <summary>Every object moves to and fro; all questions are asked.</summary>
    internal static Action Frame(BroadPhaseKind kind, Workers? workers, int count = Objects)
    {
        var world = new MovingWorld(21, count, ["box", "hull", "sphere", "cylinder"]);
        var there = new RigidPose[count];
        for (int i = 0; i < count; i++)
            there[i] = new RigidPose(world.Rng.Rotation(), world.Poses[i].Position + world.Rng.Vector(-0.1, 0.1));
        RigidPose[] here = [.. world.Poses];
        CollisionScene scene = world.Scene(kind);
        List<ObjectPair> overlaps = [], candidates = [];
        List<PairDistance> within = [];
        List<PairContacts> contacts = [];
        ConvexShape[] shapes = [.. world.Shapes];
        var pairs = new ObjectPair[3 * count];
        var statuses = new GjkStatus[pairs.Length];
        var distances = new DistanceResult[pairs.Length];
        for (int i = 0; i < pairs.Length; i++)
            pairs[i] = new ObjectPair(world.Rng.Below(count), world.Rng.Below(count));
        RayQuery[] rays =
            [.. Enumerable.Range(0, count).Select(i => new RayQuery(here[i].Position, world.Rng.Direction()))];
        Vector3[] motions = [.. Enumerable.Range(0, count).Select(_ => world.Rng.Vector(-1, 1))];
        var firstHits = new RayHit[count];
        List<RayHit> rayHits = [];
        List<CastHit> castHits = [];
        List<int> overlapping = [];
        int[] ids = [.. Enumerable.Range(0, count)];
        var casts = new CastResult[pairs.Length];
        var rayResults = new RayCastResult[count];
        bool back = false;
        return () =>
        {
            RigidPose[] poses = back ? here : there;
            back = !back;
            if (workers is null)
                for (int i = 0; i < count; i++) scene.Move(i, poses[i]);
            else scene.MoveAll(ids, poses, workers);
            scene.FindOverlaps(overlaps, workers);
            scene.CollectCandidates(candidates, 0, workers);
            scene.FindOverlapsAmong(candidates, overlaps, workers);
            scene.FindPairsWithin(0.2f, within, workers);
            scene.FindDepths(within, workers);
            scene.FindContacts(0, contacts, workers);
            scene.FindContacts(0.05f, contacts, workers);
            for (int i = 0; i < 50 && i + 1 < count; i++)
            {
                scene.TryFindNearest(i, out _);
                scene.Distance(i, i + 1);
            }

            AskPaths(scene, shapes, poses, rays, firstHits, rayHits, castHits, overlapping, workers);
            PairBatch.Cast(shapes, poses, motions, pairs, casts, 1, workers);
            RayBatch.RayCast(shapes[0], poses[0], rays, rayResults, workers);
            PairBatch.Overlaps(shapes, poses, pairs, statuses, workers);
            PairBatch.Distance(shapes, poses, pairs, distances, 1, workers);
        };
    }

    private static void AskPaths(
        CollisionScene scene, ConvexShape[] shapes, RigidPose[] poses, RayQuery[] rays, RayHit[] firstHits,
        List<RayHit> rayHits, List<CastHit> castHits, List<int> ids, Workers? workers)
    {
        scene.FindFirstRayHits(rays, firstHits, workers);
        for (int i = 0; i < 20; i++)
        {
            scene.TryFindRayHit(rays[i], out _);
            scene.FindRayHits(rays[i], rayHits);
            scene.TryFindCastHit(shapes[i], poses[i], Vector3.UnitX, out _);
            scene.FindCastHits(shapes[i], poses[i], Vector3.UnitX, castHits);
            scene.FindObjectsOverlapping(shapes[i], poses[i], ids);
            scene.TryFindNearest(shapes[i], poses[i], out _, 1);
        }
    }
}

/// <summary>Tests that no other test may run beside.</summary>
[CollectionDefinition(nameof(Alone), DisableParallelization = true)]
public class Alone;
