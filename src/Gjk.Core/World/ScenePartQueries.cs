namespace Gjk.Core;

/// <summary>The objects of a scene that are not convex, and the queries about them. A job first queries the convex
/// pairs; there an object that is not convex is invalid input. Then it queries the others here, with a scratch of its
/// own.</summary>
internal sealed class ScenePartQueries(SceneObjects objects)
{
    /// <summary>By slot; empty while all objects are convex.</summary>
    private AnyShape[] _shapes = [];

    private readonly ConcaveScratch _scratches = new();

    /// <summary>Whether there has been an object that is not convex.</summary>
    public bool Any { get; private set; }

    /// <summary>How many pairs one share of a job has. Pairs of surfaces cost far more than convex ones.</summary>
    public int ShareLength => Any ? PairBatch.ConcaveShareLength : PairBatch.ShareLength;

    /// <summary>Whether the object in a slot is not convex.</summary>
    public bool Contains(int slot) => Any && objects.Shapes[slot].Kind == ShapeKind.None;

    /// <summary>Whether an object of a pair is not convex.</summary>
    public bool Contains(ObjectPair pair) => Contains(pair.A) || Contains(pair.B);

    /// <summary>The shape in a slot, convex or not.</summary>
    public AnyShape this[int slot] => Contains(slot) ? _shapes[slot] : AnyShape.Of(objects.Shapes[slot]);

    public void Set(int slot, in AnyShape shape)
    {
        Any = true;
        Reserve();
        _shapes[slot] = shape;
    }

    /// <summary>Makes room for every slot.</summary>
    public void Reserve()
    {
        if (Any && _shapes.Length < objects.Shapes.Length) Array.Resize(ref _shapes, objects.Shapes.Length);
    }

    public void Remove(int slot)
    {
        if (Any) _shapes[slot] = default;
    }

    public void Move(int from, int to)
    {
        if (!Any || from == to) return;
        (_shapes[to], _shapes[from]) = (_shapes[from], default);
    }

    public ConcaveScratch Rent() => _scratches.Rent();

    /// <summary>A scratch; null while all objects are convex.</summary>
    public ConcaveScratch? RentIfAny() => Any ? Rent() : null;

    public void Return(ConcaveScratch? scratch)
    {
        if (scratch is not null) _scratches.Return(scratch);
    }

    public PairDistance Distance(ObjectPair pair, float maxDistance, ConcaveScratch scratch) =>
        ConcaveQuery.Distance(
            this[pair.A], objects.Poses[pair.A], this[pair.B], objects.Poses[pair.B], scratch, maxDistance);

    /// <summary>The distance between two objects, convex or not.</summary>
    public PairDistance Distance(int a, int b, float maxDistance)
    {
        if (!Contains(a) && !Contains(b))
        {
            return new PairDistance(
                ConvexQuery.Distance(
                    objects.Shapes[a], objects.Poses[a], objects.Shapes[b], objects.Poses[b], maxDistance));
        }

        ConcaveScratch scratch = Rent();
        PairDistance found = Distance(new ObjectPair(a, b), maxDistance, scratch);
        Return(scratch);
        return found;
    }

    /// <summary>Where a ray meets an object, convex or not.</summary>
    public RayHit RayCast(int slot, in RayQuery ray, in CastOptions options, RaySides sides)
    {
        if (!Contains(slot))
        {
            RayCastResult convex = ConvexQuery.RayCast(
                objects.Shapes[slot], objects.Poses[slot], ray.Origin, ray.Direction, ray.MaxDistance, options, sides);
            return new RayHit(convex);
        }

        ConcaveScratch scratch = Rent();
        RayHit found = ConcaveQuery.RayCast(
            _shapes[slot], objects.Poses[slot], ray.Origin, ray.Direction, scratch, ray.MaxDistance, options, sides);
        Return(scratch);
        return found;
    }

    public CastHit Cast(
        in ConvexShape shape, in RigidPose pose, Vector3 translation, int slot, float maxFraction,
        in CastOptions options)
    {
        ConcaveScratch scratch = Rent();
        CastHit found = ConcaveQuery.Cast(
            AnyShape.Of(shape), pose, translation, _shapes[slot], objects.Poses[slot], Vector3.Zero, scratch,
            maxFraction, options);
        Return(scratch);
        return found;
    }

    /// <summary>The distances of all pairs of parts of two objects that are near.</summary>
    public void FindDistances(
        ObjectPair pair, float maxDistance, ConcaveScratch scratch, List<PairDistance> distances)
    {
        ConcaveQuery.FindPairsWithin(
            this[pair.A], objects.Poses[pair.A], this[pair.B], objects.Poses[pair.B], maxDistance, scratch, distances);
        for (int i = 0; i < distances.Count; i++) distances[i] = distances[i].WithPair(objects.IdsOf(pair));
    }

    /// <summary>The depths of all pairs of parts of two objects.</summary>
    public void FindDepths(ObjectPair pair, ConcaveScratch scratch, List<PairDistance> depths)
    {
        ConcaveQuery.FindDepths(
            this[pair.A], objects.Poses[pair.A], this[pair.B], objects.Poses[pair.B], scratch, depths);
        for (int i = 0; i < depths.Count; i++) depths[i] = depths[i].WithPair(objects.IdsOf(pair));
    }

    /// <summary>The contacts of all pairs of parts of two objects.</summary>
    public void FindContacts(ObjectPair pair, float maxGap, ConcaveScratch scratch, List<PairContacts> contacts)
    {
        ConcaveQuery.FindContacts(
            this[pair.A], objects.Poses[pair.A], this[pair.B], objects.Poses[pair.B], maxGap, scratch, contacts);
        for (int i = 0; i < contacts.Count; i++) contacts[i] = contacts[i].WithPair(objects.IdsOf(pair));
    }
}
