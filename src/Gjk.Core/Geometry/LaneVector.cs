namespace Gjk.Core;

/// <summary>A vector with a 0 behind it, so that it can be read as a register of four doubles.</summary>
internal struct LaneVector
{
    public Double3 Xyz;
    public double End;

#if NET
    public readonly Vector256<double> Lanes
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Vector256.LoadUnsafe(in Xyz.X);
    }
#endif

    /// <summary>The vector from one point to another, written in place.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Between(in Double3 from, in Double3 to, out LaneVector vector)
    {
        Double3.Write(to.X - from.X, to.Y - from.Y, to.Z - from.Z, out vector.Xyz);
        vector.End = 0;
    }
}
