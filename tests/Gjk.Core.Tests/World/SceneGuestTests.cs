using Gjk.Core.Tests.Concave;

namespace Gjk.Core.Tests.World;

/// <summary>A shape that is none of the scene's has the distances, depths and contacts that it would have as an object
/// of it, and leaves no trace.</summary>
public class SceneGuestTests
{
    private const float Reach = 0.05f;
    private static readonly ObjectSettings Still = new(isStatic: true);
    private readonly List<PairDistance> _distances = [];
    private readonly List<PairContacts> _contacts = [];

    [Theory]
    [InlineData(BroadPhaseKind.DynamicTree)]
    [InlineData(BroadPhaseKind.SortAndSweep)]
    public void AGuestHasTheAnswersOfAnObject(BroadPhaseKind kind)
    {
        List<PairDistance> depths = [];
        List<PairContacts> contacts = [];
        int met = 0, parts = 0, joined = 0;
        for (int seed = 0; seed < Budget.Count(60); seed++)
        {
            var random = new Rng((ulong)seed);
            ConvexShape shape = seed % 2 == 0 ? ConvexShape.Capsule(0.2f, 0.2f) : ConvexShape.Box(new Vector3(0.25f));
            RigidPose pose = ConcaveShapes.Pose(random, 0.8);
            CollisionScene without = new(kind), with = new(kind);
            with.Add(shape, pose);
            Furnish(random, without, with);
            bool joins = without.JoinsStatic = with.JoinsStatic = seed % 4 > 0;

            without.FindContacts(shape, pose, Reach, _contacts);
            with.FindContacts(Reach, contacts);
            Assert.Equal(contacts.Select(c => Text(c, 1)), _contacts.Select(c => Text(c, 0)));
            without.FindDepths(shape, pose, _distances);
            with.FindDepths(depths);
            Assert.Equal(depths.Select(d => Text(d, 1)), _distances.Select(d => Text(d, 0)));
            met += _contacts.Count;
            parts += _distances.Count(d => d.PartB >= 0);
            without.JoinsStatic = !joins;
            int before = _contacts.Count;
            without.FindContacts(shape, pose, Reach, _contacts);
            if (before != _contacts.Count) joined++;
        }

        Assert.True(met > 60 && parts > 20 && joined > 2, $"{met} {parts} {joined}");
    }

    [Fact]
    public void DistancesAreThoseOfTheQueriesPartByPart()
    {
        var scratch = new ConcaveScratch();
        int met = 0;
        for (int seed = 0; seed < Budget.Count(40); seed++)
        {
            var random = new Rng((ulong)seed);
            var scene = new CollisionScene();
            Furnish(random, scene);
            ConvexShape shape = ConvexShape.Cylinder(0.2f, 0.1f);
            RigidPose pose = ConcaveShapes.Pose(random, 0.8);
            float within = seed % 5 == 0 ? float.PositiveInfinity : random.Of(0f, Reach, 0.5f);
            List<string> expected = [];
            List<int> ids = [];
            List<PairDistance> found = [];
            scene.CollectIds(ids);
            foreach (int id in ids)
            {
                ConcaveQuery.FindPairsWithin(
                    AnyShape.Of(shape), pose, scene.GetAnyShape(id), scene.GetPose(id), within, scratch, found);
                expected.AddRange(found.Select(d => Text(d.WithPair(new ObjectPair(-1, id)), 0)));
            }

            scene.FindDistances(shape, pose, within, _distances);
            Assert.Equal(expected, _distances.Select(d => Text(d, 0)));
            met += expected.Count;
        }

        Assert.True(met > 200, $"{met}");
    }

