namespace Gjk.Core;

/// <summary>Posed shapes, and the questions that are asked of all of them: which overlap, which are within a distance,
/// which is nearest. A broad phase leaves the queries only the pairs that are worth one.</summary>
/// <remarks>Mutable and not thread-safe; with <see cref="Workers"/> it uses several threads inside a call. Results come
/// sorted by id and are the same for every broad phase, and to the last bit for one thread or many. Ids count up from 0
/// and are never given twice. A refused call changes nothing. Nothing is allocated once the internal buffers and the
/// caller's lists have their size.</remarks>
public sealed partial class CollisionScene
{
    private readonly SceneObjects _objects = new();
    private readonly EndlessPhase _phase;

    /// <summary>Counts the calls of queries whose answers pairs at rest keep.</summary>
    private long _calls;

    /// <summary>Makes an empty scene with a dynamic tree.</summary>
    public CollisionScene()
        : this(BroadPhaseKind.DynamicTree)
    {
    }

    /// <summary>Makes an empty scene.</summary>
    /// <param name="broadPhase">How pairs are found; changes the speed only.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such kind.</exception>
    public CollisionScene(BroadPhaseKind broadPhase)
        : this(MakeBroadPhase(broadPhase))
    {
    }

    /// <summary>Makes an empty scene with a broad phase of your own.</summary>
    /// <param name="broadPhase">An empty one, which is the scene's from now on. The scene's answers are as right as its
    /// pairs and its sweeps.</param>
    /// <exception cref="ArgumentNullException">There is no broad phase.</exception>
    /// <exception cref="ArgumentException">It has objects.</exception>
    public CollisionScene(IBroadPhase broadPhase)
    {
        _phase = new EndlessPhase(Guard.NotNull(broadPhase, nameof(broadPhase)), _objects);
        (_unions, _guestUnions) = (new SceneUnions(_objects), new SceneUnions(_objects));
        _moves = new SceneMoves(_objects);
        if (_phase.Count != 0) throw new ArgumentException("Must be empty.", nameof(broadPhase));
    }

    /// <summary>How many objects there are.</summary>
    public int Count => _objects.Count;

    /// <summary>The ids of all objects.</summary>
    /// <param name="ids">Emptied first; then the ids, ascending.</param>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    public void CollectIds(List<int> ids)
    {
        Guard.NotNull(ids, nameof(ids)).Clear();
        for (int slot = 0; slot < _objects.End; slot++)
        {
            if (_objects.Alive[slot]) ids.Add(_objects.Ids[slot]);
        }
    }

    /// <summary>Whether there is an object with this id.</summary>
    public bool Contains(int id) => _objects.SlotOf(id) >= 0;

    /// <summary>Where an object is.</summary>
    /// <exception cref="ArgumentOutOfRangeException">There is no object with this id, or no longer.</exception>
    public RigidPose GetPose(int id) => _objects.Poses[_objects.RequireSlot(id, nameof(id))];

    /// <summary>An object's shape.</summary>
    /// <exception cref="ArgumentOutOfRangeException">There is no object with this id, or no longer.</exception>
    /// <returns>A <c>default</c> struct where it is not convex.</returns>
    public ConvexShape GetShape(int id) => _objects.Shapes[_objects.RequireSlot(id, nameof(id))];

    /// <summary>An object's shape, convex or not.</summary>
    /// <exception cref="ArgumentOutOfRangeException">There is no object with this id, or no longer.</exception>
    public AnyShape GetAnyShape(int id) => _objects.Concave[_objects.RequireSlot(id, nameof(id))];

    /// <summary>How an object is treated.</summary>
    /// <exception cref="ArgumentOutOfRangeException">There is no object with this id, or no longer.</exception>
    public ObjectSettings GetSettings(int id) => _objects.Settings[_objects.RequireSlot(id, nameof(id))];

    /// <summary>Treats an object in another way from now on.</summary>
    /// <param name="id">The object.</param>
    /// <param name="settings">What it is tested against, and its tag.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no object with this id, or no longer.</exception>
    public void SetSettings(int id, in ObjectSettings settings)
    {
        _objects.SetSettings(_objects.RequireSlot(id, nameof(id)), settings);
    }

