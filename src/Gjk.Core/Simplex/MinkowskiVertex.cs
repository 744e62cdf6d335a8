namespace Gjk.Core;

/// <summary>A vertex of A - B, and the slot of the <see cref="Simplex"/> that holds the support points that it was made
/// from.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal struct MinkowskiVertex(in Double3 w, int slot)
{
    public double X = w.X, Y = w.Y, Z = w.Z;

    /// <summary>As wide as the coordinates, so that the four fit registers without a gap.</summary>
    public long Slot = slot;

    public readonly Double3 W
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(X, Y, Z);
    }

    /// <summary>Takes another's place number by number, which stays in registers where a copy of the whole would
    /// not.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Set(in MinkowskiVertex other)
    {
        X = other.X;
        Y = other.Y;
        Z = other.Z;
        Slot = other.Slot;
    }
}
