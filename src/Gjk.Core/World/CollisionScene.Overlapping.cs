using System;
using System.Collections.Generic;

namespace Gjk.Core;

public sealed partial class CollisionScene
{
    private readonly List<int> _overlapping = [];

    /// <summary>The objects that overlap a shape that is none of the scene's, touching included.</summary>
    /// <param name="shape">Any shape but a <c>default</c> struct.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="ids">
    /// Emptied first; then the objects, sorted: those of which <c>ConvexQuery.Overlaps</c> says so, the shape first.
    /// </param>
    /// <param name="filter">Which objects are seen; by default all.</param>
    /// <exception cref="ArgumentException">The shape or the pose is a <c>default</c> struct.</exception>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    public void FindObjectsOverlapping(
        in ConvexShape shape, in RigidPose pose, List<int> ids, in QueryFilter filter = default)
    {
        CheckNotVisiting();
        CheckShape(shape);
        CheckPose(pose);
        Guard.NotNull(ids, nameof(ids)).Clear();
        _phase.CollectInBox(new ShapeBounds(shape).BoxAt(pose), _near);
        for (int i = 0; i < _near.Count; i++)
        {
            int slot = _near[i];
            if (!_objects.IsSeen(slot, filter)) continue;
            bool overlaps = _objects.Parts.Has(slot)
                ? _objects.Parts.Distance(AnyShape.Of(shape), pose, slot, 0).IsOverlapping
                : ConvexQuery.Overlaps(shape, pose, _objects.Shapes[slot], _objects.Poses[slot]);
            if (overlaps) ids.Add(_objects.Ids[slot]);
        }
    }

    /// <summary>
    /// Shows the objects that overlap a shape that is none of the scene's to a visitor, sorted by id; as the other
    /// otherwise.
    /// </summary>
    /// <typeparam name="TVisitor">A struct.</typeparam>
    /// <param name="shape">Any shape but a <c>default</c> struct.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="visitor">
    /// It may not use the scene before it has seen all objects. What it throws passes through.
    /// </param>
    /// <param name="filter">Which objects are seen; by default all.</param>
    /// <exception cref="ArgumentException">The shape or the pose is a <c>default</c> struct.</exception>
    public void FindObjectsOverlapping<TVisitor>(
        in ConvexShape shape, in RigidPose pose, ref TVisitor visitor, in QueryFilter filter = default)
        where TVisitor : struct, IObjectVisitor
    {
        FindObjectsOverlapping(shape, pose, _overlapping, filter);
        _visiting = true;
        try
        {
            for (int i = 0; i < _overlapping.Count; i++) visitor.Visit(_overlapping[i]);
        }
        finally
        {
            _visiting = false;
        }
    }
}
