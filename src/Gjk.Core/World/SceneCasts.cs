namespace Gjk.Core;

/// <summary>A shape that moves through a scene.</summary>
internal readonly struct MovingShape(
    in ConvexShape shape, in RigidPose pose, Vector3 translation, float maxFraction, in QueryFilter filter,
    in CastOptions options)
{
    public readonly QueryFilter Filter = filter;
    private readonly ConvexShape _shape = shape;
    private readonly RigidPose _pose = pose;
    private readonly CastOptions _options = options;

    /// <summary>When it meets an object, as asked alone.</summary>
    public PartCast Cast(SceneObjects objects, int slot) => objects.Parts.Has(slot)
        ? objects.Parts.Cast(_shape, _pose, translation, slot, maxFraction, _options)
        : new PartCast(
            ConvexQuery.Cast(
                _shape, _pose, translation, objects.Shapes[slot], objects.Poses[slot], Vector3.Zero, maxFraction,
                _options),
            PartSide.NoPart, PartSide.NoPart);

    /// <summary>Its path for a broad phase.</summary>
    public SweptBox Path()
    {
        Aabb box = new ShapeBounds(_shape).BoxAt(_pose);
        return new SweptBox(box.Min, box.Max, translation, maxFraction);
    }
}

/// <summary>The first object that a moving shape meets, of those that the broad phase shows.</summary>
/// <remarks>Each object is asked about the whole motion, as <see cref="FirstRayHit"/> does it.</remarks>
internal struct FirstCastHit(SceneObjects objects, in MovingShape shape, float maxFraction) : ISweepVisitor
{
    /// <summary>The slot of the first object, or -1.</summary>
    public int Slot = -1;

    /// <summary>The part of it, or -1.</summary>
    public int Part = PartSide.NoPart;

    /// <summary>When the shape meets it.</summary>
    public CastResult Result = CastResult.Nothing(CastStatus.Miss, maxFraction, 0);

    private readonly MovingShape _shape = shape;
    private double _limit = double.PositiveInfinity;

    public double Visit(int slot)
    {
        if (!objects.IsSeen(slot, _shape.Filter)) return _limit;
        PartCast found = _shape.Cast(objects, slot);
        Take(slot, found.Result, found.PartB);
        return _limit;
    }

    /// <summary>What was found.</summary>
    public readonly CastHit Hit => new(Slot < 0 ? -1 : objects.Ids[Slot], Result, Part);

    /// <summary>Keeps an answer if it is the first hit.</summary>
    public void Take(int slot, in CastResult found, int part = PartSide.NoPart)
    {
        if (!found.MayHit) return;
        bool isFirst = Slot < 0 || found.Fraction < Result.Fraction
            || (found.Fraction == Result.Fraction && slot < Slot);
        if (!isFirst) return;
        Slot = slot;
        Part = part;
        Result = found;
        _limit = SweptBox.After(found.Fraction);
    }
}

/// <summary>All objects that a moving shape meets, in no order.</summary>
internal readonly struct AllCastHits(SceneObjects objects, MovingShape shape, List<CastHit> hits) : ISweepVisitor
{
    public double Visit(int slot)
    {
        if (!objects.IsSeen(slot, shape.Filter)) return double.PositiveInfinity;
        PartCast found = shape.Cast(objects, slot);
        if (found.Result.MayHit) hits.Add(new CastHit(objects.Ids[slot], found.Result, found.PartB));
        return double.PositiveInfinity;
    }
}
