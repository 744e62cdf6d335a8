namespace Gjk.Core.Tests.World;

/// <summary>What a scene does.</summary>
public class CollisionSceneTests
{
    internal static readonly ConvexShape Ball = ConvexShape.Sphere(1);

    public static TheoryData<BroadPhaseKind> Scenes => [.. Enum.GetValues<BroadPhaseKind>()];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void AFewBallsInARowAreAnswered(BroadPhaseKind kind)
    {
        CollisionScene scene = Row(kind, 0, 2, 5, 9);
        Assert.Equal([new(0, 1)], Overlaps(scene));
        List<PairDistance> within = [];
        scene.FindPairsWithin(1, within);
        Assert.Equal([(new(0, 1), 0f), (new ObjectPair(1, 2), 1f)], within.Select(p => (p.Pair, p.Result.Distance)));
        scene.FindPairsWithin(float.PositiveInfinity, within);
        Assert.Equal(6, within.Count);
        Assert.True(scene.TryFindNearest(3, out PairDistance nearest));
        Assert.Equal((new ObjectPair(3, 2), 2f), (nearest.Pair, nearest.Distance));
        Assert.Equal((At(8), At(6)), (nearest.Result.PointA, nearest.Result.PointB));
        Assert.Equal(3f, scene.Distance(0, 2).Distance);
        Assert.Equal((At(4), At(1)), (scene.Distance(2, 0).PointA, scene.Distance(2, 0).PointB));

        scene.Move(2, new RigidPose(At(10)));
        Assert.Equal([new(0, 1), new(2, 3)], Overlaps(scene));
        scene.Remove(0);
        Assert.Equal([new(2, 3)], Overlaps(scene));
        Assert.False(scene.Contains(0));
        Assert.Equal((At(10), 1.0), (scene.GetPose(2).Position, scene.GetShape(2).Margin));
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void IdsAreNeverGivenTwiceAndKeepTheirObjects(BroadPhaseKind kind)
    {
        var scene = new CollisionScene(kind);
        var rng = new Rng(5);
        SortedDictionary<int, Vector3> there = [];
        for (int i = 0; i < 3000; i++)
        {
            Vector3 position = rng.Vector(0, 12);
            Assert.Equal(i, scene.Add(Ball, new RigidPose(position)));
            there.Add(i, position);
            // Every thousandth stays for good, the others for some forty rounds; so the arrays close up again and
            // again.
            foreach (int old in there.Keys.Where(id => id % 1000 != 0 && id < i - 40).ToArray())
            {
                scene.Remove(old);
                there.Remove(old);
                Assert.Throws<ArgumentOutOfRangeException>(() => scene.Move(old, RigidPose.Identity));
            }

            if (i % 97 == 0) CheckObjects(scene, there);
        }

        CheckObjects(scene, there);
        foreach (int id in there.Keys.ToArray()) scene.Remove(id);
        Assert.Equal(0, scene.Count);
        Assert.Empty(Overlaps(scene));
        Assert.Equal(3000, scene.Add(Ball, RigidPose.Identity));
    }

    [Fact]
    public void CandidatesAndTheirOverlapsAreTheTwoHalvesOfOverlaps()
    {
        CollisionScene scene = new MovingWorld(4, 100, ["box", "hull", "sphere"]).Scene(BroadPhaseKind.SortAndSweep);
        for (int id = 0; id < 60; id++) scene.Remove(id);
        for (int i = 0; i < 90; i++) scene.Add(Ball, new RigidPose(At(i)));
        List<ObjectPair> candidates = [], results = [];
        scene.CollectCandidates(candidates);
        scene.FindOverlapsAmong(candidates, results);
        Assert.Equal(Overlaps(scene), results);
        Assert.InRange(results.Count, 90, candidates.Count - 1);
        List<ObjectPair> wider = [];
        scene.CollectCandidates(wider, 1);
        Assert.True(wider.Count > candidates.Count && !candidates.Except(wider).Any());
        candidates.Reverse();
        scene.FindOverlapsAmong(candidates, results);
        Assert.Equal(Overlaps(scene).AsEnumerable().Reverse(), results);
    }

    /// <summary>In either order, whatever was asked before.</summary>
    [Fact]
    public void TheDistanceOfTwoObjectsHasTheBitsOfTheQuery()
    {
        var world = new MovingWorld(11, 40, ["bigHull", "cylinder", "box"]);
        CollisionScene scene = world.Scene(BroadPhaseKind.DynamicTree);
        for (int i = 0; i < 400; i++)
        {
            int a = world.Rng.Below(40), b = (a + 1 + world.Rng.Below(39)) % 40;
            DistanceResult expected = ConvexQuery.Distance(
                scene.GetShape(a), scene.GetPose(a), scene.GetShape(b), scene.GetPose(b));
            Assert.Equal(ResultBits.Of(expected), ResultBits.Of(scene.Distance(a, b)));
            scene.Move(a, world.Poses[b]);
        }
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void EmptyAndLonelyScenesFindNothing(BroadPhaseKind kind)
    {
        var scene = new CollisionScene(kind);
        Assert.Empty(Overlaps(scene));
        scene.Add(Ball, RigidPose.Identity);
        Assert.Empty(Overlaps(scene));
        Assert.False(scene.TryFindNearest(0, out PairDistance nearest));
        Assert.Equal(-1, nearest.Pair.B);
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void TheNearestIsFoundAcrossTheWholeRange(BroadPhaseKind kind)
    {
        var scene = new CollisionScene(kind);
        scene.Add(ConvexShape.Point(), new RigidPose(new Vector3(-3e38f, 0, 0)));
        scene.Add(ConvexShape.Point(), new RigidPose(new Vector3(-1e38f, 0, 0)));
        Assert.True(scene.TryFindNearest(0, out PairDistance nearest));
        Assert.Equal((1, (float)((double)3e38f - 1e38f)), (nearest.Pair.B, nearest.Distance));
    }

    private static void CheckObjects(CollisionScene scene, SortedDictionary<int, Vector3> there)
    {
        Assert.Equal(there.Count, scene.Count);
        foreach ((int id, Vector3 position) in there) Assert.Equal(position, scene.GetPose(id).Position);
        ObjectPair[] expected =
        [
            .. from a in there
               from b in there
               where a.Key < b.Key
               where ConvexQuery.Overlaps(Ball, new RigidPose(a.Value), Ball, new RigidPose(b.Value))
               select new ObjectPair(a.Key, b.Key)
        ];
        Assert.Equal(expected, Overlaps(scene));
    }

    internal static CollisionScene Row(BroadPhaseKind kind, params float[] places)
    {
        var scene = new CollisionScene(kind);
        foreach (float x in places) scene.Add(Ball, new RigidPose(At(x)));
        return scene;
    }

    internal static List<ObjectPair> Overlaps(CollisionScene scene)
    {
        List<ObjectPair> results = [];
        scene.FindOverlaps(results);
        return results;
    }

    private static Vector3 At(float x) => new(x, 0, 0);
}
