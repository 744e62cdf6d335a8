namespace Gjk.Core.Tests.Regression;

/// <summary>A pair that one broad phase took for near and another did not kept a warm start from frames in which it was
/// further apart than asked, so that its first distance had other bits in the one scene than in the other.</summary>
public class CandidateBitsTests
{
    private const int Frames = 50;
    private const int Objects = 90;

    private static readonly string[] Kinds = [.. Generators.AllKinds, "bigHull"];

    public static TheoryData<float> Distances => [0, 0.05f, 0.4f, 3, -1];

    /// <summary>Every field, for every broad phase, tight and generous, on one thread and on four.</summary>
    /// <param name="distance">As it is asked in every frame; -1 for another one in each.</param>
    [Theory]
    [MemberData(nameof(Distances))]
    public void BroadPhasesAndThreadsGiveTheSameBits(float distance)
    {
        using var workers = new Workers(4);
        var world = new MovingWorld(77, Objects, Kinds);
        (CollisionScene Scene, Workers? Workers)[] scenes =
        [
            .. from threads in new[] { null, workers }
               from phase in new IBroadPhase[] { new SortAndSweep(), new DynamicAabbTree(), new Generous() }
               select (world.Scene(phase), threads),
        ];
        List<PairDistance> expected = [], found = [];
        List<ObjectPair> candidates = [];
        HashSet<ObjectPair> near = [];
        int entered = 0, candidatesBeyond = 0;
        for (int frame = 0; frame < Frames; frame++)
        {
            Move(world, scenes);
            float asked = distance >= 0 ? distance : 0.4f * (frame % 4);
            scenes[0].Scene.FindPairsWithin(asked, expected);
            foreach ((CollisionScene scene, Workers? threads) in scenes.Skip(1))
            {
                scene.FindPairsWithin(asked, found, threads);
                string message = $"frame {frame}, distance {asked}";
                SameBits(expected, found, $"{message}, {threads?.ThreadCount ?? 1} threads");
                scene.CollectCandidates(candidates, asked);
                candidatesBeyond += candidates.Count - found.Count;
            }

            entered += expected.Count(p => !near.Contains(p.Pair));
            near = [.. expected.Select(p => p.Pair)];
        }

        // What went wrong needs pairs that were candidates for a while before they came near.
        Assert.True(entered > 100 && candidatesBeyond > 1000, $"{entered} entered, {candidatesBeyond} were beyond");
    }

    /// <summary>Pairs that come exactly to the distance: whether they are reported must not depend on whether they were
    /// looked at before, while they were further apart.</summary>
    [Fact]
    public void PairsThatComeExactlyToTheDistanceAreReportedAlike()
    {
        var rng = new Rng(3);
        ConvexShape[] curved = [ConvexShape.Cylinder(1, 1), ConvexShape.Ellipsoid(new Vector3(1, 2, 1))];
        CollisionScene[] scenes = [new(), new(new Generous())];
        const int Pairs = 300;
        List<PairDistance> expected = [], found = [];
        int reported = 0;
        for (int frame = 0; frame < 20; frame++)
        {
            for (int i = 0; i < Pairs; i++)
            {
                // A ball 1 away from the round side, to 1e-10; or a little further, and not straight beside it.
                float x = MathF.BitDecrement(2.5f);
                double z = Math.Sqrt(6.25 - (double)x * x) * (1 + rng.Range(-1e-4, 1e-4));
                var place = new Vector3(x, 100 * i, (float)z);
                if (frame % 2 == 0) place += new Vector3(0.3f, 0.2f, 0.2f) * rng.Vector(0.5, 1);
                foreach (CollisionScene scene in scenes)
                {
                    if (frame > 0)
                    {
                        scene.Move(2 * i + 1, new RigidPose(place));
                        continue;
                    }

                    scene.Add(curved[i % curved.Length], new RigidPose(new Vector3(0, 100 * i, 0)));
                    scene.Add(ConvexShape.Sphere(0.5f), new RigidPose(place));
                }
            }

            scenes[0].FindPairsWithin(1, expected);
            scenes[1].FindPairsWithin(1, found);
            SameBits(expected, found, $"frame {frame}");
            reported += expected.Count;
            if (frame % 2 == 0) Assert.Equal((0, Pairs), (Candidates(scenes[0]), Candidates(scenes[1])));
        }

        Assert.True(reported > 10 * Pairs / 3, $"{reported} reported");
    }

    private static int Candidates(CollisionScene scene)
    {
        List<ObjectPair> candidates = [];
        scene.CollectCandidates(candidates, 1);
        return candidates.Count;
    }

    private static void Move(MovingWorld world, (CollisionScene Scene, Workers? Workers)[] scenes)
    {
        for (int i = 0; i < world.Count; i++)
        {
            world.Step(i);
            foreach ((CollisionScene scene, _) in scenes) scene.Move(i, world.Poses[i]);
        }
    }

    private static void SameBits(List<PairDistance> expected, List<PairDistance> found, string message)
    {
        Assert.True(expected.Select(p => p.Pair).SequenceEqual(found.Select(p => p.Pair)), message);
        for (int i = 0; i < expected.Count; i++)
        {
            DistanceResult a = expected[i].Result, b = found[i].Result;
            string differ = $"{a.Distance:R} in {a.Iterations}, {b.Distance:R} in {b.Iterations}";
            Assert.True(Fields(a).SequenceEqual(Fields(b)), $"{message}, pair {expected[i].Pair}: {differ}");
        }
    }

    /// <summary>All fields of a result as bits.</summary>
    private static IEnumerable<int> Fields(DistanceResult r) =>
    [
        (int)r.Status, r.Iterations, Bits(r.Distance), Bits(r.LowerBound),
        .. Bits(r.PointA), .. Bits(r.PointB), .. Bits(r.Normal), .. Bits(r.LocalPointA), .. Bits(r.LocalPointB),
    ];

    private static IEnumerable<int> Bits(Vector3 v) => [Bits(v.X), Bits(v.Y), Bits(v.Z)];

    private static int Bits(float x) => BitConverter.SingleToInt32Bits(x);

    /// <summary>Finds pairs whose boxes are further apart than it is asked for, too.</summary>
    private sealed class Generous : IBroadPhase
    {
        private readonly SortAndSweep _inner = new();

        public int Count => _inner.Count;

        public void Add(int id, in Aabb bounds) => _inner.Add(id, Grown(bounds));

        public void Move(int id, in Aabb bounds) => _inner.Move(id, Grown(bounds));

        public void Remove(int id) => _inner.Remove(id);

        public void Clear() => _inner.Clear();

        public void CollectPairs(float margin, List<ObjectPair> pairs) => _inner.CollectPairs(margin, pairs);

        public void CollectInBox(in Aabb box, List<int> ids) => _inner.CollectInBox(box, ids);

        public void Sweep<TVisitor>(in SweptBox path, ref TVisitor visitor)
            where TVisitor : struct, ISweepVisitor => _inner.Sweep(path, ref visitor);

        private static Aabb Grown(in Aabb box) => new(box.Min - Vector3.One / 4, box.Max + Vector3.One / 4);
    }
}
