namespace Gjk.Core.Tests.Support;

/// <summary>The same moving world in a scene of each broad phase, and the answers of asking each object alone. A few
/// objects are twins of others, so that there are ties; some are static, in groups, or have masks.</summary>
internal sealed class SceneSet
{
    private readonly List<ObjectSettings> _settings = [];

    public SceneSet(ulong seed, int count, string[] kinds, float offset)
    {
        World = new MovingWorld(seed, count, kinds);
        Side = 1.7f * MathF.Cbrt(count);
        for (int i = 0; i < count; i++)
        {
            RigidPose pose = World.Poses[i];
            World.Poses[i] = new RigidPose(pose.Rotation, pose.Position * 1.4f + new Vector3(offset, -offset, offset));
        }

        Scenes = [.. Enum.GetValues<BroadPhaseKind>().Select(kind => new CollisionScene(kind))];
        for (int i = 0; i < count; i++) AddToScenes();
    }

    public MovingWorld World { get; }

    public CollisionScene[] Scenes { get; }

    public Rng Rng => World.Rng;

    /// <summary>World units: the side of the room.</summary>
    public float Side { get; }

    /// <summary>How often the world has changed.</summary>
    public int Frame { get; private set; }

    public string Kind(string[] kinds) => kinds[Rng.Below(kinds.Length)];

    /// <summary>Most objects move, some go, and twins of others come.</summary>
    public void Change()
    {
        Frame++;
        for (int i = 0; i < World.Count; i++)
        {
            if (!Scenes[0].Contains(i)) continue;
            if (Rng.Below(12) == 0)
            {
                foreach (CollisionScene scene in Scenes) scene.Remove(i);
                continue;
            }

            RigidPose pose = World.Poses[i];
            if (Rng.Below(3) == 0) continue;
            World.Poses[i] = Generators.Pose(Rng, pose.Position + Rng.Vector(-0.1, 0.1));
            foreach (CollisionScene scene in Scenes) scene.Move(i, World.Poses[i]);
        }

        for (int n = 0; n < 6; n++)
        {
            int original = Rng.Below(World.Count), twin = World.Add();
            (World.Shapes[twin], World.Poses[twin]) = (World.Shapes[original], World.Poses[original]);
            AddToScenes();
        }
    }

    /// <summary>One of all kinds; half of them see everything.</summary>
    public QueryFilter Filter() => Rng.Below(10) switch
    {
        0 => new QueryFilter(groups: 1u << Rng.Below(3)),
        1 => new QueryFilter(mask: 1u << Rng.Below(3)),
        2 => new QueryFilter(seesStatic: false, ignoredId: Rng.Below(World.Count)),
        3 => new QueryFilter(seesMoving: false),
        4 => new QueryFilter(groups: 3, mask: 6, ignoredId: Rng.Below(World.Count)),
        _ => default,
    };

    public IEnumerable<int> Seen(QueryFilter filter) =>
        Enumerable.Range(0, World.Count).Where(i => Scenes[0].Contains(i) && IsSeen(i, filter));

    /// <summary>Half of them pass shallow contacts.</summary>
    public CastOptions Options() => Rng.Below(2) == 0 ? default : CastOptions.OnlyDeeper(Rng.Float(0, 0.3));

    public RayCastResult RayCast(int i, in RayQuery ray, in CastOptions options) =>
        ConvexQuery.RayCast(World.Shapes[i], World.Poses[i], ray.Origin, ray.Direction, ray.MaxDistance, options);

    /// <summary>A cast against one object, of a body that is out of all of them at another pose.</summary>
    public CastHit CastAt(
        int i, in ConvexShape shape, in RigidPose pose, Vector3 motion, float most, in CastOptions options,
        in RigidPose lifted, in Double3 lift)
    {
        (ConvexShape other, RigidPose at) = (World.Shapes[i], World.Poses[i]);
        CastResult found = ConvexQuery.Cast(shape, pose, motion, other, at, Vector3.Zero, most, options);
        CastOptions within = CastOptions.OnlyDeeper(UnionLift.RoundingOf(lifted));
        bool isPassed = lifted != pose && !UnionLift.IsOutOf(found, lifted, lift, motion, -1)
            && !ConvexQuery.Cast(shape, lifted, motion, other, at, Vector3.Zero, most, within).MayHit;
        if (found.MayHit && isPassed) found = CastResult.Nothing(CastStatus.Miss, most, 0);
        MetFeature feature = found.Status == CastStatus.Hit
            ? MetFeatures.Of(shape, pose, other, at, found.Normal)
            : MetFeature.None;
        return new CastHit(found, feature: feature);
    }

