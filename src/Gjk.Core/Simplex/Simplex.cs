namespace Gjk.Core;

/// <summary>One to four vertices of the Minkowski difference. A is the newest, as in Muratori's drawings (2006); a
/// triangle is kept wound so that (B - A) × (C - A) points away from the origin.</summary>
/// <remarks>A vertex is written once, into a slot; A, B, C and D are slot numbers, so that reordering moves four small
/// integers. Coordinates are written and read one double at a time: a wide load of what narrow stores have just written
/// would wait for them to leave the core.</remarks>
internal unsafe struct Simplex
{
    /// <summary>The slots of the vertices, newest first.</summary>
    public int A, B, C, D;

    /// <summary>How many of A, B, C, D are vertices.</summary>
    public int Count;

    // The slots; reached by number.
    private DifferenceVertex _first, _second, _third, _fourth;

    public readonly ref readonly Double3 WA => ref W(A);

    public readonly ref readonly Double3 WB => ref W(B);

    public readonly ref readonly Double3 WC => ref W(C);

    public readonly ref readonly Double3 WD => ref W(D);

    /// <summary>The slot by position: 0 is A, 3 is D.</summary>
    public readonly int this[int index] => index switch { 0 => A, 1 => B, 2 => C, _ => D };

    /// <summary>The vertex in a slot, with its support points.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly ref DifferenceVertex At(int slot)
    {
        Debug.Assert((uint)slot < 4);
        return ref UnsafeRef.At(_first, slot);
    }

    /// <summary>The vertex in a slot: a point of A - B, in A's frame.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly ref readonly Double3 W(int slot) => ref At(slot).W;

    /// <summary>The same with its slot, number by number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Get(int slot, out MinkowskiVertex vertex)
    {
        ref readonly Double3 w = ref W(slot);
        vertex.X = w.X;
        vertex.Y = w.Y;
        vertex.Z = w.Z;
        vertex.Slot = slot;
    }

    /// <summary>The support point of A that it was made from.</summary>
    public readonly ref readonly Double3 OnA(int slot) => ref At(slot).OnA;

    /// <summary>The support point of B that it was made from, from B's centre in B's own axes.</summary>
    public readonly ref readonly Double3 OnB(int slot) => ref At(slot).OnB;

    public readonly int IdA(int slot) => At(slot).IdA;

    public readonly int IdB(int slot) => At(slot).IdB;

    /// <summary>Makes an empty simplex. The slots are not cleared where the runtime allows it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Make(out Simplex simplex)
    {
        UnsafeRef.SkipInit(out simplex);
        simplex.Clear();
    }

    /// <summary>Removes all vertices. The slot numbers become 0, so that nothing is read out of bounds.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Clear() => A = B = C = D = Count = 0;

    /// <summary>Adds a vertex w of A - B with the support points that it is made of; it becomes the newest one, A.
    /// There must be room.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Push(in Double3 w, in Double3 onA, in Double3 onB, int idA, int idB)
    {
        int slot = FreeSlot;
        Fill(slot, w, onA, onB, idA, idB);
        Push(slot);
    }

    /// <summary>Makes the vertex in a free slot the newest one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Push(int slot)
    {
        D = C;
        C = B;
        B = A;
        A = slot;
        Count++;
    }

    /// <summary>Writes a vertex of A - B, and the support points that it is made from, into a slot.</summary>
    public void Fill(int slot, in Double3 w, in Double3 onA, in Double3 onB, int idA, int idB) =>
        At(slot).Set(w, onA.ToXyz(), onB.ToXyz(), idA, idB);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Select(int count, int a, int b, int c, int d)
    {
        Count = count;
        A = a;
        B = b;
        C = c;
        D = d;
    }

    /// <summary>The witness point on A: the weighted sum of its support points.</summary>
    public readonly Double3 WitnessOnA(in Weights w)
    {
        WitnessPoints(w, out Xyz point, out _);
        return point.ToDouble3();
    }

    /// <summary>The lowest slot that no vertex holds.</summary>
    public readonly int FreeSlot
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            int used = Count > 0 ? 1 << A : 0;
            if (Count > 1) used |= 1 << B;
            if (Count > 2) used |= 1 << C;
            return (used & 1) == 0 ? 0 : (used & 2) == 0 ? 1 : (used & 4) == 0 ? 2 : 3;
        }
    }

    /// <summary>The weighted sum of the vertices.</summary>
    public readonly Double3 PointOf(in Weights w)
    {
        Double3 point = WA * w.A;
        if (Count > 1) point += WB * w.B;
        if (Count > 2) point += WC * w.C;
        if (Count > 3) point += WD * w.D;
        return point;
    }

    /// <summary>The witness points on A and B: the weighted sums of the support points.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void WitnessPoints(in Weights w, out Xyz onA, out Xyz onB)
    {
        At(A).OnA.Load().Times(w.A, out onA);
        At(A).OnB.Load().Times(w.A, out onB);
        if (Count > 1) At(B).AddTo(w.B, ref onA, ref onB);
        if (Count > 2) At(C).AddTo(w.C, ref onA, ref onB);
        if (Count > 3) At(D).AddTo(w.D, ref onA, ref onB);
    }
}

/// <summary>A vertex of A - B, with the support points that it is made from; each can be read as four lanes.</summary>
internal struct DifferenceVertex
{
    public Double3 W;

    /// <summary>The support points' ids, negative where one has none.</summary>
    public int IdA, IdB;

    /// <summary>From A's centre.</summary>
    public Double3 OnA;

    private readonly double _endA;

    /// <summary>From B's centre, in B's own axes.</summary>
    public Double3 OnB;

    private readonly double _endB;

    /// <summary>Writes all fields. A register is a double wider than a point, and writes the field behind it,
    /// too.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Set(in Double3 w, in Xyz onA, in Xyz onB, int idA, int idB)
    {
        Double3.Write(w.X, w.Y, w.Z, out W);
        onA.Store(out OnA);
        onB.Store(out OnB);
        IdA = idA;
        IdB = idB;
    }

    /// <summary>Adds the support points times a weight.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void AddTo(double weight, ref Xyz onA, ref Xyz onB)
    {
        onA.Plus(OnA.Load(), weight, out onA);
        onB.Plus(OnB.Load(), weight, out onB);
    }
}