    /// <summary>Adds an object.</summary>
    /// <param name="shape">Any shape but a <c>default</c> struct. A half-space is near all other objects, so each is
    /// asked about it; two half-spaces are never tested against each other.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="settings">What it is tested against, and a tag; by default all others, and 0.</param>
    /// <returns>Its id: the next number, from 0.</returns>
    /// <exception cref="ArgumentException">The shape or the pose is a <c>default</c> struct.</exception>
    /// <exception cref="InvalidOperationException">There are 16,777,216 objects, or 2,147,483,647 ids were given
    /// out.</exception>
    public int Add(in ConvexShape shape, in RigidPose pose, in ObjectSettings settings = default) =>
        Add(new ShapeBounds(shape), AnyShape.Of(shape), pose, settings);

    /// <summary>Adds an object that need not be convex: a surface, a solid or a compound. Answers about it name its
    /// parts.</summary>
    /// <param name="shape">Any shape but a <c>default</c> struct.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="settings">What it is tested against, and a tag; by default all others, and 0.</param>
    /// <returns>Its id: the next number, from 0.</returns>
    /// <exception cref="ArgumentException">The shape or the pose is a <c>default</c> struct.</exception>
    /// <exception cref="InvalidOperationException">There are 16,777,216 objects, or 2,147,483,647 ids were given
    /// out.</exception>
    public int Add(in AnyShape shape, in RigidPose pose, in ObjectSettings settings = default) =>
        Add(new ShapeBounds(shape), shape, pose, settings);

    private int Add(in ShapeBounds bounds, in AnyShape shape, in RigidPose pose, in ObjectSettings settings)
    {
        CheckPose(pose);
        if (_objects.ShouldCloseUp) CloseUp();
        int slot = _objects.Reserve();
        _phase.Add(slot, bounds.BoxAt(pose));
        _objects.Add(shape, pose, bounds, settings, _calls);
        return _objects.Ids[slot];
    }

    /// <summary>Removes an object; its id is not given again.</summary>
    /// <param name="id">The object.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no object with this id, or no longer.</exception>
    public void Remove(int id)
    {
        int slot = _objects.RequireSlot(id, nameof(id));
        _phase.Remove(slot);
        _objects.Remove(slot);
    }

    private static IBroadPhase MakeBroadPhase(BroadPhaseKind kind) => kind switch
    {
        BroadPhaseKind.SortAndSweep => new SortAndSweep(),
        BroadPhaseKind.DynamicTree => new DynamicAabbTree(),
        _ => throw new ArgumentOutOfRangeException("broadPhase", kind, "There is no such broad phase."),
    };

    private static void CheckPose(in RigidPose pose, string name = "pose")
    {
        if (pose.IsValid) return;
        const string message = "The pose is no rotation with a finite position. A default RigidPose has no rotation; "
            + "RigidPose.Identity has.";
        throw new ArgumentException(message, name);
    }

    /// <summary>Closes up the arrays. Slots change, so the broad phase is filled anew.</summary>
    private void CloseUp()
    {
        _objects.CloseUp();
        _phase.Clear();
        for (int slot = 0; slot < _objects.End; slot++)
            _phase.Add(slot, _objects.Bounds[slot].BoxAt(_objects.Poses[slot]));
    }

    /// <summary>Collects the pairs of slots that are tested and whose bounds are within a distance.</summary>
    private void CollectSlots(float distance, List<ObjectPair> pairs, Workers? workers)
    {
        Workers.Check(workers);
        _phase.CollectPairs(distance * MarginSlack, pairs, workers);
        if (_objects.AreAllTested) return;
        int kept = 0;
        for (int i = 0; i < pairs.Count; i++)
            if (_objects.AreTested(pairs[i].A, pairs[i].B)) pairs[kept++] = pairs[i];

        pairs.RemoveRange(kept, pairs.Count - kept);
    }
}
