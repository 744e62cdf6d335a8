namespace Gjk.Core;

/// <summary>A vector with a 0 behind it, so that it can be read as a register of four doubles.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal struct LaneVector(in Double3 v)
{
    public double X = v.X, Y = v.Y, Z = v.Z, End = 0;

    public readonly Double3 Xyz
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(X, Y, Z);
    }

#if NET
    public readonly Vector256<double> Lanes
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Vector256.LoadUnsafe(in X);
    }
#endif
}
