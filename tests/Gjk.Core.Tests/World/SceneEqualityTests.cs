namespace Gjk.Core.Tests.World;

/// <summary>A scene's answers are those of asking every pair, and the same bits for every broad phase and number of
/// threads.</summary>
public class SceneEqualityTests
{
    private static readonly string[] Kinds = [.. Generators.AllKinds.Where(k => k != "point")];

    [Fact]
    public void OverlapsAreThoseOfAllPairsInMovingScenes()
    {
        using var workers = new Workers(3);
        int touched = 0, objects = 0;
        for (int seed = 0; seed < Budget.Count(3); seed++)
        {
            var world = new MovingWorld((ulong)seed, 120, Kinds);
            CollisionScene[] scenes = [.. Scenes(world)];
            List<ObjectPair> found = [];
            for (int frame = 0; frame < 12; frame++)
            {
                Change(world, scenes, frame);
                List<ObjectPair> expected = world.AllOverlaps(scenes[0].Contains);
                touched += MovingWorld.Touched(expected);
                objects += scenes[0].Count;
                foreach (CollisionScene scene in scenes)
                {
                    // The first one of a frame asks, the second one keeps the answers.
                    foreach (bool isParallel in new[] { frame % 2 == 0, frame % 2 != 0 })
                    {
                        scene.FindOverlaps(found, isParallel ? workers : null);
                        Assert.True(
                            expected.SequenceEqual(found), $"seed {seed}, frame {frame}, in parallel: {isParallel}");
                    }
                }
            }
        }

        Assert.InRange((double)touched / objects, 0.3, 0.7);
    }

    [Fact]
    public void DistancesAreThoseOfAllPairsInMovingScenes()
    {
        using var workers = new Workers(2);
        for (int seed = 0; seed < Budget.Count(2); seed++)
        {
            var world = new MovingWorld((ulong)(50 + seed), 60, Kinds);
            CollisionScene[] serial = [.. Scenes(world)], parallel = [.. Scenes(world)];
            List<PairDistance> first = [], found = [];
            for (int frame = 0; frame < 12; frame++)
            {
                Change(world, [.. serial, .. parallel], frame);
                float distance = frame % 6 == 5 ? float.PositiveInfinity : 0.25f * (frame % 3);
                serial[0].FindPairsWithin(distance, first);
                CheckAgainstColdQueries(world, serial[0], distance, first, $"seed {seed}, frame {frame}");
                foreach (CollisionScene scene in serial)
                {
                    if (scene == serial[0]) continue;
                    scene.FindPairsWithin(distance, found);
                    SameBits(first, found, $"seed {seed}, frame {frame}");
                }

                for (int i = 0; i < parallel.Length; i++)
                {
                    parallel[i].FindPairsWithin(distance, found, workers);
                    SameBits(
                        first, found,
                        $"seed {seed}, frame {frame}, two threads");
                }
            }
        }
    }

    [Fact]
    public void TheNearestIsThatOfAllPairs()
    {
        var world = new MovingWorld(7, 80, Kinds);
        // Sparse, so that most have a nearest one at a distance; a twin for some, so that there are ties.
        for (int i = 0; i < 80; i++)
            world.Poses[i] = new RigidPose(world.Poses[i].Rotation, world.Poses[i].Position * 3);
        for (int i = 0; i < 10; i++)
        {
            int twin = world.Add();
            (world.Shapes[twin], world.Poses[twin]) = (world.Shapes[i], world.Poses[i]);
        }

        int apart = 0;
        foreach (CollisionScene scene in Scenes(world))
        {
            scene.Remove(33);
            for (int a = 0; a < world.Count; a++)
            {
                if (a == 33) continue;
                (float Distance, int Id) expected = Enumerable.Range(0, world.Count).Where(b => b != a && b != 33)
                    .Select(b => (DistanceOf(world, a, b), b)).Min();
                Assert.True(scene.TryFindNearest(a, out PairDistance nearest));
                (int other, DistanceResult result) = (nearest.Pair.B, nearest.Result);
                Assert.True(
                    expected == (result.Distance, other),
                    $"object {a}: {result.Distance:R} to {other}, not {expected}");
                DistanceResult cold = ConvexQuery.Distance(
                    world.Shapes[a], world.Poses[a], world.Shapes[other], world.Poses[other]);
                Assert.Equal(ResultBits.Of(cold), ResultBits.Of(result));
                if (result.Distance > 0) apart++;
            }
        }

        Assert.InRange(apart / (2.0 * 89), 0.6, 0.99);
    }

