namespace Gjk.Core;

public sealed partial class CollisionScene
{
    private readonly SceneMoves _moves;

    /// <summary>Puts an object somewhere else. Setting the same pose keeps cached answers.</summary>
    /// <param name="id">The object.</param>
    /// <param name="pose">Its new pose.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no object with this id, or no longer.</exception>
    /// <exception cref="ArgumentException">The pose is a <c>default</c> struct.</exception>
    public void Move(int id, in RigidPose pose)
    {
        int slot = _objects.RequireSlot(id, nameof(id));
        CheckPose(pose);
        if (_objects.Poses[slot] == pose) return;
        _objects.Poses[slot] = pose;
        UpdateBounds(slot);
    }

    /// <summary>Tells the scene that the heights of an object's mesh have changed; see
    /// <see cref="HeightField.SetHeights"/>.</summary>
    /// <param name="id">The object.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no object with this id, or no longer.</exception>
    public void Refresh(int id)
    {
        int slot = _objects.RequireSlot(id, nameof(id));
        if (GetAnyShape(id).Mesh is { } mesh) _objects.Bounds[slot] = new ShapeBounds(mesh.Tree);
        UpdateBounds(slot);
    }

    /// <summary>Gives an object another shape in place: it keeps its id, pose and settings, and its pairs begin anew,
    /// as if it had just been added.</summary>
    /// <param name="id">The object.</param>
    /// <param name="shape">Any shape but a <c>default</c> struct, of any kind.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no object with this id, or no longer.</exception>
    /// <exception cref="ArgumentException">The shape is a <c>default</c> struct.</exception>
    public void SetShape(int id, in ConvexShape shape) => SetShape(id, AnyShape.Of(shape));

    /// <summary>Gives an object another shape in place, which need not be convex: it keeps its id, pose and settings,
    /// and its pairs begin anew, as if it had just been added.</summary>
    /// <param name="id">The object.</param>
    /// <param name="shape">Any shape but a <c>default</c> struct, of any kind.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no object with this id, or no longer.</exception>
    /// <exception cref="ArgumentException">The shape is a <c>default</c> struct.</exception>
    public void SetShape(int id, in AnyShape shape)
    {
        int slot = _objects.RequireSlot(id, nameof(id));
        var bounds = new ShapeBounds(shape);
        _objects.SetShape(slot, shape, bounds, _calls);
        _phase.ReplaceBounds(slot, bounds.BoxAt(_objects.Poses[slot]));
    }

    private void UpdateBounds(int slot)
    {
        _objects.MovedAfter[slot] = _calls;
        _phase.Move(slot, _objects.Bounds[slot].BoxAt(_objects.Poses[slot]));
    }

    /// <summary>Puts many objects somewhere else, as <see cref="Move"/> does one by one, on several threads.</summary>
    /// <param name="ids">The objects, in any order. If one is there twice, its last pose counts.</param>
    /// <param name="poses">Their new poses, one for each.</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <exception cref="ArgumentNullException">An array is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no object with one of the ids, or no longer; the
    /// parameter is named with its index.</exception>
    /// <exception cref="ArgumentException">There are not as many poses as ids, or a pose is a <c>default</c> struct,
    /// which is named with its index.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    public void MoveAll(int[] ids, RigidPose[] poses, Workers? workers = null)
    {
        if (Guard.NotNull(poses, nameof(poses)).Length != Guard.NotNull(ids, nameof(ids)).Length)
            throw new ArgumentException("There must be as many poses as ids.", nameof(poses));
        Workers.Check(workers);
        int refused = _moves.Prepare(ids, poses, workers);
        if (refused >= 0)
        {
            _objects.RequireSlot(ids[refused], FormattableString.Invariant($"{nameof(ids)}[{refused}]"));
            CheckPose(poses[refused], FormattableString.Invariant($"{nameof(poses)}[{refused}]"));
        }

        _moves.Apply(poses, _calls, workers);
        _phase.MoveAll(_moves.Slots, _moves.Boxes, ids.Length, workers);
    }
}
