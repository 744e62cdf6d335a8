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
        ShapeBounds bounds = CollectNear(shape, pose, 0, filter);
        int guest = _objects.Parts.Any ? _objects.Invite(shape, pose, bounds) : SceneObjects.GuestId;
        ids.Clear();
        foreach (int slot in _near)
        {
            bool overlaps = _objects.Parts.Has(slot)
                ? _objects.Parts.Distance(guest, slot, 0).IsOverlapping
                : ConvexQuery.Overlaps(shape, pose, _objects.Shapes[slot], _objects.Poses[slot]);
            if (overlaps) ids.Add(_objects.Ids[slot]);
        }

        if (guest >= 0) _objects.Dismiss();
    }
}
