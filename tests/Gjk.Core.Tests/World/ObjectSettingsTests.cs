namespace Gjk.Core.Tests.World;

/// <summary>Groups, masks and static objects: what the finders test, and what they leave out.</summary>
public class ObjectSettingsTests
{
    public static TheoryData<BroadPhaseKind> Kinds => CollisionSceneTests.Scenes;

    [Fact]
    public void ADefaultStructIsTestedAgainstAllOthers()
    {
        ObjectSettings settings = default;
        Assert.Equal((false, 1u, uint.MaxValue, 0L), (settings.IsStatic, settings.Groups, settings.Mask, settings.Tag));
        Assert.Equal(settings, new ObjectSettings());
        Assert.True(settings == new ObjectSettings(groups: 1) && settings != new ObjectSettings(tag: 5));
        Assert.NotEqual(settings.GetHashCode(), new ObjectSettings(isStatic: true).GetHashCode());
        Assert.True(settings.Equals((object)default(ObjectSettings)));
        Assert.True(ObjectSettings.AreTested(settings, settings));
    }

    [Fact]
    public void BothMasksMustAdmitAndNotBothMayBeStatic()
    {
        var red = new ObjectSettings(groups: 2, mask: 4);
        var blue = new ObjectSettings(groups: 4, mask: 2);
        var deaf = new ObjectSettings(groups: 4, mask: 0);
        var wall = new ObjectSettings(isStatic: true);
        Assert.True(ObjectSettings.AreTested(red, blue) && ObjectSettings.AreTested(blue, red));
        Assert.False(ObjectSettings.AreTested(red, red) || ObjectSettings.AreTested(red, deaf));
        Assert.False(ObjectSettings.AreTested(red, default));
        Assert.False(ObjectSettings.AreTested(wall, wall));
        Assert.True(ObjectSettings.AreTested(wall, default));
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void TheFindersHonourThem(BroadPhaseKind phase)
    {
        for (ulong seed = 0; seed < 8; seed++)
        {
            (CollisionScene scene, ObjectSettings[] settings) = Made(seed, phase);
            (CollisionScene plain, _) = Made(seed, phase, isPlain: true);
            bool Tested(ObjectPair p) => ObjectSettings.AreTested(settings[p.A], settings[p.B]);

            List<ObjectPair> all = [], found = [];
            plain.FindOverlaps(all);
            scene.FindOverlaps(found);
            Assert.Equal(all.Where(Tested), found);
            Assert.InRange(found.Count, 1, all.Count - 1);
            Assert.All(found, p => Assert.Equal(p.A, scene.GetSettings(p.A).Tag));

            plain.CollectCandidates(all, 0.1f);
            scene.CollectCandidates(found, 0.1f);
            Assert.Equal(all.Where(Tested), found);

            List<PairDistance> near = [], nearFound = [];
            plain.FindPairsWithin(0.2f, near);
            scene.FindPairsWithin(0.2f, nearFound);
            Assert.Equal(near.Select(p => p.Pair).Where(Tested), nearFound.Select(p => p.Pair));
            for (int id = 0; id < settings.Length; id++) CheckNearest(scene, settings, id);
        }
    }

    /// <summary>Each is tested against the default object, but not against the other.</summary>
    [Fact]
    public void TwoOfAGroupThatTheirMasksLeaveOutAreNotTested()
    {
        var limb = new ObjectSettings(groups: 2, mask: 1);
        Assert.False(ObjectSettings.AreTested(limb, limb));
        var scene = new CollisionScene();
        scene.Add(ConvexShape.Sphere(1), RigidPose.Identity);
        scene.Add(ConvexShape.Sphere(1), RigidPose.Identity, limb);
        scene.Add(ConvexShape.Sphere(1), RigidPose.Identity, limb);
        List<ObjectPair> found = [];
        scene.FindOverlaps(found);
        Assert.Equal([new ObjectPair(0, 1), new ObjectPair(0, 2)], found);
    }

    [Fact]
    public void WithNobodyToTestThereIsNoNearest()
    {
        var scene = new CollisionScene();
        int wall = scene.Add(ConvexShape.Sphere(1), RigidPose.Identity, new ObjectSettings(isStatic: true));
        int floor = scene.Add(
            ConvexShape.Sphere(1), new RigidPose(new Vector3(1e6f, 0, 0)), new ObjectSettings(isStatic: true));
        Assert.False(scene.TryFindNearest(wall, out PairDistance nearest));
        Assert.Equal(-1, nearest.Pair.B);
        scene.SetSettings(floor, default);
        Assert.True(scene.TryFindNearest(wall, out nearest));
        Assert.Equal((floor, 999998f), (nearest.Pair.B, nearest.Distance));
        Assert.Equal(1e6f - 2, scene.Distance(wall, floor).Distance, 1f);
    }

    /// <summary>They stay with their object when others are removed and the arrays are closed up.</summary>
    [Fact]
    public void TheyStayWithTheirObject()
    {
        var scene = new CollisionScene();
        for (int i = 0; i < 100; i++)
            scene.Add(ConvexShape.Sphere(1), RigidPose.Identity, new ObjectSettings(tag: i));
        for (int i = 0; i < 90; i++) scene.Remove(i);
        for (int i = 0; i < 100; i++)
        {
            var settings = new ObjectSettings(tag: 100 + i);
            Assert.Equal(100 + i, scene.Add(ConvexShape.Sphere(1), RigidPose.Identity, settings));
        }

        for (int i = 90; i < 200; i++) Assert.Equal(i, scene.GetSettings(i).Tag);
    }

    [Fact]
    public void UnknownObjectsAreRefused()
    {
        var scene = new CollisionScene();
        Assert.Throws<System.ArgumentOutOfRangeException>("id", () => scene.GetSettings(0));
        Assert.Throws<System.ArgumentOutOfRangeException>("id", () => scene.SetSettings(0, default));
    }

    private static void CheckNearest(CollisionScene scene, ObjectSettings[] settings, int id)
    {
        bool found = scene.TryFindNearest(id, out PairDistance nearest);
        var others = Enumerable.Range(0, settings.Length)
            .Where(o => o != id && ObjectSettings.AreTested(settings[id], settings[o]))
            .Select(o => (Distance: Alone(scene, id, o), Id: o)).ToArray();
        Assert.Equal(others.Length > 0, found);
        if (found) Assert.Equal(others.Min(), (nearest.Distance, nearest.Pair.B));
    }

    private static float Alone(CollisionScene scene, int a, int b) =>
        ConvexQuery.Distance(scene.GetShape(a), scene.GetPose(a), scene.GetShape(b), scene.GetPose(b)).Distance;

    private static (CollisionScene Scene, ObjectSettings[] Settings) Made(
        ulong seed, BroadPhaseKind phase, bool isPlain = false)
    {
        var rng = new Rng(seed);
        var scene = new CollisionScene(phase);
        var settings = new ObjectSettings[60];
        for (int i = 0; i < settings.Length; i++)
        {
            settings[i] = new ObjectSettings(
                rng.Below(3) == 0, 1u << rng.Below(4), rng.Below(4) == 0 ? uint.MaxValue : (uint)rng.Below(16), i);
            ConvexShape shape = rng.Below(2) == 0
                ? ConvexShape.Box(rng.Vector(0.1, 0.5)) : ConvexShape.Sphere(rng.Float(0.1, 0.5));
            scene.Add(shape, Generators.Pose(rng, rng.Vector(-1.5, 1.5)), isPlain ? default : settings[i]);
        }

        return (scene, settings);
    }
}