    [Fact]
    public void AFilterAndAFullTableOfObjectsMakeNoDifference()
    {
        var scene = new CollisionScene();
        ConvexShape ball = ConvexShape.Sphere(0.5f);
        scene.FindContacts(ball, RigidPose.Identity, float.PositiveInfinity, _contacts);
        Assert.Empty(_contacts);
        for (int count = 1; count <= 70; count++)
        {
            int id = scene.Add(ball, new RigidPose(new Vector3(count, 0, 0)), count % 2 == 0 ? Still : default);
            scene.FindDistances(ball, RigidPose.Identity, float.PositiveInfinity, _distances);
            Assert.Equal(Enumerable.Range(0, count), _distances.Select(d => d.Pair.B));
            Assert.All(_distances, d => Assert.Equal(-1, d.Pair.A));
            Assert.Equal(id, _distances[count - 1].Pair.B);
        }

        scene.FindDistances(
            ball, RigidPose.Identity, 5, _distances, new QueryFilter(seesMoving: false, ignoredId: 3));
        Assert.Equal([1, 5], _distances.Select(d => d.Pair.B));
        scene.FindDepths(ball, RigidPose.Identity, _distances, new QueryFilter(ignoredId: 0));
        Assert.Empty(_distances);
        scene.FindDepths(ball, RigidPose.Identity, _distances);
        Assert.Equal([0], _distances.Select(d => d.Pair.B));
        scene.FindContacts(ball, RigidPose.Identity, 1, _contacts, new QueryFilter(seesStatic: false));
        Assert.Equal([0], _contacts.Select(c => c.Pair.B));
        Assert.Equal(70, scene.Count);
        Assert.False(scene.Contains(-1));
        Assert.Throws<ArgumentOutOfRangeException>(() => scene.GetPose(-1));
    }

    [Fact]
    public void AWarmCallAllocatesNothing()
    {
        var scene = new CollisionScene();
        Furnish(new Rng(3), scene);
        ConvexShape shape = ConvexShape.Capsule(0.4f, 0.2f);
        var pose = new RigidPose(new Vector3(0.1f, 0.2f, 0.3f));
        Assert.Equal(0, Allocation.Least(() =>
        {
            scene.FindContacts(shape, pose, Reach, _contacts);
            scene.FindDepths(shape, pose, _distances);
            scene.FindDistances(shape, pose, Reach, _distances);
        }));
        Assert.NotEmpty(_contacts);
    }

    [Fact]
    public void BadCallsAreRefused()
    {
        var scene = new CollisionScene();
        RigidPose here = RigidPose.Identity;
        ConvexShape ball = ConvexShape.Sphere(1);
        scene.Add(ball, here);
        Assert.Equal("shape", Refused(() => scene.FindContacts(default, here, 0, _contacts)));
        Assert.Equal("shape", Refused(() => scene.FindDepths(default, here, _distances)));
        Assert.Equal("shape", Refused(() => scene.FindDistances(default, here, 0, _distances)));
        Assert.Equal("pose", Refused(() => scene.FindContacts(ball, default, 0, _contacts)));
        Assert.Equal("pose", Refused(() => scene.FindDepths(ball, default, _distances)));
        Assert.Equal("pose", Refused(() => scene.FindDistances(ball, default, 0, _distances)));
        Assert.Equal("results", Refused(() => scene.FindContacts(ball, here, 0, null!)));
        Assert.Equal("results", Refused(() => scene.FindDepths(ball, here, null!)));
        Assert.Equal("results", Refused(() => scene.FindDistances(ball, here, 0, null!)));
        foreach (float no in new[] { -1, float.NaN })
        {
            Assert.Equal("maxGap", Refused(() => scene.FindContacts(ball, here, no, _contacts)));
            Assert.Equal("distance", Refused(() => scene.FindDistances(ball, here, no, _distances)));
        }
    }

    private static string? Refused(Action call) => Assert.ThrowsAny<ArgumentException>(call).ParamName;

    /// <summary>Flush tiles below, and shapes of all kinds around: all static, so that only the guest meets
    /// them.</summary>
    private static void Furnish(Rng random, params CollisionScene[] scenes)
    {
        foreach (CompoundPart tile in Floors.Tiles(0))
        {
            Vector3 at = tile.Pose.Position - new Vector3(1.5f, 0.3f, 1.5f);
            foreach (CollisionScene scene in scenes) scene.Add(tile.Shape, new RigidPose(at), Still);
        }

        for (int i = 0; i < 8; i++)
        {
            AnyShape shape = ConcaveShapes.Any(random);
            RigidPose pose = ConcaveShapes.Pose(random, 1.5);
            foreach (CollisionScene scene in scenes) scene.Add(shape, pose, Still);
        }
    }

    private static string Text(PairDistance d, int added) =>
        $"{d.Pair.A - added} {d.Pair.B - added} {d.PartA} {d.PartB} {d.Result} {d.Result.LowerBound:R}";

    private static string Text(PairContacts c, int added)
    {
        IEnumerable<ManifoldPoint> points = Enumerable.Range(0, c.Manifold.Count).Select(i => c.Manifold[i]);
        return $"{c.Pair.A - added} {c.Pair.B - added} {c.PartA} {c.PartB} {c.Result} {string.Join(", ", points)}";
    }
}
