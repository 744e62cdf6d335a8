namespace Gjk.Core;

/// <summary>The first object that a ray meets, of those that the broad phase shows.</summary>
/// <remarks>Each object is queried with the whole ray, not only up to the best hit, so that its answer has the bits of
/// a query alone.</remarks>
internal struct FirstRayHit(
    SceneObjects objects, in RayQuery ray, in QueryFilter filter, in CastOptions options, RaySides sides)
    : ISweepVisitor
{
    /// <summary>What was found; an id of -1 where nothing was.</summary>
    public RayHit Hit = new(RayCastResult.Nothing(CastStatus.Miss, ray.MaxDistance, 0));

    private readonly RayQuery _ray = ray;
    private readonly QueryFilter _filter = filter;
    private readonly CastOptions _options = options;
    private readonly double _length = ray.Length;
    private double _limit = double.PositiveInfinity;

    public double Visit(int slot)
    {
        if (!objects.IsSeen(slot, _filter)) return _limit;
        KeepIfFirst(objects.Ids[slot], objects.Concave.RayCast(slot, _ray, _options, sides));
        return _limit;
    }

    /// <summary>Keeps an answer if it is the first hit.</summary>
    public void KeepIfFirst(int id, in RayHit found)
    {
        if (!found.Result.MayHit) return;
        RayHit hit = found.WithId(id);
        if (Hit.Id >= 0 && !IsBefore(hit, Hit)) return;
        Hit = hit;

        // Twice: the distance and the fraction are rounded on different scales.
        _limit = SweptBox.After(SweptBox.After(found.Distance) / _length);
    }

    /// <summary>By the distance; of objects that are met at once, as on a seam between tiles, one whose side the other
    /// does not cover; then by the object.</summary>
    private readonly bool IsBefore(in RayHit one, in RayHit other)
    {
        bool isAtOnce = one.Result.Order.CompareTo(other.Result.Order) == 0;
        bool isCovered = isAtOnce && Covers(other, one);
        return isAtOnce && isCovered != Covers(one, other) ? !isCovered : one.CompareTo(other) < 0;
    }

    private readonly bool Covers(in RayHit other, in RayHit one)
    {
        int slot = objects.SlotOf(other.Id);
        return slot >= 0 && one.Status == CastStatus.Hit && SimultaneousHits.Covers(
            objects.Concave[slot].PartAt(other.Part), objects.Poses[slot], one.Result.Point, one.Result.Normal);
    }
}

/// <summary>All objects that a ray meets, in no order.</summary>
internal readonly struct AllRayHits(
    SceneObjects objects, RayQuery ray, QueryFilter filter, CastOptions options, RaySides sides, List<RayHit> hits)
    : ISweepVisitor
{
    public double Visit(int slot)
    {
        if (!objects.IsSeen(slot, filter)) return double.PositiveInfinity;
        RayHit found = objects.Concave.RayCast(slot, ray, options, sides);
        if (found.Result.MayHit) hits.Add(found.WithId(objects.Ids[slot]));
        return double.PositiveInfinity;
    }
}

/// <summary>The first object that each of many rays meets.</summary>
internal readonly struct SceneRayJob(
    EndlessPhase phase, SceneObjects objects, RayQuery[] rays, RayHit[] results, QueryFilter filter,
    CastOptions options, RaySides sides) : IShareJob
{
    public void Run(int begin, int end)
    {
        for (int i = begin; i < end; i++)
        {
            var first = new FirstRayHit(objects, rays[i], filter, options, sides);
            phase.Sweep(rays[i].Path(), ref first);
            results[i] = first.Hit;
        }
    }
}
