namespace Gjk.Core.Tests.World;

/// <summary>A scene's depths and contacts are those of asking every pair, and the same bits for every broad phase and
/// number of threads.</summary>
public class SceneContactTests
{
    private const int Objects = 80;

    private static readonly string[] Kinds = [.. Generators.AllKinds.Where(k => k != "point"), "made"];

    [Theory]
    [InlineData(0)]
    [InlineData(0.05f)]
    public void ContactsAreThoseOfAllPairs(float maxGap)
    {
        using var workers = new Workers(3);
        MovingWorld world = Moving(maxGap);
        string[] expected = [.. AllContacts(world, maxGap)];
        Assert.True(expected.Length > Objects / 4, $"only {expected.Length} pairs touch");
        foreach (CollisionScene scene in Scenes(world))
        {
            List<PairContacts> found = [];
            foreach (Workers? threads in new[] { null, workers })
            {
                scene.FindContacts(maxGap, found, threads);
                Assert.Equal(expected, found.Select(c => Text(c.Pair, c.Result, c.Manifold)));
            }
        }
    }

    [Fact]
    public void DepthsAreThoseOfAllPairs()
    {
        using var workers = new Workers(2);
        MovingWorld world = Moving(1);
        string[] expected =
        [
            .. Pairs(world).Select(p => (Pair: p, Result: SignedDistance(world, p)))
                .Where(p => p.Result.IsOverlapping).Select(p => Text(p.Pair, p.Result)),
        ];
        Assert.True(expected.Length > Objects / 4, $"only {expected.Length} pairs overlap");
        foreach (CollisionScene scene in Scenes(world))
        {
            List<PairDistance> found = [];
            scene.FindDepths(found);
            Assert.Equal(expected, found.Select(d => Text(d.Pair, d.Result)));
            scene.FindDepths(found, workers);
            Assert.Equal(expected, found.Select(d => Text(d.Pair, d.Result)));
        }
    }

    [Fact]
    public void ObjectsThatAreNotTestedDoNotTouch()
    {
        var scene = new CollisionScene();
        var settings = new ObjectSettings(isStatic: true);
        scene.Add(ConvexShape.Box(new(1)), RigidPose.Identity, settings);
        scene.Add(ConvexShape.Box(new(1)), RigidPose.Identity, settings);
        List<PairContacts> contacts = [];
        List<PairDistance> depths = [];
        scene.FindContacts(0, contacts);
        scene.FindDepths(depths);
        Assert.Empty(contacts);
        Assert.Empty(depths);
        scene.Add(ConvexShape.Box(new(1)), new RigidPose(new System.Numerics.Vector3(1.5f, 0, 0)));
        scene.FindContacts(0, contacts);
        Assert.Equal([new ObjectPair(0, 2), new ObjectPair(1, 2)], contacts.Select(c => c.Pair));
        Assert.All(contacts, c => Assert.Equal(4, c.Manifold.Count));
    }

    [Fact]
    public void BadCallsAreRefused()
    {
        CollisionScene scene = CollisionSceneTests.Row(BroadPhaseKind.DynamicTree, 0, 1, 2);
        Assert.Equal("results", Assert.Throws<ArgumentNullException>(() => scene.FindDepths(null!)).ParamName);
        Assert.Equal("results", Assert.Throws<ArgumentNullException>(() => scene.FindContacts(0, null!)).ParamName);
        foreach (float gap in new[] { -1, float.NaN, -float.Epsilon })
        {
            Assert.Equal(
                "maxGap", Assert.Throws<ArgumentOutOfRangeException>(() => scene.FindContacts(gap, [])).ParamName);
        }
    }

    private static MovingWorld Moving(float seed)
    {
        var world = new MovingWorld((ulong)(seed * 100), Objects, Kinds);
        for (int i = 0; i < Objects; i++) world.Step(i);
        return world;
    }

    private static IEnumerable<CollisionScene> Scenes(MovingWorld world) =>
        from kind in Enum.GetValues<BroadPhaseKind>()
        select world.Scene(kind);

    private static IEnumerable<ObjectPair> Pairs(MovingWorld world) =>
        from a in Enumerable.Range(0, world.Count)
        from b in Enumerable.Range(a + 1, world.Count - a - 1)
        select new ObjectPair(a, b);

    private static DistanceResult SignedDistance(MovingWorld world, ObjectPair p) =>
        ConvexQuery.SignedDistance(world.Shapes[p.A], world.Poses[p.A], world.Shapes[p.B], world.Poses[p.B]);

    private static IEnumerable<string> AllContacts(MovingWorld world, float maxGap)
    {
        foreach (ObjectPair p in Pairs(world))
        {
            ContactManifold manifold = default;
            DistanceResult result = ConvexQuery.Contacts(
                world.Shapes[p.A], world.Poses[p.A], world.Shapes[p.B], world.Poses[p.B], maxGap, out manifold);
            if (manifold.Count > 0) yield return Text(p, result, manifold);
        }
    }

    private static string Text(ObjectPair pair, in DistanceResult result) =>
        $"{pair} {ResultBits.Of(result)}";

    private static string Text(ObjectPair pair, in DistanceResult result, in ContactManifold manifold)
    {
        var hash = new BitHash();
        hash.Add(manifold);
        return $"{Text(pair, result)} {hash}";
    }
}
