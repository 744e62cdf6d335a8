namespace Gjk.Core;

/// <summary>Directions have any length. These methods scale one to unit size by a power of two, which rounds nothing,
/// before it is squared.</summary>
internal static class DirectionRange
{
    /// <summary>2^600 brings denormal numbers, which have no power of two of their own, into the normal
    /// range.</summary>
    private const double Raise = 4.149515568880993e180;

    /// <summary>Numbers below it are raised first.</summary>
    private const double Small = 1e-150;

    /// <summary>Sums of components between which no product with a number of ordinary size has overflowed or become a
    /// denormal number. Pinned by DirectionLengthTests.</summary>
    private const double LeastSize = 1e-200, MostSize = 1e200;

    /// <summary>Sizes between which a dot product of a direction of any length has lost nothing to the limits of
    /// double.</summary>
    public const double LeastDot = 1e-270, MostDot = 1e300;

    /// <summary>Whether a dot product can be trusted; false for 0, which may be what is left of a tiny one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsSafe(double dot) => Math.Abs(dot) > LeastDot && Math.Abs(dot) < MostDot;

    /// <summary>The direction itself, or brought to unit size where its products with numbers of ordinary size could
    /// leave the range of double.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double3 ToSafe(in Double3 direction) => IsOrdinary(direction) ? direction : ToUnit(direction);

    /// <summary>Whether no product of a vector with a number of ordinary size leaves the range of double.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsOrdinary(in Double3 v)
    {
        double size = v.SumOfMagnitudes;
        return size > LeastSize && size < MostSize;
    }

    /// <summary>The same direction with its largest component between 1 and 2; unchanged when it is zero, infinite or
    /// NaN.</summary>
    public static Double3 ToUnit(in Double3 direction)
    {
        Double3 d = direction;
        double largest = d.LargestMagnitude;
        if (!(largest > 0 && largest <= double.MaxValue)) return d;
        if (largest < Small)
        {
            d *= Raise;
            largest *= Raise;
        }

        double factor = 0.5 / PowerOfTwo.AtMost(largest);
        return d * factor * 2;
    }

    /// <summary>The same in a plane.</summary>
    public static void ToUnit(ref double x, ref double z)
    {
        Double3 d = ToUnit(new Double3(x, 0, z));
        x = d.X;
        z = d.Z;
    }
}