    /// <summary>Where a body is out of all objects that it may see.</summary>
    public RigidPose Lifted(
        ConvexShape shape, RigidPose pose, Vector3 motion, float most, in QueryFilter filter, in CastOptions options,
        out Double3 lift)
    {
        var union = new EachAlone(this, shape, pose, motion, most, [.. Seen(filter)]);
        UnionLift.TryLift(ref union, options, out RigidPose lifted, out lift);
        return lifted;
    }

    /// <summary>What takes the place of the first hit with an object: the first contact with all of them.</summary>
    public CastHit OfUnion(
        ConvexShape shape, RigidPose pose, Vector3 motion, float most, in QueryFilter filter, in CastOptions options,
        in RigidPose lifted, CastHit hit)
    {
        var union = new EachAlone(this, shape, pose, motion, most, [.. Seen(filter)]);
        return options.PassesShallow ? UnionLift.FirstOfUnion(ref union, options, lifted, 0, hit) : hit;
    }

    private struct EachAlone(
        SceneSet set, ConvexShape shape, RigidPose start, Vector3 motion, float most, int[] seen) : IUnionCast
    {
        public readonly float Sign => -1;

        public readonly RigidPose PoseAt(float fraction) => new(
            start.Rotation, (Vector3)((Double3)start.Position + (Double3)motion * fraction));

        public readonly float RoundingAt(float fraction, in RigidPose pose) => UnionLift.RoundingOf(pose);

        public readonly Double3 WayAt(in Double3 point, float fraction) => motion;

        public readonly CastResult CastAlong(in RigidPose pose, Vector3 way) =>
            First(pose, way, way == Vector3.Zero ? 0 : 1, default).Result;

        public readonly CastHit CastFrom(float fraction, in RigidPose pose, in CastOptions options) =>
            First(pose, motion, most - fraction, options);

        public readonly bool ShowsFace(in CastHit hit) => MetFeatures.AnyIsFace(
            shape, start, set.World.Shapes[hit.Id], set.World.Poses[hit.Id], hit.Result.Normal);

        private readonly CastHit First(RigidPose pose, Vector3 way, float limit, CastOptions options)
        {
            var first = new CastHit(CastResult.Nothing(CastStatus.Miss, limit, 0));
            foreach (int i in seen)
            {
                CastHit hit = set.CastAt(i, shape, pose, way, limit, options, pose, default).WithId(i);
                if (hit.Result.MayHit && (first.Id < 0 || hit.CompareTo(first) < 0)) first = hit;
            }

            return first;
        }
    }

    public bool Overlaps(int i, in ConvexShape shape, in RigidPose pose) =>
        ConvexQuery.Overlaps(shape, pose, World.Shapes[i], World.Poses[i]);

    public (int Id, DistanceResult Result) Nearest(
        in ConvexShape shape, in RigidPose pose, float most, in QueryFilter filter)
    {
        (int Id, DistanceResult Result) best = (-1, default);
        foreach (int i in Seen(filter))
        {
            DistanceResult found = ConvexQuery.Distance(shape, pose, World.Shapes[i], World.Poses[i], most);
            if (found.Status == GjkStatus.BeyondMaxDistance) continue;
            if (best.Id < 0 || found.Distance < best.Result.Distance) best = (i, found);
        }

        return best;
    }

    /// <summary>The rule, said in another way than the library does.</summary>
    private bool IsSeen(int i, QueryFilter filter)
    {
        ObjectSettings s = _settings[i];
        if (i == filter.IgnoredId || (s.IsStatic && !filter.SeesStatic)) return false;
        if (!s.IsStatic && !filter.SeesMoving) return false;
        bool admitted = filter.Groups == uint.MaxValue || (filter.Groups & s.Mask) > 0;
        return admitted && (filter.Mask == uint.MaxValue || (filter.Mask & s.Groups) > 0);
    }

    private void AddToScenes()
    {
        int id = _settings.Count;
        uint mask = Rng.Below(2) == 0 ? uint.MaxValue : (uint)id & 7;
        _settings.Add(new ObjectSettings(Rng.Below(3) == 0, (uint)Rng.Below(8), mask));
        foreach (CollisionScene scene in Scenes)
            Assert.Equal(id, scene.Add(World.Shapes[id], World.Poses[id], _settings[id]));
    }
}
