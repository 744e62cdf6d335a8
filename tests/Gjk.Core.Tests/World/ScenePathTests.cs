namespace Gjk.Core.Tests.World;

/// <summary>What a scene says of rays and shapes that are not in it is what asking every object alone says, to the last
/// bit, for every broad phase.</summary>
public class ScenePathTests
{
    private const int Objects = 60;

    private static readonly string[] Kinds = [.. Generators.AllKinds.Where(k => k != "point")];

    /// <summary>Near the origin, and where a float has steps of 1/1000 and of 8.</summary>
    private static readonly float[] Offsets = [0, 1e4f, 1e8f];

    [Fact]
    public void RaysAreThoseOfAskingEachObjectAlone()
    {
        var counts = new int[2];
        foreach ((SceneSet set, string message) in Worlds(1))
        {
            var rays = new List<RayQuery>();
            for (int k = 0; k < 3 * PathFamilies.Count; k++)
            {
                (Vector3 start, Vector3 motion, float most) =
                    PathFamilies.Make(set.Rng, k % PathFamilies.Count, set.World, set.Side);
                if (motion == default) continue;
                rays.Add(new RayQuery(start, motion, (float)(most * ((Double3)motion).Length)));
                QueryFilter filter = set.Filter();
                CastOptions options = set.Options();
                RayHit[] expected = [.. set.Seen(filter)
                    .Select(i => new RayHit(set.RayCast(i, rays[^1], options), id: i))
                    .Where(h => h.Result.Status != CastStatus.Miss).Order()];
                counts[expected.Length > 0 ? 1 : 0]++;
                foreach (CollisionScene scene in set.Scenes)
                {
                    string where = $"{message}, {k}";
                    CheckRay(scene, rays[^1], filter, options, expected, where);
                }
            }

            if (set.Frame == 1) CheckBulk(set, [.. rays], message);
        }

        Assert.InRange((double)counts[1] / (counts[0] + counts[1]), 0.3, 0.8);
    }

    [Fact]
    public void CastsAreThoseOfAskingEachObjectAlone()
    {
        int others = 0;
        var counts = new int[2];
        foreach ((SceneSet set, string message) in Worlds(2))
        {
            for (int k = 0; k < 2 * PathFamilies.Count; k++)
            {
                (Vector3 start, Vector3 motion, float most) =
                    PathFamilies.Make(set.Rng, k % PathFamilies.Count, set.World, set.Side);
                ConvexShape shape = Generators.Shape(set.Rng, set.Kind(Generators.AllKinds)).Shape;
                RigidPose pose = Generators.Pose(set.Rng, start);
                QueryFilter filter = set.Filter();
                CastOptions options = set.Options();
                if (set.Rng.Below(10) == 0) motion = default;
                RigidPose lifted = set.Lifted(shape, pose, motion, most, filter, options, out Double3 lift);
                CastHit[] expected = [.. set.Seen(filter).Select(
                    i => set.CastAt(i, shape, pose, motion, most, options, lifted, lift).WithId(i))
                    .Where(h => h.Result.Status != CastStatus.Miss).Order()];
                counts[expected.Length > 0 ? 1 : 0]++;

                CastHit alone = expected.Length > 0
                    ? expected[0]
                    : new CastHit(CastResult.Nothing(CastStatus.Miss, most, 0));
                CastHit one = set.OfUnion(shape, pose, motion, most, filter, options, lifted, alone);
                if (!CastBits.AreSame(alone.Result, one.Result)) others++;
                foreach (CollisionScene scene in set.Scenes)
                {
                    string where = $"{message}, {k}";
                    List<CastHit> all = [];
                    scene.FindCastHits(shape, pose, motion, all, most, filter, options);
                    Assert.True(
                        Same(expected, all),
                        $"{where}: {string.Join("; ", expected)} but {string.Join("; ", all)}");
                    bool isHit = scene.TryFindCastHit(
                        shape, pose, motion, out CastHit first, most, filter, options);
                    Assert.True(isHit == one.Id >= 0 && first.Id == one.Id, where);
                    Assert.True(CastBits.AreSame(one.Result, first.Result), where);
                }
            }
        }

        Assert.InRange((double)counts[1] / (counts[0] + counts[1]), 0.3, 0.9);
        Assert.InRange((double)others / counts[1], 0, 0.2);
    }

