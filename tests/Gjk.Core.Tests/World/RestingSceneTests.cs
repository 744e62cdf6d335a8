namespace Gjk.Core.Tests.World;

/// <summary>A pair whose objects have not moved keeps its answer; one that moved is asked again.</summary>
public class RestingSceneTests
{
    private const int Objects = 80;

    private const float Reach = 0.3f;

    [Theory]
    [InlineData(BroadPhaseKind.SortAndSweep, 0)]
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
        CollisionScene scene = Made(new Rng(9), BroadPhaseKind.SortAndSweep);
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

    /// <summary>Each finder asks about a pair at rest once, and then about those of what has moved.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(0.1f)]
    public void OverlapsAndContactsAskOnlyWhatHasMoved(float gap)
    {
        int[] calls = [0];
        var scene = new CollisionScene();
        var rng = new Rng(11);
        for (int i = 0; i < Objects; i++)
        {
            var counted = new SupportCounter(Generators.Shape(rng, "hull").Shape, calls);
            scene.Add(ConvexShape.Custom(counted), Generators.Pose(rng, rng.Vector(-1.5, 1.5)));
        }

        List<ObjectPair> pairs = [];
        List<PairContacts> contacts = [];
        Action[] finders = [() => scene.FindOverlaps(pairs), () => scene.FindContacts(gap, contacts)];
        foreach (Action find in finders)
        {
            calls[0] = 0;
            find();
            int all = calls[0];
            Assert.InRange(all, Objects, int.MaxValue);

            // New objects have moved, as it were, so the second frame is the first that others are compared with.
            find();
            calls[0] = 0;
            find();
            Assert.Equal(0, calls[0]);
            scene.Move(7, Generators.Pose(rng, default));
            find();
            Assert.InRange(calls[0], 1, all / 3);
        }
    }

    /// <summary>A search for depths leaves out whether surfaces overlap; a search for overlaps behind it does
    /// not.</summary>
    [Fact]
    public void FindersThatShareAnswersDoNotMissEachOthers()
    {
        CollisionScene scene = Made(new Rng(3), BroadPhaseKind.DynamicTree), fresh = Made(new Rng(3), default);
        foreach (CollisionScene one in new[] { scene, fresh })
            one.Add(AnyShape.Surface(ConcaveShapes.Grid(4)), RigidPose.Identity);
        List<ObjectPair> expected = [], found = [];
        fresh.FindOverlaps(expected);
        Assert.Contains(expected, pair => pair.B == Objects);
        for (int i = 0; i < 3; i++)
        {
            scene.FindDepths([]);
            scene.FindContacts(0.05f, []);
            scene.FindOverlaps(found);
            Assert.Equal(expected, found);
            scene.CollectCandidates(found);
            found.Reverse();
            List<ObjectPair> reversed = [];
            scene.FindOverlapsAmong(found, reversed);
            reversed.Reverse();
            Assert.Equal(expected, reversed);
        }
    }

    [Theory]
    [InlineData(BroadPhaseKind.SortAndSweep, 0)]
    [InlineData(BroadPhaseKind.DynamicTree, 2)]
    public void KeptDepthsAndContactsAreThoseOfAskingAnew(BroadPhaseKind phase, int threads)
    {
        using Workers? workers = threads > 0 ? new Workers(threads) : null;
        var rng = new Rng(14);
        CollisionScene scene = Made(rng, phase);
        List<PairDistance> depths = [];
        List<PairContacts> contacts = [];
        int next = Objects, oldest = 0;
        for (int frame = 0; frame < 30; frame++)
        {
            for (int k = rng.Below(4); k > 0; k--)
                scene.Move(oldest + rng.Below(next - oldest), Generators.Pose(rng, rng.Vector(-1.5, 1.5)));
            if (frame % 4 == 3)
            {
                scene.Remove(oldest++);
                next = 1 + scene.Add(Generators.Shape(rng, "hull").Shape, Generators.Pose(rng, rng.Vector(-1.5, 1.5)));
            }

            float gap = frame % 5 == 4 ? 0 : 0.05f;
            if (frame % 3 != 2) scene.FindDepths(depths, workers);
            scene.FindContacts(gap, contacts, workers);
            if (frame % 3 != 2) foreach (PairDistance p in depths) CheckDepth(scene, p);
            foreach (PairContacts p in contacts) CheckContacts(scene, p, gap);
        }
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void AnswersAreKeptFromACompleteFrame(bool isComplete)
    {
        var answers = new PairAnswers<int>();
        int[] ids = [3, 5, 9];
        long calls = 4;
        answers.BeginFrame([new(0, 1), new(0, 2), new(1, 2)], ids, ref calls);
        Assert.Equal((5, 0), (calls, answers.LastCall));
        for (int i = 0; i < 3; i++) answers[i] = 10 + i;
        if (isComplete) answers.CompleteFrame();
        calls = 7;
        answers.BeginFrame([new(0, 2), new(1, 2)], ids, ref calls);
        Assert.Equal((8, 5), (calls, answers.LastCall));
        int last = answers.Seek(1);
        Assert.Equal(isComplete, answers.TryKeep(1, ref last));
        if (isComplete) Assert.Equal(12, answers[1]);
        Assert.Equal(2, answers.Count);
    }

    private static void CheckDepth(CollisionScene scene, in PairDistance p) =>
        Assert.True(ResultBits.AreSame(
            p.Result,
            ConvexQuery.SignedDistance(
                scene.GetShape(p.Pair.A), scene.GetPose(p.Pair.A), scene.GetShape(p.Pair.B), scene.GetPose(p.Pair.B))));

    private static void CheckContacts(CollisionScene scene, in PairContacts p, float gap)
    {
        ContactManifold manifold = default;
        DistanceResult alone = ConvexQuery.Contacts(
            scene.GetShape(p.Pair.A), scene.GetPose(p.Pair.A), scene.GetShape(p.Pair.B),
            scene.GetPose(p.Pair.B), gap, out manifold);
        Assert.True(ResultBits.AreSame(p.Result, alone));
        Assert.Equal(manifold, p.Manifold);
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
