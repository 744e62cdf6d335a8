namespace Gjk.Core.Tests.World;

/// <summary>A scene that holds surfaces, solids and compounds says what <see cref="ConcaveQuery"/> says of each pair,
/// with the same bits for every broad phase and number of threads.</summary>
public class ConcaveSceneTests
{
    private const float Reach = 0.1f;
    private readonly ConcaveScratch _scratch = new();

    [Fact]
    public void TheFindersSayWhatTheQueriesSayOfAllPairs()
    {
        using var workers = new Workers(3);
        int met = 0;
        for (int seed = 0; seed < 3; seed++)
        {
            var world = new Crowd((ulong)seed, 24);
            CollisionScene[] scenes = [.. Enum.GetValues<BroadPhaseKind>().Select(world.Scene)];
            for (int frame = 0; frame < 4; frame++)
            {
                if (frame > 0) world.Move(scenes);
                string[] overlaps = [.. world.Overlaps(_scratch)], distances = [.. world.Distances(_scratch)];
                string[] depths = [.. world.Depths(_scratch)], contacts = [.. world.Contacts(_scratch)];
                met += contacts.Length;
                foreach (CollisionScene scene in scenes)
                {
                    foreach (Workers? threads in new[] { null, workers })
                    {
                        Assert.Equal(overlaps, Texts<ObjectPair>(found => scene.FindOverlaps(found, threads)));
                        Assert.Equal(
                            distances, Texts<PairDistance>(
                                found => scene.FindPairsWithin(Reach, found, threads), world.Near));
                        Assert.Equal(
                            depths, Texts<PairDistance>(found => scene.FindDepths(found, threads), Crowd.Text));
                        Assert.Equal(
                            contacts,
                            Texts<PairContacts>(found => scene.FindContacts(Reach, found, threads), Crowd.Text));
                    }
                }
            }
        }

        Assert.InRange(met, 100, 1_000_000);
    }

    [Fact]
    public void RaysCastsAndTheNearestNameTheParts()
    {
        var world = new Crowd(9, 30);
        CollisionScene scene = world.Scene(BroadPhaseKind.DynamicTree);
        var random = new Rng(5);
        int hits = 0, parts = 0;
        for (int i = 0; i < 60; i++)
        {
            Vector3 from = random.Vector(2.5), way = random.Vector(0.5) - from;
            var ray = new RayQuery(from, way, 20);
            RayHit[] rays = [.. world.Shapes.Select((s, k) => ConcaveQuery.RayCast(
                s, world.Poses[k], from, way, _scratch, 20))];
            int first = world.Least(k => rays[k].Result.MayHit ? rays[k].Distance : float.NaN);
            Assert.Equal(first >= 0, scene.TryFindRayHit(ray, out RayHit hit));
            Assert.Equal(first, hit.Id);
            if (first >= 0) Assert.Equal((rays[first].Part, rays[first].Distance), (hit.Part, hit.Result.Distance));
            List<RayHit> all = [];
            scene.FindRayHits(ray, all);
            Assert.Equal(rays.Count(r => r.Result.MayHit), all.Count);
            Assert.All(all, one => Assert.Equal(rays[one.Id].Part, one.Part));

            var ball = ConvexShape.Sphere(0.1f);
            var at = new RigidPose(from);
            CastHit[] casts = [.. world.Shapes.Select((s, k) => ConcaveQuery.Cast(
                AnyShape.Of(ball), at, way, s, world.Poses[k], default, _scratch))];
            int met = world.Least(k => casts[k].Result.MayHit ? casts[k].Fraction : float.NaN);
            Assert.Equal(met >= 0, scene.TryFindCastHit(ball, at, way, out CastHit cast));
            Assert.Equal(met, cast.Id);
            if (met >= 0) Assert.Equal((casts[met].PartB, casts[met].Fraction), (cast.PartB, cast.Result.Fraction));

            PairDistance[] gaps = [.. world.Shapes.Select((s, k) => ConcaveQuery.Distance(
                AnyShape.Of(ball), at, s, world.Poses[k], _scratch))];
            int near = world.Least(k => gaps[k].Distance);
            Assert.True(scene.TryFindNearest(ball, at, out PairDistance nearest));
            Assert.Equal((near, gaps[near].Distance), (nearest.Pair.B, nearest.Result.Distance));
            List<int> touching = [];
            scene.FindObjectsOverlapping(ball, at, touching);
            Assert.Equal(Enumerable.Range(0, world.Count).Where(k => gaps[k].IsOverlapping), touching);
            if (hit.Id >= 0) hits++;
            if (hit.Part >= 0 || cast.PartB >= 0 || nearest.PartB >= 0) parts++;
        }

        Assert.InRange(hits, 20, 60);
        Assert.InRange(parts, 20, 60);
        for (int id = 0; id < world.Count; id++)
        {
            int other = world.Least(k => k == id ? float.NaN : world.Distance(id, k, _scratch).Distance);
            Assert.True(scene.TryFindNearest(id, out PairDistance nearest));
            Assert.Equal(world.Distance(id, other, _scratch).Distance, nearest.Result.Distance);
            Assert.Equal(other, nearest.Pair.B);
            Assert.Equal(world.Distance(id, other, _scratch).Distance, scene.Distance(id, other).Distance);
        }
    }

