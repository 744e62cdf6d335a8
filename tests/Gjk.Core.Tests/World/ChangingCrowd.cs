namespace Gjk.Core.Tests.World;

/// <summary>Objects of all kinds that move, go, come and get other shapes, in a scene that is compared with one built
/// anew.</summary>
internal sealed class ChangingCrowd
{
    private const float Reach = 0.15f, Side = 2;

    private readonly BroadPhaseKind _kind;
    private readonly Rng _random;
    private readonly CollisionScene _scene;

    public ChangingCrowd(BroadPhaseKind kind, ulong seed, int count)
    {
        (_kind, _random, _scene) = (kind, new Rng(seed), new CollisionScene(kind));
        for (int i = 0; i < count; i++) Add();
    }

    /// <summary>The objects with other shapes than at the last check.</summary>
    public HashSet<int> Exchanged { get; } = [];

    private List<(AnyShape Shape, RigidPose Pose, ObjectSettings Settings)> Objects { get; } = [];

    /// <summary>Some shapes change; in two of three frames some objects move, one goes and one or two come.</summary>
    public void Change()
    {
        for (int id = 0; id < Objects.Count; id++)
        {
            if (!_scene.Contains(id) || !_random.OneIn(5)) continue;
            AnyShape shape = Shape();
            if (shape.Kind == AnyShapeKind.Convex && _random.OneIn(2)) _scene.SetShape(id, shape.Convex);
            else _scene.SetShape(id, shape);
            Objects[id] = Objects[id] with { Shape = shape };
            Exchanged.Add(id);
        }

        if (_random.OneIn(3)) return;
        for (int id = 0; id < Objects.Count; id++)
        {
            if (!_scene.Contains(id) || _random.OneIn(2)) continue;
            RigidPose pose = Objects[id].Pose;
            pose = new RigidPose(pose.Rotation, pose.Position + _random.Vector(0.1));
            Objects[id] = Objects[id] with { Pose = pose };
            _scene.Move(id, pose);
        }

        int gone = _random.Below(Objects.Count);
        if (_scene.Contains(gone)) _scene.Remove(gone);
        for (int n = _random.Below(3); n > 0; n--) Add();
    }

    /// <summary>Compares all answers with those of a fresh scene.</summary>
    /// <returns>How many things were found.</returns>
    public int Check(string message, Workers? workers)
    {
        CollisionScene fresh = Fresh();
        int found = CheckDistances(fresh, message, workers);
        Exchanged.Clear();
        found += Same<ObjectPair>((s, list) => s.FindOverlaps(list, workers), p => $"{p}");
        found += Same<ObjectPair>((s, list) => s.CollectCandidates(list, Reach, workers), p => $"{p}");
        found += Same<PairDistance>((s, list) => s.FindDepths(list, workers), Text);
        found += Same<PairContacts>((s, list) => s.FindContacts(Reach, list, workers), Text);
        found += Same<PairContacts>((s, list) => s.FindContacts(0, list, workers), Text);
        Vector3 from = _random.Vector(Side), way = _random.Vector(0.5) - from;
        var pose = new RigidPose(from);
        ConvexShape ball = ConvexShape.Sphere(0.2f);
        found += Same<RayHit>((s, list) => s.FindRayHits(new RayQuery(from, way, 20), list), h => $"{h}");
        found += Same<CastHit>((s, list) => s.FindCastHits(ball, pose, way, list), h => $"{h}");
        found += Same<PairDistance>((s, list) => s.FindDistances(ball, pose, Reach, list), Text);
        found += Same<int>((s, list) => s.FindObjectsOverlapping(ball, pose, list), id => $"{id}");
        return found + Same<PairDistance>(
            (s, list) =>
            {
                foreach (int id in Ids())
                    if (s.TryFindNearest(id, out PairDistance nearest)) list.Add(nearest);
            }, Text);

        int Same<T>(Action<CollisionScene, List<T>> find, Func<T, string> text)
        {
            List<T> one = [], other = [];
            find(fresh, one);
            find(_scene, other);
            Assert.True(one.Select(text).SequenceEqual(other.Select(text)), $"{message}: {typeof(T).Name}");
            return one.Count;
        }
    }

    /// <summary>Pairs of convex objects that both kept their shapes begin where they ended, so their last bits may be
    /// others.</summary>
    private int CheckDistances(CollisionScene fresh, string message, Workers? workers)
    {
        List<PairDistance> one = [], other = [];
        fresh.FindPairsWithin(Reach, one, workers);
        _scene.FindPairsWithin(Reach, other, workers);
        Assert.True(one.Select(d => d.Pair).SequenceEqual(other.Select(d => d.Pair)), message);
        for (int i = 0; i < one.Count; i++)
        {
            ObjectPair pair = one[i].Pair;
            bool isCold = Exchanged.Contains(pair.A) || Exchanged.Contains(pair.B) || !IsConvex(pair.A)
                || !IsConvex(pair.B);
            bool isSame = isCold
                ? Text(one[i]) == Text(other[i])
                : Math.Abs(one[i].Distance - other[i].Distance) <= 1e-5f;
            Assert.True(isSame, $"{message}: {one[i]}, not {other[i]}");
        }

        return one.Count;
    }

    private bool IsConvex(int id) => Objects[id].Shape.Kind == AnyShapeKind.Convex;

    private IEnumerable<int> Ids() => Enumerable.Range(0, Objects.Count).Where(_scene.Contains);

    private CollisionScene Fresh()
    {
        var fresh = new CollisionScene(_kind);
        for (int id = 0; id < Objects.Count; id++)
        {
            (AnyShape shape, RigidPose pose, ObjectSettings settings) = Objects[id];
            Assert.Equal(id, fresh.Add(shape, pose, settings));
            if (!_scene.Contains(id)) fresh.Remove(id);
        }

        return fresh;
    }

    private void Add()
    {
        var settings = new ObjectSettings(_random.OneIn(4), mask: _random.OneIn(6) ? 2 : uint.MaxValue);
        Objects.Add((Shape(), ConcaveShapes.Pose(_random, Side), settings));
        (AnyShape shape, RigidPose pose, _) = Objects[^1];
        Assert.Equal(Objects.Count - 1, _scene.Add(shape, pose, settings));
    }

    private AnyShape Shape() => _random.Below(8) switch
    {
        0 => AnyShape.Of(ConvexShape.HalfSpace(Vector3.UnitY, -1.5f)),
        1 => AnyShape.Of(ConvexShape.Sphere(0.3f)),
        2 => AnyShape.Of(ConvexShape.Capsule(0.2f, _random.Float(0.1f, 0.6f))),
        3 => AnyShape.Of(ConvexShape.Cylinder(0.3f, 0.4f)),
        4 => AnyShape.Of(ConvexShape.Box(Half())),
        5 => AnyShape.Solid(ConcaveShapes.Box(Half())),
        _ => ConcaveShapes.Any(_random),
    };

    private Vector3 Half() => new(_random.Float(0.1f, 0.8f), _random.Float(0.1f, 0.8f), _random.Float(0.1f, 0.8f));

    private static string Text(PairDistance d) => $"{d} {d.PartA} {d.PartB} {ResultBits.Of(d.Result)}";

    private static string Text(PairContacts c) =>
        $"{c} {string.Join(", ", Enumerable.Range(0, c.Manifold.Count).Select(i => c.Manifold[i]))}";
}
