namespace Gjk.Core;

/// <summary>The size of rounding errors, and rounding in one direction.</summary>
internal static class RoundOff
{
    /// <summary>2^-53: half a unit in the last place of a double; what one operation can lose, relative to its result
    /// (proofs/unit.g).</summary>
    public const double Unit = 1.0 / (1L << 53);

    /// <summary>The largest float that is not above x: a bound may be rounded in one direction only.</summary>
    public static float Down(double x)
    {
        float f = (float)x;
        if (f <= x) return f;
        if (float.IsInfinity(f)) return float.MaxValue;
        int bits = Bits(f);
        return FromBits(f > 0 ? bits - 1 : f < 0 ? bits + 1 : unchecked((int)0x80000001));
    }

    /// <summary>The float after a number that is not negative; +infinity stays.</summary>
    public static float Up(float x) => float.IsInfinity(x) ? x : FromBits(Bits(x + 0f) + 1);

    private static unsafe int Bits(float f) => *(int*)&f;

    private static unsafe float FromBits(int bits) => *(float*)&bits;
}