    private static IEnumerable<CollisionScene> Scenes(MovingWorld world) =>
        from kind in Enum.GetValues<BroadPhaseKind>()
        select world.Scene(kind);

    /// <summary>The same to all scenes: most objects move, some go, some come; every fourth frame is at rest.</summary>
    private static void Change(MovingWorld world, CollisionScene[] scenes, int frame)
    {
        if (frame % 4 == 3) return;
        for (int i = 0; i < world.Count; i++)
        {
            if (!scenes[0].Contains(i)) continue;
            world.Step(i);
            if (world.Rng.Below(40) == 0)
            {
                foreach (CollisionScene scene in scenes) scene.Remove(i);
                continue;
            }

            foreach (CollisionScene scene in scenes) scene.Move(i, world.Poses[i]);
        }

        for (int i = world.Rng.Below(5); i > 0; i--)
        {
            int id = world.Add();
            foreach (CollisionScene scene in scenes) Assert.Equal(id, scene.Add(world.Shapes[id], world.Poses[id]));
        }
    }

    private static void CheckAgainstColdQueries(
        MovingWorld world, CollisionScene scene, float distance, List<PairDistance> found, string message)
    {
        Dictionary<ObjectPair, DistanceResult> byPair = found.ToDictionary(p => p.Pair, p => p.Result);
        Assert.True(found.Select(p => p.Pair).SequenceEqual(byPair.Keys.Order()), message);
        for (int a = 0; a < world.Count; a++)
        {
            for (int b = a + 1; b < world.Count; b++)
            {
                if (!scene.Contains(a) || !scene.Contains(b)) continue;
                DistanceResult cold = ConvexQuery.Distance(
                    world.Shapes[a], world.Poses[a], world.Shapes[b], world.Poses[b], distance);
                bool isThere = byPair.TryGetValue(new ObjectPair(a, b), out DistanceResult warm);
                // The accuracy of a distance between curved shapes, which a limit may fall into.
                bool clear = cold.Status != GjkStatus.BeyondMaxDistance || cold.LowerBound > distance + 1e-5f;
                if (clear)
                {
                    Assert.True(
                        isThere == (cold.Status != GjkStatus.BeyondMaxDistance), $"{message}: {a}, {b}, {cold.Status}");
                }
                if (isThere && clear)
                {
                    Assert.True(
                        Math.Abs(warm.Distance - cold.Distance) <= 1e-5f,
                        $"{message}: {a}, {b}, {warm.Distance:R}, cold {cold.Distance:R}");
                }
            }
        }
    }

    private static void SameBits(List<PairDistance> expected, List<PairDistance> found, string message)
    {
        Assert.True(expected.Select(p => p.Pair).SequenceEqual(found.Select(p => p.Pair)), message);
        Assert.True(Hashes(expected).SequenceEqual(Hashes(found)), message);
    }

    private static float DistanceOf(MovingWorld world, int a, int b) =>
        ConvexQuery.Distance(world.Shapes[a], world.Poses[a], world.Shapes[b], world.Poses[b]).Distance;

    private static IEnumerable<string> Hashes(List<PairDistance> pairs) =>
        pairs.Select(p => $"{p.Pair} {ResultBits.Of(p.Result)}");
}
