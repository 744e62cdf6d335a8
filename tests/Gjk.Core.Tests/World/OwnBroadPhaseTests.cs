namespace Gjk.Core.Tests.World;

/// <summary>A scene with a broad phase of the caller's, filters of his, and the ids of what is in it.</summary>
public class OwnBroadPhaseTests
{
    [Fact]
    public void ASceneUsesTheBroadPhaseThatItIsGiven()
    {
        var rng = new Rng(21);
        var own = new AllBoxes();
        CollisionScene scene = new(own), expected = new();
        for (int i = 0; i < 200; i++)
        {
            var pose = new RigidPose(rng.Rotation(), rng.Vector(-4, 4));
            scene.Add(ConvexShape.Box(new Vector3(0.5f)), pose);
            expected.Add(ConvexShape.Box(new Vector3(0.5f)), pose);
        }

        List<PairDistance> pairs = [], all = [];
        scene.FindPairsWithin(0.2f, pairs);
        expected.FindPairsWithin(0.2f, all);
        Assert.True(all.Count > 100);
        Assert.Equal(all.Select(p => (p.Pair, p.Result.Distance)), pairs.Select(p => (p.Pair, p.Result.Distance)));
        List<RayHit> hits = [], allHits = [];
        var ray = new RayQuery(new Vector3(-9, 0.1f, 0.2f), Vector3.UnitX);
        scene.FindRayHits(ray, hits);
        expected.FindRayHits(ray, allHits);
        Assert.True(allHits.Count > 2);
        Assert.Equal(allHits.Select(h => h.Id), hits.Select(h => h.Id));
        Assert.True(own.Calls > 1);
    }

    [Fact]
    public void ABroadPhaseInUseIsRefused()
    {
        var used = new DynamicAabbTree();
        used.Add(0, new Aabb(Vector3.Zero, Vector3.One));
        Assert.Equal("broadPhase", Assert.Throws<ArgumentException>(() => new CollisionScene(used)).ParamName);
        Assert.Equal("broadPhase", Assert.Throws<ArgumentNullException>(() => new CollisionScene(null!)).ParamName);
    }

    [Fact]
    public void AFilterMayAskTheCaller()
    {
        CollisionScene scene = CollisionSceneTests.Row(BroadPhaseKind.DynamicTree, 0, 2, 4, 6);
        List<RayHit> hits = [];
        var filter = new QueryFilter(ignoredId: 3, sees: id => id != 1);
        scene.FindRayHits(new RayQuery(new Vector3(-5, 0, 0), Vector3.UnitX), hits, filter);
        Assert.Equal([0, 2], hits.Select(h => h.Id));
        Assert.NotEqual(filter, new QueryFilter(ignoredId: 3));
        var own = new InvalidOperationException("own");
        var thrower = new QueryFilter(sees: _ => throw own);
        List<int> ids = [];
        Assert.Same(
            own,
            Assert.Throws<InvalidOperationException>(
                () => scene.FindObjectsOverlapping(ConvexShape.Sphere(9), RigidPose.Identity, ids, thrower)));
    }

    [Fact]
    public void TheIdsAreThoseOfTheObjectsThatAreThere()
    {
        CollisionScene scene = CollisionSceneTests.Row(BroadPhaseKind.DynamicTree, 0, 2, 4, 6);
        scene.Remove(1);
        List<int> ids = [7];
        scene.CollectIds(ids);
        Assert.Equal([0, 2, 3], ids);
        Assert.Throws<ArgumentNullException>(() => scene.CollectIds(null!));
    }

    /// <summary>Looks at all boxes.</summary>
    private sealed class AllBoxes : IBroadPhase
    {
        private readonly SortedDictionary<int, Aabb> _boxes = [];

        public int Calls { get; private set; }

        public int Count => _boxes.Count;

        public void Add(int id, in Aabb bounds) => _boxes.Add(id, bounds);

        public void Move(int id, in Aabb bounds) => _boxes[id] = bounds;

        public void Remove(int id) => _boxes.Remove(id);

        public void Clear() => _boxes.Clear();

        public void CollectPairs(float margin, List<ObjectPair> pairs)
        {
            Calls++;
            pairs.Clear();
            foreach ((int a, Aabb box) in _boxes)
            {
                var wide = new Aabb(box.Min - new Vector3(2 * margin), box.Max + new Vector3(2 * margin));
                pairs.AddRange(
                    from other in _boxes
                    where other.Key > a && other.Value.Overlaps(wide)
                    select new ObjectPair(a, other.Key));
            }
        }

        public void CollectInBox(in Aabb box, List<int> ids)
        {
            ids.Clear();
            foreach ((int id, Aabb own) in _boxes)
            {
                if (own.Overlaps(box)) ids.Add(id);
            }
        }

        public void Sweep<TVisitor>(in SweptBox path, ref TVisitor visitor)
            where TVisitor : struct, ISweepVisitor
        {
            Calls++;
            double limit = path.Limit;
            foreach ((int id, Aabb own) in _boxes)
            {
                if (path.Meets(own, limit, out _)) limit = visitor.Visit(id);
            }
        }
    }
}
