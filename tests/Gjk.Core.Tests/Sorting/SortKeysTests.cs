namespace Gjk.Core.Tests.Sorting;

/// <summary>Sorting by the upper half of a key, against the sort of LINQ.</summary>
public class SortKeysTests
{
    public static TheoryData<int> Lengths => [0, 1, 2, 100, 511, 512, 513, 5000, 40_000];

    /// <summary>Lower halves that ascend, as objects are listed: the result is sorted by the whole key.</summary>
    [Theory]
    [MemberData(nameof(Lengths))]
    public void KeysInTheOrderOfTheirLowerHalvesEndUpSortedByAllOfIt(int length)
    {
        foreach (uint range in new[] { 3u, 1000u, uint.MaxValue })
        {
            ulong[] keys = Keys(length, range, i => (ulong)i);
            Assert.Equal(keys.Order(), Sorted(keys));
        }
    }

    [Theory]
    [MemberData(nameof(Lengths))]
    public void TheUpperHalvesAscendAndNoKeyIsLost(int length)
    {
        var rng = new Rng(2);
        ulong[] keys = Keys(length, 500, _ => rng.Next() >> 32), sorted = Sorted(keys);
        Assert.Equal(keys.Select(k => k >> 32).Order(), sorted.Select(k => k >> 32));
        Assert.Equal(keys.Order(), sorted.Order());
    }

    [Fact]
    public void OrderedNumbersOrderAsTheFloatsDo()
    {
        var rng = new Rng(3);
        float[] values =
        [
            float.NegativeInfinity, -float.MaxValue, -1, -float.Epsilon, 0, float.Epsilon, 1, float.MaxValue,
            float.PositiveInfinity,
            .. Enumerable.Range(0, 500).Select(_ => BitConverter.UInt32BitsToSingle((uint)rng.Next())),
        ];
        float[] numbers = [.. values.Where(x => !float.IsNaN(x))];
        Assert.Equal(numbers.Order(), numbers.OrderBy(SortKeys.Ordered));
        Assert.Equal(SortKeys.Ordered(0f), SortKeys.Ordered(-0f));
    }

    private static ulong[] Keys(int length, uint range, Func<int, ulong> lower)
    {
        var rng = new Rng(1);
        return [.. Enumerable.Range(0, length).Select(i => rng.Next() % range << 32 | lower(i))];
    }

    private static ulong[] Sorted(ulong[] keys)
    {
        // Longer than what is sorted, as the owners' arrays are.
        ulong[] copy = [.. keys, 1, 2, 3], scratch = new ulong[copy.Length];
        SortKeys.Sort(ref copy, ref scratch, new int[SortKeys.HistogramLength], keys.Length);
        return copy[..keys.Length];
    }
}
