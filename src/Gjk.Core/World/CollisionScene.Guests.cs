namespace Gjk.Core;

public sealed partial class CollisionScene
{
    private readonly List<PairDistance> _guestDistances = [];
    private readonly List<ObjectPair> _guestPairs = [];
    private readonly PairAnswers<PairContacts> _guestContacts = new();
    private readonly SceneUnions _guestUnions;

    /// <summary>The objects that overlap a shape that is none of the scene's, touching included.</summary>
    /// <param name="shape">Any shape but a <c>default</c> struct.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="ids">Emptied first; then the objects, sorted: those of which <c>ConvexQuery.Overlaps</c> says so,
    /// the shape first.</param>
    /// <param name="filter">Which objects are seen; by default all.</param>
    /// <exception cref="ArgumentException">The shape or the pose is a <c>default</c> struct.</exception>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    public void FindObjectsOverlapping(
        in ConvexShape shape, in RigidPose pose, List<int> ids, in QueryFilter filter = default)
    {
        Guard.NotNull(ids, nameof(ids));
        ShapeBounds bounds = CollectNear(shape, pose, 0, filter);
        int guest = _objects.Concave.Any ? _objects.AddGuest(shape, pose, bounds) : SceneObjects.GuestId;
        ids.Clear();
        foreach (int slot in _near)
        {
            bool overlaps = _objects.Concave.Contains(slot)
                ? _objects.Concave.Distance(guest, slot, 0).IsOverlapping
                : ConvexQuery.Overlaps(shape, pose, _objects.Shapes[slot], _objects.Poses[slot]);
            if (overlaps) ids.Add(_objects.Ids[slot]);
        }

        if (guest >= 0) _objects.RemoveGuest();
    }

    /// <summary>How far a shape that is none of the scene's is from the objects near it. Of an object that is not
    /// convex each part that is near has a distance of its own, as <c>ConcaveQuery.FindPairsWithin</c> gives
    /// it.</summary>
    /// <param name="shape">Any shape but a <c>default</c> struct: A of the results.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="distance">At least 0: what is further away is left out. Infinite for all.</param>
    /// <param name="results">Emptied first; then -1 for the shape (A) and an object (B) each, sorted by ids and parts,
    /// with the bits of <c>ConvexQuery.Distance</c>.</param>
    /// <param name="filter">Which objects are seen; by default all.</param>
    /// <exception cref="ArgumentException">The shape or the pose is a <c>default</c> struct.</exception>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The distance is negative or NaN.</exception>
    public void FindDistances(
        in ConvexShape shape, in RigidPose pose, float distance, List<PairDistance> results,
        in QueryFilter filter = default)
    {
        Guard.NonNegativeOrInfinite(distance, nameof(distance));
        Guard.NotNull(results, nameof(results));
        int guest = AddGuest(shape, pose, distance, filter);
        ConcaveScratch? scratch = _objects.Concave.RentIfAny();
        results.Clear();
        foreach (int slot in _near)
        {
            if (_objects.Concave.Contains(slot))
            {
                _objects.Concave.FindDistances(new ObjectPair(guest, slot), distance, scratch!, _guestDistances);
                results.AddRange(_guestDistances);
                continue;
            }

            DistanceResult found = ConvexQuery.Distance(
                shape, pose, _objects.Shapes[slot], _objects.Poses[slot], distance);
            if (found.Status != GjkStatus.BeyondMaxDistance)
                results.Add(new PairDistance(found, pair: _objects.IdsOf(new ObjectPair(guest, slot))));
        }

        EndGuestQuery(scratch);
    }

    /// <summary>How deep a shape that is none of the scene's is in the objects that it overlaps, touching included. Of
    /// an object that is not convex each part that it overlaps has a depth of its own, as
    /// <c>ConcaveQuery.FindDepths</c> gives it.</summary>
    /// <param name="shape">Any shape but a <c>default</c> struct: A of the results.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="results">Emptied first; then -1 for the shape (A) and an object (B) each, sorted by ids and parts,
    /// with the bits of <c>ConvexQuery.SignedDistance</c>.</param>
    /// <param name="filter">Which objects are seen; by default all.</param>
    /// <exception cref="ArgumentException">The shape or the pose is a <c>default</c> struct.</exception>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    public void FindDepths(
        in ConvexShape shape, in RigidPose pose, List<PairDistance> results, in QueryFilter filter = default)
    {
        Guard.NotNull(results, nameof(results));
        int guest = AddGuest(shape, pose, 0, filter);
        ConcaveScratch? scratch = _objects.Concave.RentIfAny();
        results.Clear();
        foreach (int slot in _near)
        {
            var pair = new ObjectPair(guest, slot);
            if (_objects.Concave.Contains(slot))
            {
                _objects.Concave.FindDepths(pair, scratch!, _guestDistances);
                results.AddRange(_guestDistances);
            }
            else if (ConvexQuery.Overlaps(shape, pose, _objects.Shapes[slot], _objects.Poses[slot]))
            {
                results.Add(_objects.DepthOf(pair));
            }
        }

        EndGuestQuery(scratch);
    }

    /// <summary>The contact points of a shape that is none of the scene's with the objects that it overlaps, or is no
    /// further from than a gap: those that it would have in <see cref="FindContacts(float, List{PairContacts},
    /// Workers)"/> as a moving object of the scene. The seams of static objects are left out there, too
    /// (<see cref="JoinsStatic"/>).</summary>
    /// <param name="shape">Any shape but a <c>default</c> struct: A of the results.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="maxGap">At least 0: points, and objects, further apart are left out.</param>
    /// <param name="results">Emptied first; then -1 for the shape (A) and an object (B) each, sorted by ids and parts,
    /// with the bits of <c>ConvexQuery.Contacts</c>; of objects that are not convex one manifold for each part, with
    /// the bits of <c>ConcaveQuery.FindContacts</c>.</param>
    /// <param name="filter">Which objects are seen; by default all.</param>
    /// <exception cref="ArgumentException">The shape or the pose is a <c>default</c> struct.</exception>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The gap is negative or NaN.</exception>
    public void FindContacts(
        in ConvexShape shape, in RigidPose pose, float maxGap, List<PairContacts> results,
        in QueryFilter filter = default)
    {
        Guard.NonNegativeOrInfinite(maxGap, nameof(maxGap));
        Guard.NotNull(results, nameof(results));
        int guest = AddGuest(shape, pose, maxGap, filter);
        _guestPairs.Clear();
        foreach (int slot in _near) _guestPairs.Add(new ObjectPair(guest, slot));
        MakeContacts(_guestPairs, _guestContacts, _guestUnions, maxGap, results, null, isKept: false);
        _objects.RemoveGuest();
    }

    /// <summary>Collects the visible objects whose bounds are within a distance of a shape, sorted, and adds the shape
    /// as a guest.</summary>
    /// <returns>The guest's slot, until the guest is removed.</returns>
    private int AddGuest(in ConvexShape shape, in RigidPose pose, float distance, in QueryFilter filter) =>
        _objects.AddGuest(shape, pose, CollectNear(shape, pose, distance, filter));

    /// <summary>Collects the visible objects whose bounds are within a distance of a shape, sorted.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="pose">Its pose.</param>
    /// <param name="distance">World units.</param>
    /// <param name="filter">Which objects are seen.</param>
    /// <returns>The shape's bounds.</returns>
    private ShapeBounds CollectNear(in ConvexShape shape, in RigidPose pose, float distance, in QueryFilter filter)
    {
        CheckShape(shape);
        CheckPose(pose);
        var bounds = new ShapeBounds(shape);
        _phase.CollectInBox(Widened(bounds.BoxAt(pose), distance), _near);
        int kept = 0;
        for (int i = 0; i < _near.Count; i++)
            if (!_objects.AreEndless(shape, _near[i]) && _objects.IsSeen(_near[i], filter)) _near[kept++] = _near[i];
        _near.RemoveRange(kept, _near.Count - kept);
        return bounds;
    }

    /// <summary>Removes the guest, and returns the scratch.</summary>
    private void EndGuestQuery(ConcaveScratch? scratch)
    {
        _objects.Concave.Return(scratch);
        _objects.RemoveGuest();
    }
}
