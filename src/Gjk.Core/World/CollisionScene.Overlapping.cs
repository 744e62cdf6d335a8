namespace Gjk.Core;

public sealed partial class CollisionScene
{
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
        int guest = Invite(shape, pose, 0, filter);
        ConcaveScratch? scratch = _objects.Parts.RentIfAny();
        ids.Clear();
        foreach (int slot in _near)
        {
            bool overlaps = _objects.Parts.Has(slot)
                ? _objects.Parts.Distance(new ObjectPair(guest, slot), 0, scratch!).IsOverlapping
                : ConvexQuery.Overlaps(shape, pose, _objects.Shapes[slot], _objects.Poses[slot]);
            if (overlaps) ids.Add(_objects.Ids[slot]);
        }

        Dismiss(scratch);
    }
}
