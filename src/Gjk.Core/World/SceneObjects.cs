namespace Gjk.Core;

/// <summary>The objects of a scene, in arrays ordered by id. Ids count up and are never given again. An object keeps
/// its slot until so many were removed that the arrays are closed up. That keeps the order, so pairs sorted by slot are
/// sorted by id.</summary>
internal sealed class SceneObjects
{
    /// <summary>By slot.</summary>
    public ConvexShape[] Shapes = [];

    /// <inheritdoc cref="Shapes"/>
    public RigidPose[] Poses = [];

    /// <inheritdoc cref="Shapes"/>
    public ShapeBounds[] Bounds = [];

    /// <inheritdoc cref="Shapes"/>
    public ObjectSettings[] Settings = [];

    /// <summary>How many calls had been made when the object was added or moved.</summary>
    public long[] MovedAfter = [];

    /// <summary>How many calls had been made when the object got the shape that it has.</summary>
    private long[] _shapedAfter = [];

    /// <summary>How many calls had been made when any object last got its shape. If that is long ago, no pair need be
    /// checked.</summary>
    private long _anyShapedAfter = -1;

    /// <summary>True while all objects have usual settings, so that no pair need be checked for them.</summary>
    public bool AreAllTested = true;

    /// <summary>The id of each slot, ascending.</summary>
    public int[] Ids = [];

    /// <summary>False for a slot whose object was removed.</summary>
    public bool[] Alive = [];

    /// <summary>How many slots are in use, with removed objects in some.</summary>
    public int End;

    /// <summary>How many objects there are.</summary>
    public int Count;

    /// <summary>The objects that are not convex; their shapes here are default structs.</summary>
    public readonly ScenePartQueries Concave;

    /// <summary>The id of a guest: the shape of a query, which is not in the scene.</summary>
    public const int GuestId = -1;

    private int _nextId;

    public SceneObjects() => Concave = new ScenePartQueries(this);

    /// <summary>Whether every slot is its id.</summary>
    public bool IsDirect { get; private set; } = true;

    /// <summary>Whether to close up the arrays before the next object is added. Slots change then.</summary>
    public bool ShouldCloseUp =>
        (End == Ids.Length && Count < End / 2) || (End == BoundsTable.IdLimit && Count < End);

    /// <summary>Makes room for one more object. Changes nothing if there is no memory for it.</summary>
    /// <returns>The slot that it will have.</returns>
    public int Reserve()
    {
        if (_nextId == int.MaxValue) throw new InvalidOperationException("All ids of this scene were given out.");
        if (End == BoundsTable.IdLimit)
            throw new InvalidOperationException("A scene cannot hold more than 16,777,216 objects.");
        if (End == Ids.Length) Grow();
        return End;
    }

    /// <summary>Adds an object, for which there is room.</summary>
    public void Add(
        in AnyShape shape, in RigidPose pose, in ShapeBounds bounds, in ObjectSettings settings, long call)
    {
        int slot = End++;
        SetShape(slot, shape, bounds, call);
        Poses[slot] = pose;
        SetSettings(slot, settings);
        Ids[slot] = _nextId++;
        Alive[slot] = true;
        Count++;
    }

    /// <summary>Gives the object in a slot another shape.</summary>
    public void SetShape(int slot, in AnyShape shape, in ShapeBounds bounds, long call)
    {
        if (shape.Kind == AnyShapeKind.Convex) Concave.Remove(slot);
        else Concave.Set(slot, shape);
        Shapes[slot] = AnyShape.ConvexOf(shape);
        Bounds[slot] = bounds;
        MovedAfter[slot] = _shapedAfter[slot] = _anyShapedAfter = call;
    }

    /// <summary>Puts the shape of a query beside the objects, as a moving body with the id <see cref="GuestId"/>. No
    /// query about all objects meets it.</summary>
    /// <returns>Its slot, the first that is free.</returns>
    public int AddGuest(in ConvexShape shape, in RigidPose pose, in ShapeBounds bounds)
    {
        if (End == Ids.Length) Grow();
        Shapes[End] = shape;
        Poses[End] = pose;
        Bounds[End] = bounds;
        Settings[End] = default;
        Ids[End] = GuestId;
        return End;
    }

    /// <summary>Forgets the guest's shape.</summary>
    public void RemoveGuest() => Shapes[End] = default;

    public void SetSettings(int slot, in ObjectSettings settings)
    {
        Settings[slot] = settings;
        AreAllTested &= settings.AreUsual;
    }

    /// <summary>Whether the objects in two slots are tested against each other.</summary>
    public bool AreTested(int a, int b) => AreAllTested || ObjectSettings.AreTested(Settings[a], Settings[b]);

    /// <summary>Whether a shape and the object in a slot are two half-spaces, which have no distance.</summary>
    public bool AreEndless(in ConvexShape shape, int slot) =>
        shape.Kind == ShapeKind.HalfSpace && Shapes[slot].Kind == ShapeKind.HalfSpace;