    [Fact]
    public void AWarmFrameAllocatesNothing()
    {
        var world = new Crowd(2, 20);
        CollisionScene scene = world.Scene(BroadPhaseKind.DynamicTree);
        List<PairContacts> contacts = [];
        List<PairDistance> distances = [];
        List<ObjectPair> overlaps = [];
        RigidPose[] poses = [.. world.Poses];
        int frame = 0;
        long least = Allocation.Least(() =>
        {
            for (int i = 0; i < 8; i++)
            {
                // There and back again, so that the same pairs come and go.
                frame++;
                for (int id = 0; id < poses.Length; id++)
                {
                    var shift = new Vector3(frame % 2 * 0.01f);
                    scene.Move(id, new RigidPose(poses[id].Rotation, poses[id].Position + shift));
                }

                scene.FindOverlaps(overlaps);
                scene.FindPairsWithin(Reach, distances);
                scene.FindContacts(Reach, contacts);
                scene.FindDepths(distances);
                scene.TryFindRayHit(new RayQuery(Vector3.One, -Vector3.One, 10), out RayHit _);
            }
        });
        Assert.Equal(0, least);
        Assert.NotEmpty(contacts);
    }

    [Fact]
    public void StaticSurfacesAreNotTestedAgainstEachOther()
    {
        AnyShape ground = AnyShape.Surface(ConcaveShapes.Grid(4));
        var scene = new CollisionScene();
        int plain = scene.Add(ConvexShape.Sphere(0.1f), new RigidPose(new Vector3(0.2f, 0.05f, 0)));
        List<PairDistance> before = [];
        scene.FindPairsWithin(1, before);
        var isStatic = new ObjectSettings(isStatic: true);
        int first = scene.Add(ground, RigidPose.Identity, isStatic);
        int second = scene.Add(ground, RigidPose.Identity, isStatic);
        List<PairContacts> contacts = [];
        scene.FindContacts(0, contacts);
        ObjectPair[] both = [new(plain, first), new(plain, second)];
        Assert.Equal(both, contacts.Select(c => c.Pair).Distinct());
        Assert.All(contacts, c => Assert.True(c is { PartA: -1, PartB: >= 0 } && c.Manifold.Normal.Y < -0.999f));
        scene.Remove(first);
        Assert.Equal(AnyShapeKind.Surface, scene.GetAnyShape(second).Kind);
        Assert.Equal(AnyShapeKind.Convex, scene.GetAnyShape(plain).Kind);
        scene.FindContacts(0, contacts);
        Assert.Equal([new ObjectPair(plain, second)], contacts.Select(c => c.Pair).Distinct());
        for (int i = 0; i < 40; i++) scene.Remove(scene.Add(ground, RigidPose.Identity));
        scene.FindContacts(0, contacts);
        Assert.Equal([new ObjectPair(plain, second)], contacts.Select(c => c.Pair).Distinct());
        Assert.Throws<ArgumentException>(() => scene.Add(default(AnyShape), RigidPose.Identity));
    }

    private static string[] Texts<T>(Action<List<T>> find, Func<T, string>? text = null)
    {
        List<T> found = [];
        find(found);
        return [.. found.Select(one => text is null ? one!.ToString()! : text(one))];
    }

    /// <summary>Shapes of all kinds, and what single queries say of their pairs.</summary>
    private sealed class Crowd
    {
        private readonly Rng _random;

