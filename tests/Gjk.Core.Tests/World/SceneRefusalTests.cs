using System.Runtime.CompilerServices;

namespace Gjk.Core.Tests.World;

/// <summary>What a scene refuses, without a trace.</summary>
public class SceneRefusalTests
{
    public static TheoryData<BroadPhaseKind> Scenes => CollisionSceneTests.Scenes;

    [Theory]
    [MemberData(nameof(Scenes))]
    public void BadCallsAreRefusedAndTheSceneIsUnchanged(BroadPhaseKind kind)
    {
        CollisionScene scene = CollisionSceneTests.Row(kind, 0, 1, 2, 3);
        scene.Remove(2);
        RigidPose[] noPoses =
        [
            default, NaNPose(new Quaternion(float.NaN, 0, 0, 1), default),
            NaNPose(Quaternion.Identity, new Vector3(0, float.NaN, 0)),
            NaNPose(Quaternion.Identity, new Vector3(float.PositiveInfinity)),
        ];
        foreach (RigidPose pose in noPoses)
        {
            Assert.Equal(
                "pose", Assert.Throws<ArgumentException>(() => scene.Add(CollisionSceneTests.Ball, pose)).ParamName);
            Assert.Equal("pose", Assert.Throws<ArgumentException>(() => scene.Move(0, pose)).ParamName);
        }

        Assert.Equal(
            "shape",
            Assert.Throws<ArgumentException>(() => scene.Add(default(ConvexShape), RigidPose.Identity)).ParamName);
        RefusesIds(scene);
        RefusesLists(scene);
        Assert.Equal(3, scene.Count);
        Assert.Equal([new(0, 1), new(1, 3)], CollisionSceneTests.Overlaps(scene));
        Assert.Equal(4, scene.Add(CollisionSceneTests.Ball, RigidPose.Identity));
    }

    /// <summary>What the next question answers to the last bit depends on what the pairs remember.</summary>
    [Fact]
    public void DisposedWorkersAreRefusedAndTheSceneIsUnchanged()
    {
        var workers = new Workers(2);
        workers.Dispose();
        CollisionScene[] scenes =
        [
            .. Enumerable.Range(0, 2).Select(
                _ => new MovingWorld(12, 60, ["hull", "cylinder"]).Scene(BroadPhaseKind.DynamicTree))
        ];
        List<PairDistance> one = [], other = [];
        List<ObjectPair> overlaps = [];
        for (int frame = 0; frame < 4; frame++)
        {
            Assert.Throws<ObjectDisposedException>(() => scenes[0].FindPairsWithin(0.5f, one, workers));
            Assert.Throws<ObjectDisposedException>(() => scenes[0].FindPairsWithin(10, one, workers));
            Assert.Throws<ObjectDisposedException>(() => scenes[0].FindOverlaps(overlaps, workers));
            Assert.Equal(other.Count, one.Count);
            Assert.Empty(overlaps);
            scenes[0].FindPairsWithin(0.5f, one);
            scenes[1].FindPairsWithin(0.5f, other);
            Assert.True(one.Count > 20 && Hashes(other).SequenceEqual(Hashes(one)));
        }
    }

    [Fact]
    public void UnknownKindsAreRefused()
    {
        Assert.Equal(
            "broadPhase",
            Assert.Throws<ArgumentOutOfRangeException>(() => new CollisionScene((BroadPhaseKind)4)).ParamName);
    }

    private static void RefusesIds(CollisionScene scene)
    {
        foreach (int id in new[] { -1, 2, 4, int.MinValue, int.MaxValue })
        {
            Action[] calls =
            [
                () => scene.Move(id, RigidPose.Identity), () => scene.Remove(id), () => scene.GetPose(id),
                () => scene.GetShape(id), () => scene.TryFindNearest(id, out _),
            ];
            foreach (Action call in calls)
            {
                var e = Assert.Throws<ArgumentOutOfRangeException>(call);
                Assert.True(
                    e.ParamName == "id"
                        && e.Message.StartsWith(
                            id == 2
                                ? "The object with this id was removed."
                                : "There was never an object with this id.",
                            StringComparison.Ordinal),
                    e.Message);
            }

            Assert.Equal("idA", Assert.Throws<ArgumentOutOfRangeException>(() => scene.Distance(id, 0)).ParamName);
            Assert.Equal("idB", Assert.Throws<ArgumentOutOfRangeException>(() => scene.Distance(0, id)).ParamName);
            Assert.Contains(
                "Pair 1, ",
                Assert.Throws<ArgumentException>(() => scene.FindOverlapsAmong([new(0, 1), new(0, id)], [])).Message);
            Assert.False(scene.Contains(id));
        }

        Assert.Equal("idB", Assert.Throws<ArgumentException>(() => scene.Distance(1, 1)).ParamName);
    }

    private static void RefusesLists(CollisionScene scene)
    {
        List<ObjectPair> pairs = [new(0, 1)];
        Assert.Equal("results", Assert.Throws<ArgumentNullException>(() => scene.FindOverlaps(null!)).ParamName);
        Assert.Equal("results", Assert.Throws<ArgumentNullException>(() => scene.FindPairsWithin(0, null!)).ParamName);
        Assert.Equal(
            "results", Assert.Throws<ArgumentNullException>(() => scene.FindOverlapsAmong(pairs, null!)).ParamName);
        Assert.Equal(
            "candidates", Assert.Throws<ArgumentNullException>(() => scene.FindOverlapsAmong(null!, pairs)).ParamName);
        Assert.Equal(
            "candidates", Assert.Throws<ArgumentNullException>(() => scene.CollectCandidates(null!)).ParamName);
        Assert.Equal(
            "results", Assert.Throws<ArgumentException>(() => scene.FindOverlapsAmong(pairs, pairs)).ParamName);
        foreach (float distance in new[] { -1, float.NaN, float.NegativeInfinity, -float.Epsilon })
        {
            Assert.Equal(
                "distance",
                Assert.Throws<ArgumentOutOfRangeException>(() => scene.FindPairsWithin(distance, [])).ParamName);
            Assert.Equal(
                "distance",
                Assert.Throws<ArgumentOutOfRangeException>(() => scene.CollectCandidates(pairs, distance)).ParamName);
        }

        Assert.Equal([new(0, 1)], pairs);
    }

    private static IEnumerable<string> Hashes(List<PairDistance> pairs) =>
        pairs.Select(p => $"{p.Pair} {ResultBits.Of(p.Result)}");

    /// <summary>What no constructor makes, but a copy of raw memory may.</summary>
    private static RigidPose NaNPose(Quaternion rotation, Vector3 position)
    {
        (Quaternion, Vector3) raw = (rotation, position);
        return Unsafe.As<(Quaternion, Vector3), RigidPose>(ref raw);
    }
}