    /// <summary>The ids of a pair of slots.</summary>
    public ObjectPair IdsOf(ObjectPair slots) => new(Ids[slots.A], Ids[slots.B]);

    /// <summary>How deep two convex objects overlap.</summary>
    public PairDistance DepthOf(ObjectPair pair)
    {
        DistanceResult depth = ConvexQuery.SignedDistance(
            Shapes[pair.A], Poses[pair.A], Shapes[pair.B], Poses[pair.B]);
        return new PairDistance(depth, pair: IdsOf(pair));
    }

    /// <summary>Where two convex objects touch.</summary>
    public PairContacts ContactsOf(ObjectPair pair, float maxGap)
    {
        // Cleared, for equality: a query writes the points that there are.
        ContactManifold manifold = default;
        DistanceResult depth = ConvexQuery.Contacts(
            Shapes[pair.A], Poses[pair.A], Shapes[pair.B], Poses[pair.B], maxGap, out manifold);
        return new PairContacts(PartSide.NoPart, PartSide.NoPart, depth, manifold, IdsOf(pair));
    }

    /// <summary>Whether at most half of the objects have moved since a call. If more have, it costs less to query all
    /// pairs than to look for those at rest.</summary>
    public bool AreMostAtRest(long call)
    {
        int moved = 0;
        for (int slot = 0; slot < End; slot++)
            if (MovedAfter[slot] >= call) moved++;
        return moved <= End / 2;
    }

    /// <summary>Whether neither object of a pair has moved since a call.</summary>
    public bool AreAtRest(ObjectPair pair, long call) => MovedAfter[pair.A] < call && MovedAfter[pair.B] < call;

    /// <summary>Whether both objects of a pair have had their shapes since before a call.</summary>
    public bool HaveKeptShapes(ObjectPair pair, long call) =>
        _anyShapedAfter < call || (_shapedAfter[pair.A] < call && _shapedAfter[pair.B] < call);

    /// <summary>Gives the i-th pair the answer that it had in the last frame, if neither object has moved
    /// since.</summary>
    public bool TryKeep<T>(PairAnswers<T> answers, ObjectPair pair, int i, ref int last)
        where T : struct =>
        answers.KnowsAny && AreAtRest(pair, answers.LastCall) && answers.TryKeep(i, ref last);

    /// <summary>Whether a question sees the object in a slot.</summary>
    public bool IsSeen(int slot, in QueryFilter filter) => filter.Sees(Ids[slot], Settings[slot]);

    /// <summary>Removes the object in a slot, and forgets its shape.</summary>
    public void Remove(int slot)
    {
        Alive[slot] = false;
        Shapes[slot] = default;
        Concave.Remove(slot);
        Count--;
    }

    /// <summary>The slot of an id, or -1 where there is no such object.</summary>
    public int SlotOf(int id)
    {
        int slot = IsDirect ? id : Array.BinarySearch(Ids, 0, End, id);
        return (uint)slot < (uint)End && Alive[slot] ? slot : -1;
    }

    /// <summary>The slot of an id that the caller gave as an argument; throws where there is no such object.</summary>
    public int RequireSlot(int id, string name)
    {
        int slot = SlotOf(id);
        if (slot >= 0) return slot;
        bool wasThere = id >= 0 && id < _nextId;
        throw new ArgumentOutOfRangeException(
            name, id, wasThere ? "The object with this id was removed." : "There was never an object with this id.");
    }

    /// <summary>Closes up the arrays: moves the objects into the slots of removed ones, in their order.</summary>
    public void CloseUp()
    {
        int kept = 0;
        for (int slot = 0; slot < End; slot++)
        {
            if (!Alive[slot]) continue;
            Shapes[kept] = Shapes[slot];
            Concave.Move(slot, kept);
            Poses[kept] = Poses[slot];
            Bounds[kept] = Bounds[slot];
            Settings[kept] = Settings[slot];
            MovedAfter[kept] = MovedAfter[slot];
            _shapedAfter[kept] = _shapedAfter[slot];
            Ids[kept] = Ids[slot];
            Alive[kept++] = true;
        }

        Array.Clear(Shapes, kept, End - kept);
        Array.Clear(Alive, kept, End - kept);
        IsDirect = IsDirect && kept == End;
        End = kept;
    }

    private void Grow()
    {
        // A full scene has room for a guest.
        int capacity = Math.Min(BoundsTable.Grown(Ids.Length, End), BoundsTable.IdLimit + 1);
        Array.Resize(ref Shapes, capacity);
        Concave.Reserve();
        Array.Resize(ref Poses, capacity);
        Array.Resize(ref Bounds, capacity);
        Array.Resize(ref Settings, capacity);
        Array.Resize(ref MovedAfter, capacity);
        Array.Resize(ref _shapedAfter, capacity);
        Array.Resize(ref Alive, capacity);

        // Resized last: the length of this array counts as that of all.
        Array.Resize(ref Ids, capacity);
    }
}
