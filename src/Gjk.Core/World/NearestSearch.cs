namespace Gjk.Core;

/// <summary>The search for the object of a scene that is nearest to a shape.</summary>
internal struct NearestSearch
{
    public readonly RigidPose Pose;

    /// <summary>Objects further away are not found.</summary>
    public readonly float MaxDistance;

    /// <summary>The slot of the nearest object so far, or -1.</summary>
    public int Best;

    /// <summary>The distance to it.</summary>
    public DistanceResult Result;

    /// <summary>The parts that it is between.</summary>
    public int PartA, PartB;

    private readonly SceneObjects _objects;
    private readonly ConvexShape _shape;
    private readonly QueryFilter _filter;

    /// <summary>The slot of the object that is asked about, or -1.</summary>
    private readonly int _self;

    /// <summary>What is nearest to an object of the scene, of those that it is tested against.</summary>
    public NearestSearch(SceneObjects objects, int slot)
        : this(objects, objects.Shapes[slot], objects.Poses[slot], float.PositiveInfinity, default) => _self = slot;

    /// <summary>What is nearest to a shape that is none of the scene's.</summary>
    public NearestSearch(
        SceneObjects objects, in ConvexShape shape, in RigidPose pose, float maxDistance, in QueryFilter filter)
    {
        _objects = objects;
        _shape = shape;
        _filter = filter;
        _self = -1;
        Pose = pose;
        MaxDistance = maxDistance;
        Best = -1;
        PartA = PartB = PartSide.NoPart;
        Result = default;
    }

    /// <summary>Takes an object if it is nearer than the best, or as near with a lesser id.</summary>
    public void Look(int slot)
    {
        if (!IsAsked(slot)) return;
        float limit = Best < 0 ? MaxDistance : Math.Min(MaxDistance, CollisionScene.JustBeyond(Result.Distance));
        int partA = PartSide.NoPart, partB = PartSide.NoPart;
        DistanceResult found;
        if (_objects.Parts.Has(slot) || _shape.Kind == ShapeKind.None)
        {
            AnyShape self = _self < 0 ? AnyShape.Of(_shape) : _objects.Parts[_self];
            PartDistance nearest = _objects.Parts.Distance(self, Pose, slot, limit);
            (found, partA, partB) = (nearest.Result, nearest.PartA, nearest.PartB);
        }
        else
        {
            found = ConvexQuery.Distance(_shape, Pose, _objects.Shapes[slot], _objects.Poses[slot], limit);
        }

        if (found.Status == GjkStatus.BeyondMaxDistance) return;
        bool isBetter = Best < 0 || found.Distance < Result.Distance
            || (found.Distance == Result.Distance && slot < Best);
        if (!isBetter) return;
        (Best, PartA, PartB) = (slot, partA, partB);
        Result = found;
    }

    private readonly bool IsAsked(int slot) =>
        _self < 0 ? _objects.IsSeen(slot, _filter) : slot != _self && _objects.AreTested(_self, slot);
}
