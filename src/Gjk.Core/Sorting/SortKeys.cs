namespace Gjk.Core;

/// <summary>Sorts 64-bit keys by their upper half. Where these are equal, keys that come in the order of their lower
/// halves stay in it, so such input ends up sorted by the whole key.</summary>
internal static class SortKeys
{
    public const int DigitBits = 11;

    private const int Digits = 1 << DigitBits;
    private const int Passes = 3;

    /// <summary>Count: below it, clearing the histograms would take longer than a comparison sort.</summary>
    private const int LeastForRadix = 512;

    /// <summary>How long the histogram array must be.</summary>
    public const int HistogramLength = Passes * Digits;

    private const uint SignBit = 0x80000000u;

    /// <summary>A number that orders as the float does, with -0 as 0; not for NaN.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe uint Ordered(float x)
    {
        x += 0f;
        uint bits = *(uint*)&x;
        return (bits & SignBit) != 0 ? ~bits : bits | SignBit;
    }

    /// <summary>Sorts the first n keys. Least significant digit first, three digits of eleven bits.</summary>
    /// <param name="keys">The keys; may be exchanged with the scratch array.</param>
    /// <param name="scratch">As long as the keys.</param>
    /// <param name="histograms">Of <see cref="HistogramLength"/>.</param>
    /// <param name="n">How many keys.</param>
    public static void Sort(ref ulong[] keys, ref ulong[] scratch, int[] histograms, int n)
    {
        if (n < LeastForRadix)
        {
            InPlaceSort.Sort(keys, 0, n);
            return;
        }

        Array.Clear(histograms, 0, HistogramLength);
        for (int i = 0; i < n; i++)
        {
            uint key = (uint)(keys[i] >> 32);
            histograms[key & (Digits - 1)]++;
            histograms[Digits + ((key >> DigitBits) & (Digits - 1))]++;
            histograms[2 * Digits + (key >> (2 * DigitBits))]++;
        }

        for (int pass = 0; pass < Passes; pass++)
        {
            int first = pass * Digits, sum = 0, shift = 32 + pass * DigitBits;
            for (int digit = first; digit < first + Digits; digit++)
                (histograms[digit], sum) = (sum, sum + histograms[digit]);
            for (int i = 0; i < n; i++)
            {
                ulong key = keys[i];
                scratch[histograms[first + (int)((key >> shift) & (Digits - 1))]++] = key;
            }

            (keys, scratch) = (scratch, keys);
        }
    }
}
