namespace Gjk.Core.Tests.World;

/// <summary>What the questions about rays and shapes that are not in the scene refuse; small and empty
/// scenes.</summary>
public class ScenePathRefusalTests
{
    private static readonly ConvexShape Ball = CollisionSceneTests.Ball;
    private static readonly RigidPose Here = RigidPose.Identity;
    private static readonly RayQuery AlongX = new(new Vector3(-5, 0, 0), Vector3.UnitX);

    public static TheoryData<BroadPhaseKind> Scenes => CollisionSceneTests.Scenes;

    [Theory]
    [MemberData(nameof(Scenes))]
    public void ARowOfBallsIsMetInOrder(BroadPhaseKind kind)
    {
        CollisionScene scene = CollisionSceneTests.Row(kind, 9, 2, 5, 2);
        List<RayHit> hits = [];
        scene.FindRayHits(AlongX, hits);
        Assert.Equal([(1, 6f), (3, 6f), (2, 9f), (0, 13f)], hits.Select(h => (h.Id, h.Result.Distance)));
        Assert.True(scene.TryFindRayHit(AlongX, out RayHit ray));
        Assert.Equal((1, 6f, -Vector3.UnitX), (ray.Id, ray.Distance, ray.Result.Normal));
        scene.Remove(1);
        Assert.True(scene.TryFindRayHit(AlongX, out ray) && ray.Id == 3);
        Assert.True(scene.TryFindRayHit(AlongX, out ray, new QueryFilter(ignoredId: 3)) && ray.Id == 2);

        var start = new RigidPose(new Vector3(-5, 0, 0));
        Assert.True(scene.TryFindCastHit(Ball, start, Vector3.UnitX * 10, out CastHit cast));
        Assert.Equal((3, 0.5f, Vector3.UnitX), (cast.Id, cast.Fraction, cast.Result.Normal));
        List<CastHit> casts = [];
        scene.FindCastHits(Ball, start, Vector3.UnitX * 10, casts, 1.25f);
        Assert.Equal([(3, 0.5f), (2, 0.8f), (0, 1.2f)], casts.Select(h => (h.Id, h.Result.Fraction)));

        List<int> touching = [];
        scene.FindObjectsOverlapping(Ball, new RigidPose(new Vector3(7, 0, 0)), touching);
        Assert.Equal([0, 2], touching);
        Assert.True(scene.TryFindNearest(Ball, start, out PairDistance nearest, 5));
        Assert.Equal((3, 5f), (nearest.Pair.B, nearest.Distance));
        Assert.False(scene.TryFindNearest(Ball, start, out nearest, 4.99f) || nearest.Pair.B >= 0);
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void AnEmptySceneHasNoHits(BroadPhaseKind kind)
    {
        CollisionScene scene = CollisionSceneTests.Row(kind, 1);
        scene.Remove(0);
        List<RayHit> rays = [default];
        List<CastHit> casts = [default];
        List<int> ids = [3];
        scene.FindRayHits(AlongX, rays);
        scene.FindCastHits(Ball, Here, Vector3.UnitX, casts);
        scene.FindObjectsOverlapping(Ball, Here, ids);
        Assert.Equal((0, 0, 0), (rays.Count, casts.Count, ids.Count));
        Assert.False(scene.TryFindRayHit(AlongX, out RayHit ray) || ray.Id >= 0);
        Assert.Equal((CastStatus.Miss, float.PositiveInfinity), (ray.Status, ray.Distance));
        Assert.False(scene.TryFindCastHit(Ball, Here, Vector3.UnitX, out CastHit cast, 2) || cast.Id >= 0);
        Assert.Equal((CastStatus.Miss, 2f), (cast.Status, cast.Fraction));
        Assert.False(scene.TryFindNearest(Ball, Here, out PairDistance nearest) || nearest.Pair.B >= 0);
        var results = new RayHit[1];
        scene.FindFirstRayHits([AlongX], results);
        Assert.Equal((-1, CastStatus.Miss), (results[0].Id, results[0].Result.Status));
    }

    [Fact]
    public void BadRaysAreRefused()
    {
        foreach (Vector3 bad in new[] { new Vector3(0, float.NaN, 0), new Vector3(float.PositiveInfinity, 0, 0) })
        {
            Refused<ArgumentOutOfRangeException>("origin", () => new RayQuery(bad, Vector3.UnitX));
            Refused<ArgumentOutOfRangeException>("direction", () => new RayQuery(default, bad));
        }

        Refused<ArgumentOutOfRangeException>("direction", () => new RayQuery(default, new Vector3(0, -0f, 0)));
        Refused<ArgumentOutOfRangeException>("maxDistance", () => new RayQuery(default, Vector3.UnitX, float.NaN));
        Refused<ArgumentOutOfRangeException>("maxDistance", () => new RayQuery(default, Vector3.UnitX, -1));

        CollisionScene scene = CollisionSceneTests.Row(BroadPhaseKind.DynamicTree, 0);
        List<RayHit> hits = [default];
        Refused<ArgumentException>("ray", () => scene.TryFindRayHit(default, out RayHit _));
        Refused<ArgumentException>("ray", () => scene.FindRayHits(default, hits));
        Refused<ArgumentNullException>("results", () => scene.FindRayHits(AlongX, null!));
        Assert.Single(hits);

        var results = new RayHit[2];
        Refused<ArgumentNullException>("rays", () => scene.FindFirstRayHits(null!, results));
        Refused<ArgumentNullException>("results", () => scene.FindFirstRayHits([AlongX], null!));
        Refused<ArgumentException>("results", () => scene.FindFirstRayHits([AlongX, AlongX, AlongX], results));
        Assert.StartsWith(
            "Ray 1 ",
            Refused<ArgumentException>("rays", () => scene.FindFirstRayHits([AlongX, default], results)).Message);
        var disposed = new Workers(2);
        disposed.Dispose();
        Assert.Throws<ObjectDisposedException>(() => scene.FindFirstRayHits([AlongX], results, disposed));
    }

    [Fact]
    public void BadShapesAndMotionsAreRefused()
    {
        CollisionScene scene = CollisionSceneTests.Row(BroadPhaseKind.DynamicTree, 0);
        Vector3 x = Vector3.UnitX, bad = new(0, float.NaN, 0), far = new(float.NegativeInfinity, 0, 0);
        List<CastHit> hits = [default];
        List<int> ids = [7];
        foreach ((string name, ConvexShape shape, RigidPose pose) in
                 new[] { ("shape", default, Here), ("pose", Ball, default(RigidPose)) })
        {
            Refused<ArgumentException>(name, () => scene.TryFindCastHit(shape, pose, x, out CastHit _));
            Refused<ArgumentException>(name, () => scene.FindCastHits(shape, pose, x, hits));
            Refused<ArgumentException>(name, () => scene.FindObjectsOverlapping(shape, pose, ids));
            Refused<ArgumentException>(name, () => scene.TryFindNearest(shape, pose, out PairDistance _));
        }

        foreach (Vector3 v in new[] { bad, far })
        {
            Refused<ArgumentOutOfRangeException>("translation", () => scene.FindCastHits(Ball, Here, v, hits));
            Refused<ArgumentOutOfRangeException>(
                "translation", () => scene.TryFindCastHit(Ball, Here, v, out CastHit _));
        }

        foreach (float most in new[] { -1, float.NaN, float.NegativeInfinity, -float.Epsilon })
        {
            Refused<ArgumentOutOfRangeException>("maxFraction", () => scene.FindCastHits(Ball, Here, x, hits, most));
            Refused<ArgumentOutOfRangeException>(
                "maxFraction", () => scene.TryFindCastHit(Ball, Here, x, out CastHit _, most));
            Refused<ArgumentOutOfRangeException>(
                "maxDistance", () => scene.TryFindNearest(Ball, Here, out PairDistance _, most));
        }

        Refused<ArgumentNullException>("results", () => scene.FindCastHits(Ball, Here, x, null!));
        Refused<ArgumentNullException>("ids", () => scene.FindObjectsOverlapping(Ball, Here, null!));
        Assert.Equal((1, 1), (hits.Count, ids.Count));
    }

    private static T Refused<T>(string name, Func<object> call)
        where T : ArgumentException => Refused<T>(name, () => { call(); });

    private static T Refused<T>(string name, Action call)
        where T : ArgumentException
    {
        T refusal = Assert.Throws<T>(call);
        Assert.Equal(name, refusal.ParamName);
        return refusal;
    }
}
