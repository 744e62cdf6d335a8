namespace Gjk.Core.Tests.World;

/// <summary>Moving all objects at once is moving them one by one, for any number of threads and every broad
/// phase.</summary>
public class SceneMoveAllTests
{
    private const int Frames = 25;

    /// <summary>Enough objects that parts of the tree are moved in parallel; some come and go, some jump, some rest;
    /// ids in any order, some twice.</summary>
    [Theory]
    [InlineData(BroadPhaseKind.DynamicTree, 1)]
    [InlineData(BroadPhaseKind.DynamicTree, 2)]
    [InlineData(BroadPhaseKind.DynamicTree, 5)]
    [InlineData(BroadPhaseKind.SortAndSweep, 2)]
    public void ItIsMovingOneByOne(BroadPhaseKind kind, int threads)
    {
        using var workers = new Workers(threads);
        var world = new MovingWorld(31, 1500, ["box", "hull", "sphere", "capsule"]);
        CollisionScene one = world.Scene(kind), all = world.Scene(kind);
        List<PairDistance> expected = [], found = [];
        List<ObjectPair> overlaps = [], candidates = [], others = [];
        int pairs = 0;
        for (int frame = 0; frame < Frames; frame++)
        {
            if (frame % 5 == 3) Replace(world, one, all, world.Rng.Below(40));
            int[] ids = SomeIds(world, one, frame % 3 == 1 ? 8 : 1);
            RigidPose[] poses = [.. ids.Select(id => Stepped(world, id))];
            for (int i = 0; i < ids.Length; i++) one.Move(ids[i], poses[i]);
            all.MoveAll(ids, poses, workers);
            one.FindPairsWithin(0.1f, expected);
            all.FindPairsWithin(0.1f, found, workers);
            Assert.Equal(expected, found);
            one.FindOverlaps(overlaps);
            all.FindOverlaps(others, workers);
            Assert.Equal(overlaps, others);
            one.CollectCandidates(overlaps, 0.3f);
            all.CollectCandidates(candidates, 0.3f, workers);
            Assert.Equal(overlaps, candidates);
            pairs += found.Count;
        }

        Assert.InRange(pairs, 200 * Frames, 4000 * Frames);
    }

    [Fact]
    public void TheLastPoseOfAnObjectCounts()
    {
        var scene = new CollisionScene();
        int id = scene.Add(ConvexShape.Sphere(1), RigidPose.Identity);
        int other = scene.Add(ConvexShape.Sphere(1), new RigidPose(Quaternion.Identity, new Vector3(9, 0, 0)));
        RigidPose near = new(Quaternion.Identity, new Vector3(8, 0, 0));
        List<ObjectPair> pairs = [];
        scene.MoveAll([id, other, id], [near, scene.GetPose(other), RigidPose.Identity]);
        scene.FindOverlaps(pairs);
        Assert.Empty(pairs);
        scene.MoveAll([id, other, id], [RigidPose.Identity, scene.GetPose(other), near]);
        Assert.Equal(near, scene.GetPose(id));
        scene.FindOverlaps(pairs);
        Assert.Equal([new ObjectPair(id, other)], pairs);
    }

    [Fact]
    public void HalfSpacesMoveToo()
    {
        var scene = new CollisionScene();
        int floor = scene.Add(ConvexShape.HalfSpace(Vector3.UnitY, 0), RigidPose.Identity);
        int ball = scene.Add(ConvexShape.Sphere(1), new RigidPose(Quaternion.Identity, new Vector3(0, 2, 0)));
        List<ObjectPair> pairs = [];
        var up = new RigidPose(Quaternion.Identity, Vector3.UnitY);
        scene.MoveAll([ball, floor], [new RigidPose(Quaternion.Identity, new Vector3(1, 2, 0)), up]);
        scene.FindOverlaps(pairs);
        Assert.Equal([new ObjectPair(floor, ball)], pairs);
        Assert.Equal(up, scene.GetPose(floor));
    }

