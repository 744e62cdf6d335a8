namespace Gjk.Exact.Oracle;

/// <summary>Between doubles and integers times powers of two.</summary>
public static class Dyadic
{
    private const int MantissaBits = 52;

    /// <summary>What 0 has instead of an exponent: no constraint on the common one.</summary>
    public const int NoExponent = int.MaxValue;

    /// <summary>x = mantissa · 2^exponent with an odd mantissa, or zero.</summary>
    public static int Exponent(double x)
    {
        Split(x, out long mantissa, out int exponent);
        return mantissa == 0 ? NoExponent : exponent;
    }

    /// <summary>x / 2^exponent, which must be an integer.</summary>
    public static BigInteger ToInteger(double x, int exponent)
    {
        Split(x, out long mantissa, out int own);
        if (mantissa == 0) return BigInteger.Zero;
        if (own < exponent) throw new ArgumentException($"{x:R} is not a multiple of 2^{exponent}.");
        return (BigInteger)mantissa << (own - exponent);
    }

    /// <summary>m · 2^exponent, rounded to the nearest double.</summary>
    public static double ToDouble(BigInteger m, int exponent)
    {
        int excess = (int)BigInteger.Abs(m).GetBitLength() - 63;
        if (excess <= 0) return Math.ScaleB((long)m, exponent);
        BigInteger top = BigInteger.Abs(m) >> excess;
        if ((top << excess) != BigInteger.Abs(m)) top |= BigInteger.One;
        return Math.ScaleB((long)top * m.Sign, exponent + excess);
    }

    /// <summary>m / denominator · 2^exponent, to double rounding.</summary>
    public static double ToDouble(BigInteger m, BigInteger denominator, int exponent)
    {
        // The quotient keeps 64 bits or more.
        int shift = Math.Max(0, 64 + (int)denominator.GetBitLength() - (int)BigInteger.Abs(m).GetBitLength());
        return ToDouble((m << shift) / denominator, exponent - shift);
    }

    private static void Split(double x, out long mantissa, out int exponent)
    {
        long bits = BitConverter.DoubleToInt64Bits(x);
        int biased = (int)(bits >> MantissaBits) & 0x7FF;
        if (biased == 0x7FF) throw new ArgumentException("Not finite.", nameof(x));
        long fraction = bits & ((1L << MantissaBits) - 1);
        long m = biased == 0 ? fraction : fraction | (1L << MantissaBits);
        exponent = Math.Max(biased, 1) - 1075;
        if (m != 0)
        {
            int zeros = BitOperations.TrailingZeroCount(m);
            m >>= zeros;
            exponent += zeros;
        }

        mantissa = bits < 0 ? -m : m;
    }
}