    [Fact]
    public void OverlappingAndNearestAreThoseOfAskingEachObjectAlone()
    {
        var counts = new int[2];
        foreach ((SceneSet set, string message) in Worlds(3))
        {
            for (int k = 0; k < 20; k++)
            {
                ConvexShape shape = Generators.Shape(set.Rng, set.Kind(Generators.AllKinds)).Shape;
                (Vector3 start, _, _) = PathFamilies.Make(set.Rng, k % 4, set.World, set.Side);
                RigidPose pose = Generators.Pose(set.Rng, start);
                QueryFilter filter = set.Filter();
                float most = set.Rng.Below(3) switch { 0 => float.PositiveInfinity, 1 => 0, _ => set.Rng.Float(0, 1) };
                int[] touching = [.. set.Seen(filter).Where(i => set.Overlaps(i, shape, pose))];
                (int Id, DistanceResult Result) nearest = set.Nearest(shape, pose, most, filter);
                counts[touching.Length > 0 ? 1 : 0]++;
                foreach (CollisionScene scene in set.Scenes)
                {
                    string where = $"{message}, {k}";
                    List<int> overlapping = [];
                    scene.FindObjectsOverlapping(shape, pose, overlapping, filter);
                    Assert.True(touching.SequenceEqual(overlapping), where);
                    bool any = scene.TryFindNearest(shape, pose, out PairDistance found, most, filter);
                    Assert.True(
                        any == (nearest.Id >= 0) && found.Pair.B == nearest.Id, $"{where}: {found}, not {nearest.Id}");
                    Assert.True(!any || ResultBits.AreSame(nearest.Result, found.Result), where);
                }
            }
        }

        Assert.InRange((double)counts[1] / (counts[0] + counts[1]), 0.3, 0.7);
    }

    private static void CheckRay(
        CollisionScene scene, in RayQuery ray, in QueryFilter filter, in CastOptions options, RayHit[] expected,
        string message)
    {
        List<RayHit> all = [];
        scene.FindRayHits(ray, all, filter, options);
        Assert.True(
            Same(expected, all), $"{message}, {ray}: {string.Join("; ", expected)} but {string.Join("; ", all)}");
        bool isHit = scene.TryFindRayHit(ray, out RayHit first, filter, options);
        Assert.True(isHit == (expected.Length > 0), message);

        // Of several that are met at once any may come first: RayTileTests holds it to the rule.
        RayHit own = Array.Find(
            expected, hit => hit.Id == first.Id && hit.Result.Order.CompareTo(expected[0].Result.Order) == 0);
        Assert.True(isHit ? own.Result.MayHit : first.Id == -1, $"{message}, {ray}");
        Assert.True(isHit ? CastBits.AreSame(own.Result, first.Result)
            : first.Status == CastStatus.Miss && first.Distance == ray.MaxDistance, message);
    }

    /// <summary>Many rays at once, on one thread and on several.</summary>
    private static void CheckBulk(SceneSet set, RayQuery[] rays, string message)
    {
        using var workers = new Workers(3);
        rays = [.. Enumerable.Repeat(rays, 6).SelectMany(r => r)];
        var results = new RayHit[rays.Length];
        foreach (CollisionScene scene in set.Scenes)
        {
            foreach (Workers? w in new[] { null, workers })
            {
                QueryFilter filter = set.Filter();
                CastOptions options = set.Options();
                scene.FindFirstRayHits(rays, results, w, filter, options);
                for (int i = 0; i < rays.Length; i++)
                {
                    scene.TryFindRayHit(rays[i], out RayHit hit, filter, options);
                    Assert.True(
                        hit.Id == results[i].Id && CastBits.AreSame(hit.Result, results[i].Result),
                        $"{message}, ray {i}, {(w is null ? 1 : 3)} threads");
                }
            }
        }
    }

    private static IEnumerable<(SceneSet Set, string Message)> Worlds(ulong salt)
    {
        for (int seed = 0; seed < Budget.Count(2); seed++)
        {
            foreach (float offset in Offsets)
            {
                var set = new SceneSet(1000 * salt + (ulong)seed, Objects, Kinds, offset);
                for (int frame = 0; frame < 3; frame++)
                {
                    set.Change();
                    yield return (set, $"seed {seed}, offset {offset:G9}, frame {frame}");
                }
            }
        }
    }

    private static bool Same(RayHit[] expected, List<RayHit> found) =>
        expected.Length == found.Count
        && expected.Zip(found).All(p => p.First.Id == p.Second.Id && CastBits.AreSame(p.First.Result, p.Second.Result));

    private static bool Same(CastHit[] expected, List<CastHit> found) =>
        expected.Length == found.Count
        && expected.Zip(found).All(p => p.First.Id == p.Second.Id && CastBits.AreSame(p.First.Result, p.Second.Result));
}