        public Crowd(ulong seed, int count)
        {
            _random = new Rng(seed);
            for (int i = 0; i < count; i++)
            {
                Shapes.Add(
                    i % 3 == 0 ? AnyShape.Of(ConvexShape.Box(new Vector3(0.2f, 0.3f, 0.1f)))
                    : i % 7 == 1 ? AnyShape.Solid(ConcaveShapes.Box(new Vector3(0.3f)))
                    : ConcaveShapes.Any(_random));
                Poses.Add(ConcaveShapes.Pose(_random, 2.2));
            }
        }

        public List<AnyShape> Shapes { get; } = [];

        public List<RigidPose> Poses { get; } = [];

        public int Count => Shapes.Count;

        public CollisionScene Scene(BroadPhaseKind kind)
        {
            var scene = new CollisionScene(kind);
            for (int i = 0; i < Count; i++) Assert.Equal(i, scene.Add(Shapes[i], Poses[i]));
            return scene;
        }

        /// <summary>Half of all objects move on; the others rest.</summary>
        public void Move(CollisionScene[] scenes)
        {
            for (int i = 0; i < Count; i++)
            {
                if (_random.OneIn(2)) continue;
                Poses[i] = new RigidPose(Poses[i].Rotation, Poses[i].Position + _random.Vector(0.1));
                foreach (CollisionScene scene in scenes) scene.Move(i, Poses[i]);
            }
        }

        public PairDistance Distance(int a, int b, ConcaveScratch scratch) =>
            ConcaveQuery.Distance(Shapes[a], Poses[a], Shapes[b], Poses[b], scratch);

        /// <summary>The first with the least value; NaN does not count.</summary>
        public int Least(Func<int, float> value)
        {
            int least = -1;
            for (int k = 0; k < Count; k++)
                if (!float.IsNaN(value(k)) && (least < 0 || value(k) < value(least))) least = k;
            return least;
        }

        public IEnumerable<string> Overlaps(ConcaveScratch scratch) =>
            from p in Pairs where Distance(p.A, p.B, scratch).IsOverlapping select p.ToString();

        public IEnumerable<string> Distances(ConcaveScratch scratch) =>
            from p in Pairs
            let found = ConcaveQuery.Distance(Shapes[p.A], Poses[p.A], Shapes[p.B], Poses[p.B], scratch, Reach)
            where found.Status != GjkStatus.BeyondMaxDistance
            select Near(found.WithPair(p));

        /// <summary>Distances of convex pairs begin where the last ended, so that their last bits may differ.</summary>
        public string Near(PairDistance d) => AreConvex(d.Pair) ? $"{d.Pair} is near" : Text(d);

        public IEnumerable<string> Depths(ConcaveScratch scratch)
        {
            List<PairDistance> parts = [];
            foreach (ObjectPair p in Pairs)
            {
                ConcaveQuery.FindDepths(Shapes[p.A], Poses[p.A], Shapes[p.B], Poses[p.B], scratch, parts);
                foreach (PairDistance one in parts)
                    yield return Text(one.WithPair(p));
            }
        }

        public IEnumerable<string> Contacts(ConcaveScratch scratch)
        {
            List<PairContacts> parts = [];
            foreach (ObjectPair p in Pairs)
            {
                ConcaveQuery.FindContacts(Shapes[p.A], Poses[p.A], Shapes[p.B], Poses[p.B], Reach, scratch, parts);
                foreach (PairContacts one in parts)
                    yield return Text(one.WithPair(p));
            }
        }

        public static string Text(PairContacts c)
        {
            IEnumerable<ManifoldPoint> points = Enumerable.Range(0, c.Manifold.Count).Select(i => c.Manifold[i]);
            return $"{c} {c.PartA} {c.PartB} {string.Join(", ", points)}";
        }

        public static string Text(PairDistance d) => $"{d} {d.PartA} {d.PartB} {d.Result.LowerBound:R}";

        private IEnumerable<ObjectPair> Pairs =>
            from a in Enumerable.Range(0, Count)
            from b in Enumerable.Range(a + 1, Count - a - 1)
            select new ObjectPair(a, b);

        private bool AreConvex(ObjectPair p) =>
            Shapes[p.A].Kind == AnyShapeKind.Convex && Shapes[p.B].Kind == AnyShapeKind.Convex;
    }
}
