namespace Gjk.Core.Tests.BroadPhase;

/// <summary>Lists of packed pairs, against lists of pairs in the hands of LINQ.</summary>
public class PairKeysTests
{
    [Fact]
    public void AKeyHoldsTheLesserNumberFirst()
    {
        ulong key = PairKeys.Key(7, 3);
        Assert.Equal(key, PairKeys.Key(3, 7));
        Assert.Equal((3, 7), (PairKeys.First(key), PairKeys.Second(key)));
        int most = BoundsTable.IdLimit - 1;
        Assert.Equal((0, most), (PairKeys.First(PairKeys.Key(most, 0)), PairKeys.Second(PairKeys.Key(most, 0))));
    }

    /// <summary>Few pairs of many objects, many pairs of few, and all pairs of one object.</summary>
    [Theory]
    [InlineData(1000, 10)]
    [InlineData(1000, 124)]
    [InlineData(1000, 5000)]
    [InlineData(30, 5000)]
    [InlineData(2, 100)]
    public void SortingGivesEachPairInOrder(int objects, int count)
    {
        PairKeys keys = Random(1, objects, count, out List<ObjectPair> pairs);
        keys.Sort(objects);
        Assert.Equal(pairs.Order(), Pairs(keys));
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(0, 50)]
    [InlineData(50, 0)]
    [InlineData(300, 40)]
    public void MergingGivesTheUnionInOrder(int first, int second)
    {
        // Of even and of odd second numbers, so that no pair is in both.
        PairKeys a = Disjoint(2, first, 0), b = Disjoint(3, second, 1);
        ObjectPair[] expected = [.. Pairs(a).Concat(Pairs(b)).Order()];
        a.Merge(b);
        Assert.Equal(expected, Pairs(a));
    }

    [Fact]
    public void MoreThanTheLimitIsRefusedAndNothingIsLost()
    {
        var keys = new PairKeys { Limit = 20 };
        for (int i = 0; i < keys.Limit; i++) keys.Add(PairKeys.Key(i, i + 1));
        Assert.Throws<InvalidOperationException>(() => keys.Add(PairKeys.Key(100, 101)));
        Assert.Throws<InvalidOperationException>(() => keys.Merge(Disjoint(1, 1, 0)));
        Assert.Equal(Enumerable.Range(0, 20).Select(i => new ObjectPair(i, i + 1)), Pairs(keys));
    }

    private static PairKeys Disjoint(ulong seed, int count, int parity)
    {
        var keys = new PairKeys();
        Random(seed, 500, count, out List<ObjectPair> drawn);
        foreach (ObjectPair pair in drawn.Distinct()) keys.Add(PairKeys.Key(pair.A, 1000 + 2 * pair.B + parity));
        keys.Sort(3000);
        return keys;
    }

    private static PairKeys Random(ulong seed, int objects, int count, out List<ObjectPair> pairs)
    {
        var rng = new Rng(seed);
        var keys = new PairKeys();
        pairs = [];
        while (pairs.Count < count)
        {
            int a = rng.Below(objects), b = rng.Below(objects);
            if (a == b) continue;
            keys.Add(PairKeys.Key(a, b));
            pairs.Add(new ObjectPair(Math.Min(a, b), Math.Max(a, b)));
        }

        return keys;
    }

    private static List<ObjectPair> Pairs(PairKeys keys)
    {
        var pairs = new List<ObjectPair>();
        keys.CopyTo(pairs);
        return pairs;
    }
}
