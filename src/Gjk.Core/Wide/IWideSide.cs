#if NET
using static Gjk.Core.WideLanes;
using Lanes = System.Runtime.Intrinsics.Vector256<double>;

namespace Gjk.Core;

/// <summary>The first, or the second, shapes of four pairs.</summary>
internal interface IWideSide
{
    /// <summary>Takes a shape, which is known to be of the side's kind, into a lane.</summary>
    void Load(int lane, in ConvexShape shape);

    /// <summary>The furthest vertex of each, measured from its centre, and its slot.</summary>
    /// <param name="direction">A direction for each.</param>
    /// <param name="live">One bit for each lane whose answer is wanted. The others, whose directions have not changed,
    /// answer as before.</param>
    /// <param name="slots">Names the vertices, for <see cref="Vertex"/>.</param>
    WideVector Support(in WideVector direction, uint live, out Vector256<long> slots);

    /// <summary>The vertices in slots, as <see cref="Support"/> gave them.</summary>
    WideVector Vertex(Vector256<long> slots);

    /// <summary>The ids of the vertices in slots.</summary>
    Vector256<long> IdsOf(Vector256<long> slots);

    /// <summary>The slots of the vertices with these ids, which are 32 bits without a sign.</summary>
    /// <param name="ids">The ids.</param>
    /// <param name="found">The lanes whose shape has no such vertex are taken from it.</param>
    Vector256<long> SlotsOf(Vector256<long> ids, ref Lanes found);
}

/// <summary>Boxes, and meshes that are boxes. A slot is a corner's signs.</summary>
internal unsafe struct WideBoxes : IWideSide
{
    private fixed double _half[12];
    private fixed ulong _corners[4];

