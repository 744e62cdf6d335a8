namespace Gjk.Core;

/// <summary>Powers of two, by which a product rounds nothing.</summary>
internal static class PowerOfTwo
{
    private const long ExponentBits = 0x7FF0000000000000L;

    /// <summary>The largest power of two that is not above x.</summary>
    /// <param name="x">A positive number in the normal range of double.</param>
    public static double AtMost(double x) =>
        BitConverter.Int64BitsToDouble(BitConverter.DoubleToInt64Bits(x) & ExponentBits);
}
