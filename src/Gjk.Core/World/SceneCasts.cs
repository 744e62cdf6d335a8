namespace Gjk.Core;

/// <summary>A shape that moves through a scene.</summary>
internal readonly struct MovingShape(
    in ConvexShape shape, in RigidPose pose, Vector3 translation, float maxFraction, in QueryFilter filter,
    in CastOptions options, in RigidPose lifted, in Double3 lift)
{
    public readonly QueryFilter Filter = filter;
    public readonly Vector3 Translation = translation;
    public readonly float MaxFraction = maxFraction;
    private readonly ConvexShape _shape = shape;
    private readonly RigidPose _pose = pose;
    private readonly CastOptions _options = options;

    /// <summary>Its pose outside the union of the objects, if it begins deeper in that than is allowed; else its first
    /// pose.</summary>
    public readonly RigidPose Lifted = lifted;

    private readonly Double3 _lift = lift;

    /// <summary>The same shape with another first pose and translation.</summary>
    public MovingShape StartingAt(in RigidPose at, Vector3 way, float most, in CastOptions passed) =>
        new(_shape, at, way, most, Filter, passed, at, default);

    /// <summary>Where it is after a fraction of the motion.</summary>
    public RigidPose PoseAt(float fraction) =>
        new(_pose.Rotation, (Vector3)((Double3)_pose.Position + (Double3)Translation * fraction));

    /// <summary>The same motion, which passes contacts that get no deeper from the lifted pose.</summary>
    public MovingShape LiftedTo(in RigidPose at, in Double3 lift) =>
        new(_shape, _pose, Translation, MaxFraction, Filter, _options, at, lift);

    /// <summary>When it meets an object.</summary>
    public CastHit Cast(SceneObjects objects, int slot)
    {
        CastHit found = Cast(objects, slot, _pose, _options);
        bool isLifted = Lifted != _pose && found.Result.MayHit
            && !UnionLift.IsOutOf(found.Result, Lifted, _lift, Translation, -1);
        CastOptions passed = CastOptions.OnlyDeeper(UnionLift.RoundingOf(Lifted));
        return isLifted && !Cast(objects, slot, Lifted, passed).Result.MayHit
            ? new CastHit(CastResult.Nothing(CastStatus.Miss, MaxFraction, 0))
            : found;
    }

    private CastHit Cast(SceneObjects objects, int slot, in RigidPose from, in CastOptions passed)
    {
        if (objects.Concave.Contains(slot))
            return objects.Concave.Cast(_shape, from, Translation, slot, MaxFraction, passed);
        ref readonly ConvexShape other = ref objects.Shapes[slot];
        ref readonly RigidPose at = ref objects.Poses[slot];
        CastResult found = ConvexQuery.Cast(_shape, from, Translation, other, at, Vector3.Zero, MaxFraction, passed);
        MetFeature feature = found.Status == CastStatus.Hit
            ? MetFeatures.Of(_shape, from, other, at, found.Normal)
            : MetFeature.None;
        return new CastHit(found, feature: feature);
    }

    /// <summary>Whether it or the object has a face where they meet.</summary>
    public bool ShowsFace(SceneObjects objects, in CastHit hit)
    {
        int slot = objects.SlotOf(hit.Id);
        return slot >= 0 && MetFeatures.AnyIsFace(
            _shape, _pose, objects.Concave[slot].PartAt(hit.PartB), objects.Poses[slot], hit.Result.Normal);
    }

    /// <summary>Adds a hit for every part of an object that it meets.</summary>
    public void CastAll(SceneObjects objects, int slot, List<CastHit> hits)
    {
        ConcaveScratch scratch = objects.Concave.Rent();
        List<CastHit> parts = scratch.Casts;
        ConcaveQuery.CastAll(
            AnyShape.Of(_shape), _pose, Translation, objects.Concave[slot], objects.Poses[slot], Vector3.Zero, scratch,
            parts, MaxFraction, _options);
        for (int i = 0; i < parts.Count; i++) hits.Add(parts[i].WithId(objects.Ids[slot]));
        objects.Concave.Return(scratch);
    }

    /// <summary>Its path for a broad phase.</summary>
    public SweptBox Path()
    {
        Aabb box = new ShapeBounds(_shape).BoxAt(_pose);
        return new SweptBox(box.Min, box.Max, Translation, MaxFraction);
    }
}

/// <summary>The first object that a moving shape meets, of those that the broad phase shows.</summary>
/// <remarks>Each object is queried with the whole motion, as in <see cref="FirstRayHit"/>.</remarks>
internal struct FirstCastHit(SceneObjects objects, in MovingShape shape) : ISweepVisitor
{
    /// <summary>What was found; an id of -1 where nothing was.</summary>
    public CastHit Hit = new(CastResult.Nothing(CastStatus.Miss, shape.MaxFraction, 0));

    private readonly MovingShape _shape = shape;
    private double _limit = double.PositiveInfinity;

    public double Visit(int slot)
    {
        if (!objects.IsSeen(slot, _shape.Filter)) return _limit;
        KeepIfFirst(objects.Ids[slot], _shape.Cast(objects, slot));
        return _limit;
    }

    /// <summary>Keeps an answer if it is the first hit.</summary>
    public void KeepIfFirst(int id, in CastHit found)
    {
        if (!found.Result.MayHit) return;
        CastHit hit = found.WithId(id);
        if (Hit.Id >= 0 && hit.CompareTo(Hit) > 0) return;
        Hit = hit;
        _limit = SweptBox.After(found.Fraction);
    }
}

/// <summary>All objects that a moving shape meets, in no order.</summary>
internal readonly struct AllCastHits(
    SceneObjects objects, MovingShape shape, List<CastHit> hits, bool eachPart) : ISweepVisitor
{
    public double Visit(int slot)
    {
        if (!objects.IsSeen(slot, shape.Filter)) return double.PositiveInfinity;
        CastHit found = shape.Cast(objects, slot);
        if (!found.Result.MayHit) return double.PositiveInfinity;
        if (eachPart && objects.Concave.Contains(slot)) shape.CastAll(objects, slot, hits);
        else hits.Add(found.WithId(objects.Ids[slot]));
        return double.PositiveInfinity;
    }
}