    /// <summary>A floor without an end is in no tree, and its number is among those that are moved.</summary>
    [Fact]
    public void AFloorWithoutAnEndMovesWithTheRest()
    {
        using var workers = new Workers(3);
        var world = new MovingWorld(33, 1500, ["box", "sphere"]);
        CollisionScene one = world.Scene(BroadPhaseKind.DynamicTree), all = world.Scene(BroadPhaseKind.DynamicTree);
        int floor = one.Add(ConvexShape.HalfSpace(Vector3.UnitY, 0), RigidPose.Identity);
        Assert.Equal(floor, all.Add(ConvexShape.HalfSpace(Vector3.UnitY, 0), RigidPose.Identity));
        int[] ids = [.. Enumerable.Range(0, floor + 1)];
        List<ObjectPair> expected = [], found = [];
        for (int frame = 1; frame <= 5; frame++)
        {
            RigidPose[] poses = [.. ids[..floor].Select(id => Stepped(world, id)), new(frame * 0.3f * Vector3.UnitY)];
            for (int i = 0; i < ids.Length; i++) one.Move(ids[i], poses[i]);
            all.MoveAll(ids, poses, workers);
            one.FindOverlaps(expected);
            all.FindOverlaps(found, workers);
            Assert.Equal(expected, found);
            Assert.Contains(found, pair => pair.B == floor);
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    public void WhatIsRefusedMovesNothing(int threads)
    {
        using var workers = new Workers(threads);
        var world = new MovingWorld(32, 2000, ["box"]);
        CollisionScene scene = world.Scene(BroadPhaseKind.DynamicTree);
        scene.Remove(1700);
        int[] ids = [.. Enumerable.Range(0, 1500)];
        RigidPose[] poses = [.. ids.Select(_ => RigidPose.Identity)];
        Refuses<ArgumentNullException>(scene, null!, poses, "ids");
        Refuses<ArgumentNullException>(scene, ids, null!, "poses");
        Refuses<ArgumentException>(scene, ids, poses[..^1], "poses");
        poses[1400] = default;
        Refuses<ArgumentException>(scene, ids, poses, "poses[1400]");
        ids[600] = 1700;
        Refuses<ArgumentOutOfRangeException>(scene, ids, poses, "ids[600]");
        ids[3] = -1;
        Refuses<ArgumentOutOfRangeException>(scene, ids, poses, "ids[3]");
        for (int id = 0; id < 1500; id++) Assert.Equal(world.Poses[id], scene.GetPose(id));
        workers.Dispose();
        Assert.Throws<ObjectDisposedException>(() => scene.MoveAll([0], [RigidPose.Identity], workers));
        Assert.Equal(world.Poses[0], scene.GetPose(0));

        void Refuses<T>(CollisionScene scene, int[] ids, RigidPose[] poses, string name)
            where T : ArgumentException =>
            Assert.Equal(name, Assert.Throws<T>(() => scene.MoveAll(ids, poses, workers)).ParamName);
    }

    /// <summary>One in so many of the objects that are there, out of order, a few of them twice.</summary>
    private static int[] SomeIds(MovingWorld world, CollisionScene scene, int oneIn)
    {
        Rng rng = world.Rng;
        int[] ids = [.. Enumerable.Range(0, world.Count).Where(id => scene.Contains(id) && rng.Below(oneIn) == 0)];
        for (int i = 0; i < ids.Length / 10; i++)
        {
            int a = rng.Below(ids.Length), b = rng.Below(ids.Length);
            if (i % 4 == 0) ids[a] = ids[b];
            else (ids[a], ids[b]) = (ids[b], ids[a]);
        }

        return ids;
    }

    private static RigidPose Stepped(MovingWorld world, int id)
    {
        if (world.Rng.Below(10) > 0) world.Step(id);
        return world.Poses[id];
    }

    private static void Replace(MovingWorld world, CollisionScene one, CollisionScene all, int count)
    {
        for (int i = 0; i < count; i++)
        {
            int id = world.Rng.Below(world.Count);
            if (one.Contains(id))
            {
                one.Remove(id);
                all.Remove(id);
            }

            int added = world.Add();
            Assert.Equal(added, one.Add(world.Shapes[added], world.Poses[added]));
            Assert.Equal(added, all.Add(world.Shapes[added], world.Poses[added]));
        }
    }
}
