namespace Gjk.Core;

/// <summary>The objects of a scene in arrays, ordered by id. An id is the next number ever; its slot is the same until
/// so many objects were removed that the arrays are closed up, which keeps the order, so pairs sorted by slot are
/// always sorted by id.</summary>
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

    /// <summary>How many calls had been made when any object last got its shape, so that no pair need be looked at
    /// where all have kept theirs.</summary>
    private long _anyShapedAfter = -1;

    /// <summary>Whether all settings are the default ones, so that no pair need be looked at for them.</summary>
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
    public readonly ScenePartQueries Parts;

    /// <summary>In place of an id: the shape that a question brings.</summary>
    public const int GuestId = -1;

    private int _nextId;

    public SceneObjects() => Parts = new ScenePartQueries(this);

    /// <summary>Whether every slot is its id.</summary>
    public bool IsDirect { get; private set; } = true;

    /// <summary>Whether the next object needs the arrays closed up first; slots change.</summary>
    public bool ShouldCloseUp =>
        (End == Ids.Length && Count < End / 2) || (End == BoundsTable.IdLimit && Count < End);

    /// <summary>Makes room for one more object; nothing changes if there is no memory for it.</summary>
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
        if (shape.Kind == AnyShapeKind.Convex) Parts.Remove(slot);
        else Parts.Set(slot, shape);
        Shapes[slot] = AnyShape.ConvexOf(shape);
        Bounds[slot] = bounds;
        MovedAfter[slot] = _shapedAfter[slot] = _anyShapedAfter = call;
    }

    /// <summary>Puts a shape that is none of the scene's beside the objects while a question is asked about it: a
    /// moving body whose id is <see cref="GuestId"/>, which no finder meets.</summary>
    /// <returns>Its slot, the first that is free.</returns>
    public int Invite(in ConvexShape shape, in RigidPose pose, in ShapeBounds bounds)
    {
        if (End == Ids.Length) Grow();
        Shapes[End] = shape;
        Poses[End] = pose;
        Bounds[End] = bounds;
        Settings[End] = default;
        Ids[End] = GuestId;
        return End;
    }

    /// <summary>Lets go of the guest's shape.</summary>
    public void Dismiss() => Shapes[End] = default;

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

    /// <summary>Whether at most half of the objects have moved since a call: else it does not pay to look which pairs
    /// rest.</summary>
    public bool MostRest(long call)
    {
        int moved = 0;
        for (int slot = 0; slot < End; slot++)
            if (MovedAfter[slot] >= call) moved++;
        return moved <= End / 2;
    }

    /// <summary>Whether neither object of a pair has moved since a call.</summary>
    public bool Rest(ObjectPair pair, long call) => MovedAfter[pair.A] < call && MovedAfter[pair.B] < call;

    /// <summary>Whether both objects of a pair have had their shapes since before a call.</summary>
    public bool KeepShapes(ObjectPair pair, long call) =>
        _anyShapedAfter < call || (_shapedAfter[pair.A] < call && _shapedAfter[pair.B] < call);

    /// <summary>Gives the i-th pair the answer that it had in the last frame, if neither object has moved
    /// since.</summary>
    public bool TryKeep<T>(PairAnswers<T> answers, ObjectPair pair, int i, ref int last)
        where T : struct =>
        answers.KnowsAny && Rest(pair, answers.LastCall) && answers.TryKeep(i, ref last);

    /// <summary>Whether a question sees the object in a slot.</summary>
    public bool IsSeen(int slot, in QueryFilter filter) => filter.Sees(Ids[slot], Settings[slot]);

    /// <summary>Lets go of the hull, too.</summary>
    public void Remove(int slot)
    {
        Alive[slot] = false;
        Shapes[slot] = default;
        Parts.Remove(slot);
        Count--;
    }

    /// <summary>The slot of an id, or -1 where there is no such object.</summary>
    public int SlotOf(int id)
    {
        int slot = IsDirect ? id : Array.BinarySearch(Ids, 0, End, id);
        return (uint)slot < (uint)End && Alive[slot] ? slot : -1;
    }

    /// <summary>The slot of an id that the caller gave as an argument.</summary>
    public int Checked(int id, string name)
    {
        int slot = SlotOf(id);
        if (slot >= 0) return slot;
        bool wasThere = id >= 0 && id < _nextId;
        throw new ArgumentOutOfRangeException(
            name, id, wasThere ? "The object with this id was removed." : "There was never an object with this id.");
    }

    /// <summary>Moves the objects together.</summary>
    public void CloseUp()
    {
        int kept = 0;
        for (int slot = 0; slot < End; slot++)
        {
            if (!Alive[slot]) continue;
            Shapes[kept] = Shapes[slot];
            Parts.Move(slot, kept);
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
        Parts.Reserve();
        Array.Resize(ref Poses, capacity);
        Array.Resize(ref Bounds, capacity);
        Array.Resize(ref Settings, capacity);
        Array.Resize(ref MovedAfter, capacity);
        Array.Resize(ref _shapedAfter, capacity);
        Array.Resize(ref Alive, capacity);

        // Last: its length says that there is room in all of them.
        Array.Resize(ref Ids, capacity);
    }
}
