namespace Gjk.Core;

public sealed partial class CollisionScene
{
    /// <summary>Ratio: by how much the search for the nearest object widens while it finds none. A matter of speed
    /// only.</summary>
    private const float SearchGrowth = 4;

    private readonly List<int> _near = [];

    /// <summary>The object nearest to one, of those that it is tested against (<see cref="ObjectSettings"/>); of
    /// several the one with the least id.</summary>
    /// <param name="id">The object.</param>
    /// <param name="nearest">The object (A) and the nearest other one (B), or -1 where there is none, with the distance
    /// as <see cref="ConvexQuery"/> has it.</param>
    /// <returns>False when there is no such object.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no object with this id, or no longer.</exception>
    public bool TryFindNearest(int id, out PairDistance nearest)
    {
        int slot = _objects.RequireSlot(id, nameof(id));
        var search = new NearestSearch(_objects, slot, float.PositiveInfinity, default);
        return TryFindNearest(ref search, out nearest);
    }

    /// <summary>The object nearest to a shape that is none of the scene's; of several at the same distance the one with
    /// the least id.</summary>
    /// <param name="shape">Any shape but a <c>default</c> struct: A of the result.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="nearest">-1 for the shape (A), and the nearest object (B), or -1 where there is none; the distance
    /// with the bits of <c>ConvexQuery.Distance</c>, <c>default</c> where there is none.</param>
    /// <param name="maxDistance">At least 0: objects further away are not found. Infinite for all.</param>
    /// <param name="filter">Which objects are seen; by default all.</param>
    /// <returns>Whether there is such an object.</returns>
    /// <exception cref="ArgumentException">The shape or the pose is a <c>default</c> struct.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The distance is negative or NaN.</exception>
    public bool TryFindNearest(
        in ConvexShape shape, in RigidPose pose, out PairDistance nearest,
        float maxDistance = float.PositiveInfinity, in QueryFilter filter = default)
    {
        CheckShape(shape);
        CheckPose(pose);
        Guard.NonNegativeOrInfinite(maxDistance, nameof(maxDistance));
        int guest = _objects.AddGuest(shape, pose, new ShapeBounds(shape));
        var search = new NearestSearch(_objects, guest, maxDistance, filter);
        bool isFound = TryFindNearest(ref search, out nearest);
        _objects.RemoveGuest();
        return isFound;
    }

    /// <summary>Searches boxes that grow until an object is found.</summary>
    private bool TryFindNearest(ref NearestSearch search, out PairDistance nearest)
    {
        ref readonly ShapeBounds bounds = ref _objects.Bounds[search.Self];
        Aabb box = bounds.BoxAt(_objects.Poses[search.Self]);
        float reach = (float)Math.Min(Math.Max(bounds.Radius, float.Epsilon), float.MaxValue);
        reach = Math.Min(reach, search.MaxDistance);
        SearchWithin(ref search, box, reach);
        while (search.Best < 0 && reach < search.MaxDistance && _near.Count < _objects.Count)
        {
            reach = Math.Min(reach * SearchGrowth, search.MaxDistance);
            SearchWithin(ref search, box, reach);
        }

        // An object nearer than the one found may lie outside the box that was searched.
        if (search.Best >= 0 && search.Nearest.Distance > reach) SearchWithin(ref search, box, search.Nearest.Distance);
        int best = search.Best < 0 ? -1 : _objects.Ids[search.Best];
        nearest = search.Nearest.WithPair(new ObjectPair(_objects.Ids[search.Self], best));
        return search.Best >= 0;
    }

    /// <summary>Compares the objects whose bounds are within reach with the nearest one so far.</summary>
    private void SearchWithin(ref NearestSearch search, in Aabb box, float reach)
    {
        _phase.CollectInBox(Widened(box, reach), _near);
        for (int i = 0; i < _near.Count; i++) search.KeepIfNearer(_near[i]);
    }

    /// <summary>A little more than a distance, so that all equally near objects are found: the named one does not
    /// depend on the order of the search.</summary>
    internal static float JustBeyond(float distance) => distance * MarginSlack + float.Epsilon;

    private static Aabb Widened(in Aabb box, float reach)
    {
        var widening = new Vector3(reach * MarginSlack);
        var limit = new Vector3(float.MaxValue);
        return new Aabb(Vector3.Max(box.Min - widening, -limit), Vector3.Min(box.Max + widening, limit));
    }
}

/// <summary>The search for the object nearest to another one, of those that it is tested against, or to a
/// guest.</summary>
/// <param name="objects">All of them.</param>
/// <param name="self">The slot of the object or guest.</param>
/// <param name="maxDistance">Objects further away are not found.</param>
/// <param name="filter">Which objects a guest sees.</param>
internal struct NearestSearch(SceneObjects objects, int self, float maxDistance, in QueryFilter filter)
{
    public readonly int Self = self;
    public readonly float MaxDistance = maxDistance;

    /// <summary>The slot of the nearest object so far, or -1.</summary>
    public int Best = -1;

    /// <summary>The distance to it, and the parts that it is between.</summary>
    public PairDistance Nearest = new(default);

    private readonly QueryFilter _filter = filter;

    /// <summary>Takes an object if it is nearer than the best, or as near with a lesser id.</summary>
    public void KeepIfNearer(int slot)
    {
        if (!IsCandidate(slot)) return;
        float limit = Best < 0 ? MaxDistance : Math.Min(MaxDistance, CollisionScene.JustBeyond(Nearest.Distance));
        PairDistance found = objects.Concave.Distance(Self, slot, limit);
        if (found.Status == GjkStatus.BeyondMaxDistance) return;
        bool isBetter = Best < 0 || found.Distance < Nearest.Distance
            || (found.Distance == Nearest.Distance && slot < Best);
        if (isBetter) (Best, Nearest) = (slot, found);
    }

    private readonly bool IsCandidate(int slot) => !objects.AreEndless(objects.Shapes[Self], slot)
        && (objects.Ids[Self] == SceneObjects.GuestId
            ? objects.IsSeen(slot, _filter)
            : slot != Self && objects.AreTested(Self, slot));
}