    private WideVector Half
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(
            Vector256.LoadUnsafe(ref _half[0]), Vector256.LoadUnsafe(ref _half[4]), Vector256.LoadUnsafe(ref _half[8]));
    }

    private Vector256<ulong> Corners
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Vector256.LoadUnsafe(ref _corners[0]);
    }

    private static Lanes SignBit => Vector256.Create(-0.0);

    public void Load(int lane, in ConvexShape shape)
    {
        shape.Get(out BoxCore box);
        _half[lane] = box.Half.Xyz.X;
        _half[lane + 4] = box.Half.Xyz.Y;
        _half[lane + 8] = box.Half.Xyz.Z;
        _corners[lane] = box.Corners.Packed;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public WideVector Support(in WideVector direction, uint live, out Vector256<long> slots)
    {
        // A zero of either sign counts as positive.
        Lanes x = Vector256.LessThan(direction.X, Lanes.Zero), y = Vector256.LessThan(direction.Y, Lanes.Zero);
        Lanes z = Vector256.LessThan(direction.Z, Lanes.Zero);
        slots = (x.AsInt64() & Vector256.Create(1L)) | (y.AsInt64() & Vector256.Create(2L))
            | (z.AsInt64() & Vector256.Create(4L));
        WideVector half = Half;
        return new WideVector(half.X ^ (x & SignBit), half.Y ^ (y & SignBit), half.Z ^ (z & SignBit));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public WideVector Vertex(Vector256<long> slots)
    {
        WideVector half = Half;
        return new WideVector(
            half.X ^ (Vector256.ShiftLeft(slots, 63).AsDouble() & SignBit),
            half.Y ^ (Vector256.ShiftLeft(slots, 62).AsDouble() & SignBit),
            half.Z ^ (Vector256.ShiftLeft(slots, 61).AsDouble() & SignBit));
    }

    public Vector256<long> IdsOf(Vector256<long> slots) => BoxCorners.Ids(Corners, slots);

    public Vector256<long> SlotsOf(Vector256<long> ids, ref Lanes found)
    {
        found &= Vector256.LessThan(ids, Vector256.Create(8L)).AsDouble();
        return BoxCorners.Signs(Corners, ids);
    }
}

/// <summary>Segments, capsules, points and spheres. A slot is an end's id.</summary>
internal struct WideSegments : IWideSide
{
    private Four<SegmentCore> _cores;
    private WideVector _first, _second, _toFirst;

    public void Load(int lane, in ConvexShape shape)
    {
        shape.Get(out _cores[lane]);
        if (lane < 3) return;
        _first = WideVector.Transpose(_cores[0].Lanes(0), _cores[1].Lanes(0), _cores[2].Lanes(0), _cores[3].Lanes(0));
        _second = WideVector.Transpose(_cores[0].Lanes(1), _cores[1].Lanes(1), _cores[2].Lanes(1), _cores[3].Lanes(1));
        _toFirst = WideVector.Transpose(_cores[0].ToFirst, _cores[1].ToFirst, _cores[2].ToFirst, _cores[3].ToFirst);
    }

    public WideVector Support(in WideVector direction, uint live, out Vector256<long> slots)
    {
        Lanes dot = WideVector.Dot(direction, _toFirst);
        slots = Vector256.LessThan(dot, Lanes.Zero).AsInt64() & Vector256<long>.One;
        uint rest = live & ~AreSafe(dot).ExtractMostSignificantBits();
        for (int lane = 0; rest != 0; lane++, rest >>= 1)
        {
            if ((rest & 1) != 0) slots = slots.WithElement(lane, _cores[lane].SupportId(direction[lane]));
        }

        return Vertex(slots);
    }

    /// <inheritdoc cref="DirectionRange.IsSafe"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes AreSafe(Lanes dot) =>
        Vector256.GreaterThan(Vector256.Abs(dot), Vector256.Create(DirectionRange.LeastDot))
            & Vector256.LessThan(Vector256.Abs(dot), Vector256.Create(DirectionRange.MostDot));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public WideVector Vertex(Vector256<long> slots) =>
        WideVector.Select(Vector256.Equals(slots, Vector256<long>.Zero).AsDouble(), _first, _second);

    public Vector256<long> IdsOf(Vector256<long> slots) => slots;

    public Vector256<long> SlotsOf(Vector256<long> ids, ref Lanes found)
    {
        var counts = Vector256.Create((long)_cores[0].Count, _cores[1].Count, _cores[2].Count, _cores[3].Count);
        return Below(counts, ids, ref found);
    }
}

/// <summary>Triangles. A slot is a corner's id.</summary>
internal struct WideTriangles : IWideSide
{
    private Four<TriangleCore> _cores;
    private WideVector _first, _second, _third, _toSecond, _toThird;

    public void Load(int lane, in ConvexShape shape)
    {
        shape.Get(out _cores[lane]);
        if (lane < 3) return;
        ref TriangleCore a = ref _cores[0], b = ref _cores[1], c = ref _cores[2], d = ref _cores[3];
        _first = WideVector.Transpose(a.Lanes(0), b.Lanes(0), c.Lanes(0), d.Lanes(0));
        _second = WideVector.Transpose(a.Lanes(1), b.Lanes(1), c.Lanes(1), d.Lanes(1));
        _third = WideVector.Transpose(a.Lanes(2), b.Lanes(2), c.Lanes(2), d.Lanes(2));
        _toSecond = WideVector.Transpose(a.ToSecond, b.ToSecond, c.ToSecond, d.ToSecond);
        _toThird = WideVector.Transpose(a.ToThird, b.ToThird, c.ToThird, d.ToThird);
    }

    public WideVector Support(in WideVector direction, uint live, out Vector256<long> slots)
    {
        Lanes second = WideVector.Dot(direction, _toSecond), third = WideVector.Dot(direction, _toThird);
        Lanes isThird = Vector256.GreaterThan(third, Vector256.Max(second, Lanes.Zero));
        slots = Vector256.ConditionalSelect(
            isThird.AsInt64(), Vector256.Create(2L),
            Vector256.GreaterThan(second, Lanes.Zero).AsInt64() & Vector256<long>.One);
        uint rest = live & ~(WideSegments.AreSafe(second) & WideSegments.AreSafe(third)).ExtractMostSignificantBits();
        for (int lane = 0; rest != 0; lane++, rest >>= 1)
        {
            if ((rest & 1) != 0) slots = slots.WithElement(lane, _cores[lane].SupportId(direction[lane]));
        }

        return Vertex(slots);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public WideVector Vertex(Vector256<long> slots) => WideVector.Select(
        Vector256.Equals(slots, Vector256.Create(2L)).AsDouble(), _third,
        WideVector.Select(Vector256.Equals(slots, Vector256<long>.Zero).AsDouble(), _first, _second));

    public Vector256<long> IdsOf(Vector256<long> slots) => slots;

    public Vector256<long> SlotsOf(Vector256<long> ids, ref Lanes found) =>
        Below(Vector256.Create(3L), ids, ref found);
}

/// <summary>Meshes. A slot is a vertex's id. Each lane looks its vertex up by itself.</summary>
internal struct WideHulls : IWideSide
{
    private Four<ConvexHull> _hulls;
    private Vector256<long> _last;
    private Lanes _point0, _point1, _point2, _point3;

    public void Load(int lane, in ConvexShape shape)
    {
        _hulls[lane] = shape.Hull!;
        _last = Vector256<long>.Zero;
    }

    public WideVector Support(in WideVector direction, uint live, out Vector256<long> slots)
    {
        long a = _last.ToScalar(), b = _last.GetElement(1), c = _last.GetElement(2), d = _last.GetElement(3);
        if ((live & 1) != 0) a = Find(_hulls[0], direction[0], ref _point0);
        if ((live & 2) != 0) b = Find(_hulls[1], direction[1], ref _point1);
        if ((live & 4) != 0) c = Find(_hulls[2], direction[2], ref _point2);
        if ((live & 8) != 0) d = Find(_hulls[3], direction[3], ref _point3);
        slots = _last = Vector256.Create(a, b, c, d);
        return WideVector.Transpose(_point0, _point1, _point2, _point3);
    }

    [MethodImpl(Jit.AtOnce | MethodImplOptions.NoInlining)]
    private static int Find(ConvexHull hull, Double3 direction, ref Lanes point)
    {
        point = HullCore.Support(hull, direction, out int id);
        return id;
    }

    public WideVector Vertex(Vector256<long> slots) => WideVector.Transpose(
        HullCore.Lanes(_hulls[0], (int)slots.ToScalar()), HullCore.Lanes(_hulls[1], (int)slots.GetElement(1)),
        HullCore.Lanes(_hulls[2], (int)slots.GetElement(2)), HullCore.Lanes(_hulls[3], (int)slots.GetElement(3)));

    public Vector256<long> IdsOf(Vector256<long> slots) => slots;

    public Vector256<long> SlotsOf(Vector256<long> ids, ref Lanes found)
    {
        var counts = Vector256.Create(
            (long)_hulls[0].VertexCount, _hulls[1].VertexCount, _hulls[2].VertexCount, _hulls[3].VertexCount);
        return Below(counts, ids, ref found);
    }
}

/// <summary>What each of four lanes has.</summary>
[InlineArray(4)]
internal struct Four<T>
{
    private T _first;
}
#endif
