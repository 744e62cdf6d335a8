using System.Runtime.CompilerServices;
#if NET
using System.Diagnostics;
using System.Runtime.Intrinsics;
#endif

namespace Gjk.Core;

/// <summary>
/// One to four vertices of the Minkowski difference. A is the newest, as in Muratori's drawings (2006); a triangle is
/// kept wound so that (B - A) × (C - A) points away from the origin.
/// </summary>
/// <remarks>
/// A vertex is written once, into a slot; A, B, C and D are slot numbers, so that reordering moves four small integers.
/// Coordinates are written and read one double at a time: a wide load of what narrow stores have just written would
/// wait for them to leave the core.
/// </remarks>
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
    public readonly Double3 W(int slot) => new(_w[4 * slot], _w[4 * slot + 1], _w[4 * slot + 2]);

    /// <summary>The support point of A that it was made from.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Double3 OnA(int slot) => new(_onA[4 * slot], _onA[4 * slot + 1], _onA[4 * slot + 2]);

    /// <summary>The support point of B that it was made from, from B's centre in B's own axes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Double3 OnB(int slot) => new(_onB[4 * slot], _onB[4 * slot + 1], _onB[4 * slot + 2]);

    public readonly int IdA(int slot) => _ids[2 * slot];

    public readonly int IdB(int slot) => _ids[2 * slot + 1];

    /// <summary>An empty simplex; the contents of the slots are not cleared where the runtime lets them be.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Begin(out Simplex simplex)
    {
#if NET
        Unsafe.SkipInit(out simplex);
        simplex.Clear();
#else
        simplex = default;
#endif
    }

    /// <summary>No vertices, and slot numbers that are some, so that nothing can be read out of bounds.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Clear() => A = B = C = D = Count = 0;

    /// <summary>
    /// Makes w, a vertex of A - B made from a support point of each, the newest one, A; there must be room.
    /// </summary>
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
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Fill(int slot, in Double3 w, in Double3 onA, in Double3 onB, int idA, int idB)
    {
        _w[4 * slot] = w.X;
        _w[4 * slot + 1] = w.Y;
        _w[4 * slot + 2] = w.Z;
        _onA[4 * slot] = onA.X;
        _onA[4 * slot + 1] = onA.Y;
        _onA[4 * slot + 2] = onA.Z;
        _onB[4 * slot] = onB.X;
        _onB[4 * slot + 1] = onB.Y;
        _onB[4 * slot + 2] = onB.Z;
        _ids[2 * slot] = idA;
        _ids[2 * slot + 1] = idB;
    }

#if NET
    /// <inheritdoc cref="Fill(int, in Double3, in Double3, in Double3, int, int)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Fill(
        int slot, Vector256<double> w, Vector256<double> onA, Vector256<double> onB, int idA, int idB)
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
    public void Select(int count, int a, int b, int c, int d)
    {
        Count = count;
        A = a;
        B = b;
        C = c;
        D = d;
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

    /// <summary>The weighted sum of A's support points.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Xyz PointOnA(in Weights w)
    {
        Xyz point = XyzOnA(A) * w.A;
        if (Count > 1) point += XyzOnA(B) * w.B;
        if (Count > 2) point += XyzOnA(C) * w.C;
        if (Count > 3) point += XyzOnA(D) * w.D;
        return point;
    }

    /// <summary>The weighted sum of B's support points, from B's centre in B's own axes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Xyz PointOnB(in Weights w)
    {
        Xyz point = XyzOnB(A) * w.A;
        if (Count > 1) point += XyzOnB(B) * w.B;
        if (Count > 2) point += XyzOnB(C) * w.C;
        if (Count > 3) point += XyzOnB(D) * w.D;
        return point;
    }

#if NET
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly Xyz XyzOnA(int slot) => Load(_onA[0], slot);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly Xyz XyzOnB(int slot) => Load(_onB[0], slot);

    /// <summary>A last lane that no writer has cleared may hold a denormal number, whose products are slow.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Xyz Load(in double points, int slot)
    {
        Debug.Assert((uint)slot < 4);
        return Vector256.LoadUnsafe(in points, (nuint)(4 * slot)) & Vector256.Create(-1L, -1, -1, 0).AsDouble();
    }
#else
    private readonly Xyz XyzOnA(int slot) => OnA(slot);

    private readonly Xyz XyzOnB(int slot) => OnB(slot);
#endif
}
