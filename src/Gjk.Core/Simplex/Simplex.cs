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

    private fixed int _ids[8];
    private fixed double _w[16];
    private fixed double _onA[16];
    private fixed double _onB[16];

    public readonly Double3 WA => W(A);

    public readonly Double3 WB => W(B);

    public readonly Double3 WC => W(C);

    public readonly Double3 WD => W(D);

    /// <summary>The slot by position: 0 is A, 3 is D.</summary>
    public readonly int this[int index] => index switch { 0 => A, 1 => B, 2 => C, _ => D };

    /// <summary>The vertex in a slot: a point of A - B, in A's frame.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Double3 W(int slot)
    {
        fixed (double* at = &_w[4 * slot]) return new Double3(at[0], at[1], at[2]);
    }

    /// <summary>The same, written where it is to be.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Get(int slot, out Double3 w)
    {
        fixed (double* at = &_w[4 * slot]) Double3.Write(at[0], at[1], at[2], out w);
    }

    /// <summary>The same with its slot.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Get(int slot, out MinkowskiVertex vertex)
    {
        fixed (double* at = &_w[4 * slot])
        {
            vertex.X = at[0];
            vertex.Y = at[1];
            vertex.Z = at[2];
        }

        vertex.Slot = slot;
    }

    /// <summary>The support point of A that it was made from.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Double3 OnA(int slot)
    {
        fixed (double* at = &_onA[4 * slot]) return new Double3(at[0], at[1], at[2]);
    }

    /// <summary>The support point of B that it was made from, from B's centre in B's own axes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Double3 OnB(int slot)
    {
        fixed (double* at = &_onB[4 * slot]) return new Double3(at[0], at[1], at[2]);
    }

    public readonly int IdA(int slot) => _ids[2 * slot];

    public readonly int IdB(int slot) => _ids[2 * slot + 1];

    /// <summary>An empty simplex; the contents of the slots are not cleared where the runtime lets them be.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Begin(out Simplex simplex)
    {
        Uncleared.Begin(out simplex);
        simplex.Clear();
    }

    /// <summary>No vertices, and slot numbers that are some, so that nothing can be read out of bounds.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Clear() => A = B = C = D = Count = 0;

    /// <summary>Makes w, a vertex of A - B made from a support point of each, the newest one, A; there must be
    /// room.</summary>
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
    [MethodImpl(Jit.Step)]
    public void Fill(int slot, in Double3 w, in Double3 onA, in Double3 onB, int idA, int idB)
    {
        fixed (double* at = &_w[4 * slot]) Write(at, w);
        fixed (double* at = &_onA[4 * slot]) Write(at, onA);
        fixed (double* at = &_onB[4 * slot]) Write(at, onB);
        _ids[2 * slot] = idA;
        _ids[2 * slot + 1] = idB;
    }

#if NET
    /// <inheritdoc cref="Fill(int, in Double3, in Double3, in Double3, int, int)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Fill(int slot, Vector256<double> w, Vector256<double> onA, Vector256<double> onB, int idA, int idB)
    {
        Debug.Assert((uint)slot < 4);
        w.StoreUnsafe(ref _w[0], (nuint)(4 * slot));
        onA.StoreUnsafe(ref _onA[0], (nuint)(4 * slot));
        onB.StoreUnsafe(ref _onB[0], (nuint)(4 * slot));
        _ids[2 * slot] = idA;
        _ids[2 * slot + 1] = idB;
    }
#endif

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Write(double* at, in Double3 v)
    {
        at[0] = v.X;
        at[1] = v.Y;
        at[2] = v.Z;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Select(int count, int a, int b, int c, int d)
    {
        Count = count;
        A = a;
        B = b;
        C = c;
        D = d;
    }

    /// <summary>The weighted sum of A's support points, as a value.</summary>
    public readonly Double3 MeanOnA(in Weights w)
    {
        PointOnA(w, out Xyz point);
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

#if NET
    /// <summary>The weighted sum of A's support points.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void PointOnA(in Weights w, out Xyz point) => Sum(_onA[0], w, out point);

    /// <summary>The weighted sum of B's support points, from B's centre in B's own axes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void PointOnB(in Weights w, out Xyz point) => Sum(_onB[0], w, out point);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly void Sum(in double points, in Weights w, out Xyz point)
    {
        point = Load(points, A) * w.A;
        if (Count > 1) point += Load(points, B) * w.B;
        if (Count > 2) point += Load(points, C) * w.C;
        if (Count > 3) point += Load(points, D) * w.D;
    }

    /// <summary>A last lane that no writer has cleared may hold a denormal number, whose products are slow.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Xyz Load(in double points, int slot)
    {
        Debug.Assert((uint)slot < 4);
        return Vector256.LoadUnsafe(in points, (nuint)(4 * slot)) & Vector256.Create(-1L, -1, -1, 0).AsDouble();
    }
#else
    /// <summary>The weighted sum of A's support points.</summary>
    public readonly void PointOnA(in Weights w, out Xyz point)
    {
        fixed (double* points = _onA) Sum(points, w, out point);
    }

    /// <summary>The weighted sum of B's support points, from B's centre in B's own axes.</summary>
    public readonly void PointOnB(in Weights w, out Xyz point)
    {
        fixed (double* points = _onB) Sum(points, w, out point);
    }

    private readonly void Sum(double* points, in Weights w, out Xyz point)
    {
        double* p = points + 4 * A;
        double x = p[0] * w.A, y = p[1] * w.A, z = p[2] * w.A;
        if (Count > 1) Add(points + 4 * B, w.B, ref x, ref y, ref z);
        if (Count > 2) Add(points + 4 * C, w.C, ref x, ref y, ref z);
        if (Count > 3) Add(points + 4 * D, w.D, ref x, ref y, ref z);
        Double3.Write(x, y, z, out point);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Add(double* p, double weight, ref double x, ref double y, ref double z)
    {
        x += p[0] * weight;
        y += p[1] * weight;
        z += p[2] * weight;
    }
#endif
}
