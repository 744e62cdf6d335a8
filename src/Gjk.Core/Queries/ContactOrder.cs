namespace Gjk.Core;

/// <summary>Which of several contacts of a motion is the first: the one with the least fraction as it was solved; of
/// those at the start the deepest.</summary>
internal readonly struct ContactOrder(double solved, CastStatus status, float depth) : IComparable<ContactOrder>
{
    /// <summary>Count: bits of a fraction that are left out. Two parts that are met at once are solved to some 2^-45 of
    /// it, and 2^-40 is 2^-16 of what a float tells apart: two bits more or less are far from both. Without any,
    /// CastSeamTests fails.</summary>
    private const int LeftOut = 12;

    private readonly double _depth = status == CastStatus.OverlappingAtStart ? depth : -1;

    /// <summary>The fraction, or a ray's distance, as two parts' are compared.</summary>
    public double Solved { get; } = Rounded(solved);

    public int CompareTo(ContactOrder other)
    {
        int order = Solved.CompareTo(other.Solved);
        return order != 0 ? order : other._depth.CompareTo(_depth);
    }

    private static double Rounded(double x)
    {
        if (!(x > 0) || double.IsInfinity(x)) return x;
        long half = 1L << (LeftOut - 1);
        return BitConverter.Int64BitsToDouble((BitConverter.DoubleToInt64Bits(x) + half) & -(2 * half));
    }
}
