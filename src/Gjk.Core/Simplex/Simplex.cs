using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// One to four vertices of the Minkowski difference. A is the newest, as in Muratori's drawings (2006); a triangle is kept wound so that
/// (B - A) × (C - A) points away from the origin.
/// </summary>
/// <remarks>
/// The steps of the algorithm read and reorder coordinates only. What a vertex was made from stays in the slot that it was given, so that
/// reordering moves 32 bytes a vertex.
/// </remarks>
internal unsafe struct Simplex
{
    public SimplexVertex A, B, C, D;
    public int Count;

    private fixed double _onA[12];
    private fixed int _ids[8];

    /// <summary>Makes the vertex the newest one, A; there must be room.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Push(in MinkowskiVertex vertex)
    {
        int slot = FreeSlot();
        _onA[3 * slot] = vertex.OnA.X;
        _onA[3 * slot + 1] = vertex.OnA.Y;
        _onA[3 * slot + 2] = vertex.OnA.Z;
        _ids[2 * slot] = vertex.IdA;
        _ids[2 * slot + 1] = vertex.IdB;
        D = C;
        C = B;
        B = A;
        A.W = vertex.W;
        A.Slot = slot;
        Count++;
    }

    public readonly Vector3D OnA(int slot) => new(_onA[3 * slot], _onA[3 * slot + 1], _onA[3 * slot + 2]);

    public readonly int IdA(int slot) => _ids[2 * slot];

    public readonly int IdB(int slot) => _ids[2 * slot + 1];

    /// <summary>The vertex by position: 0 is A, 3 is D.</summary>
    public readonly SimplexVertex this[int index] => index switch { 0 => A, 1 => B, 2 => C, _ => D };

    /// <summary>The weighted sum of A's support points.</summary>
    public readonly Vector3D PointOnA(in Weights w)
    {
        Vector3D point = OnA(A.Slot) * w.A;
        if (Count > 1) point += OnA(B.Slot) * w.B;
        if (Count > 2) point += OnA(C.Slot) * w.C;
        if (Count > 3) point += OnA(D.Slot) * w.D;
        return point;
    }

    /// <summary>The lowest slot that no vertex holds: the slots of the first Count vertices are a subset of 0..3.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly int FreeSlot()
    {
        int used = 0;
        if (Count > 0) used = 1 << A.Slot;
        if (Count > 1) used |= 1 << B.Slot;
        if (Count > 2) used |= 1 << C.Slot;
        return (used & 1) == 0 ? 0 : (used & 2) == 0 ? 1 : (used & 4) == 0 ? 2 : 3;
    }
}

/// <summary>A vertex of a simplex: its place in the Minkowski difference and the slot that remembers its support points.</summary>
internal struct SimplexVertex
{
    public Vector3D W;
    public int Slot;
}
