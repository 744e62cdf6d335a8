namespace Gjk.Core;

/// <summary>The first object that a ray meets, of those that the broad phase shows.</summary>
/// <remarks>Each object is asked about the whole ray, never about the part before the best one: what it answers then is
/// what it answers alone, to the last bit.</remarks>
internal struct FirstRayHit(
    SceneObjects objects, in RayQuery ray, in QueryFilter filter, in CastOptions options) : ISweepVisitor
{
    /// <summary>The slot of the first object, or -1.</summary>
    public int Slot = -1;

    /// <summary>The part of it, or -1.</summary>
    public int Part = PartSide.NoPart;

    /// <summary>Where the ray meets it.</summary>
    public RayCastResult Result = RayCastResult.Nothing(CastStatus.Miss, ray.MaxDistance, 0);

    private readonly RayQuery _ray = ray;
    private readonly QueryFilter _filter = filter;
    private readonly CastOptions _options = options;
    private readonly double _length = ray.Length;
    private double _limit = double.PositiveInfinity;

    /// <summary>What was found.</summary>
    public readonly RayHit Hit => new(Slot < 0 ? -1 : objects.Ids[Slot], Result, Part);

    public double Visit(int slot)
    {
        if (!objects.IsSeen(slot, _filter)) return _limit;
        if (objects.Parts.Has(slot))
        {
            PartRayHit hit = objects.Parts.RayCast(slot, _ray, _options);
            Take(slot, hit.Result, hit.Part);
            return _limit;
        }

        Take(slot, ConvexQuery.RayCast(
            objects.Shapes[slot], objects.Poses[slot], _ray.Origin, _ray.Direction, _ray.MaxDistance, _options));
        return _limit;
    }

    /// <summary>Keeps an answer if it is the first hit.</summary>
    public void Take(int slot, in RayCastResult found, int part = PartSide.NoPart)
    {
        if (!found.MayHit) return;
        int order = Slot < 0 ? -1 : found.Order.CompareTo(Result.Order);
        if (order > 0 || (order == 0 && slot > Slot)) return;
        Slot = slot;
        Part = part;
        Result = found;

        // Twice, since the distance and the fraction are rounded each on its own scale.
        _limit = SweptBox.After(SweptBox.After(found.Distance) / _length);
    }
}

/// <summary>All objects that a ray meets, in no order.</summary>
internal readonly struct AllRayHits(
    SceneObjects objects, RayQuery ray, QueryFilter filter, CastOptions options, List<RayHit> hits) : ISweepVisitor
{
    public double Visit(int slot)
    {
        if (!objects.IsSeen(slot, filter)) return double.PositiveInfinity;
        PartRayHit found = objects.Parts.Has(slot)
            ? objects.Parts.RayCast(slot, ray, options)
            : new PartRayHit(
                ConvexQuery.RayCast(
                    objects.Shapes[slot], objects.Poses[slot], ray.Origin, ray.Direction, ray.MaxDistance, options),
                PartSide.NoPart);
        if (found.Result.MayHit) hits.Add(new RayHit(objects.Ids[slot], found.Result, found.Part));
        return double.PositiveInfinity;
    }
}

/// <summary>The first object that each of many rays meets.</summary>
internal readonly struct SceneRayJob(
    IBroadPhase phase, SceneObjects objects, RayQuery[] rays, RayHit[] results, QueryFilter filter,
    CastOptions options) : IPartJob
{
    public void Run(int begin, int end)
    {
        for (int i = begin; i < end; i++)
        {
            var first = new FirstRayHit(objects, rays[i], filter, options);
            phase.Sweep(rays[i].Path(), ref first);
            results[i] = first.Hit;
        }
    }
}
