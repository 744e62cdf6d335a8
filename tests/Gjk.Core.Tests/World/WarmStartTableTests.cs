using System.Runtime.CompilerServices;
using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests.World;

/// <summary>The table against a dictionary that forgets nothing: what was asked for in this frame or the last must be
/// there, and what is there must be the pair's own.</summary>
public class WarmStartTableTests
{
    [Theory]
    [InlineData(20, 10)]
    [InlineData(500, 60)]
    [InlineData(5000, 2000)]
    public void WhatIsRecentIsRememberedAndNothingIsMixedUp(int pairs, int perFrame)
    {
        var table = new WarmStartTable();
        var model = new Dictionary<ulong, (int Stamp, int Frame)>();
        var rng = new Rng(1);
        ulong[] keys = [.. Enumerable.Range(0, pairs).Select(i => PairKeys.Key(i, i + 1 + rng.Below(9)))];
        int stamps = 0, remembered = 0;
        int firstFrame = int.MaxValue - 5;
        for (int i = 0; i < 40; i++)
        {
            // The frames' count wraps around on the way.
            int frame = unchecked(firstFrame + i);
            for (int k = 0; k < perFrame; k++)
            {
                ulong key = keys[rng.Below(pairs)];
                ref int stamp = ref Stamp(ref table.Find(key, frame));
                bool known = model.TryGetValue(key, out (int Stamp, int Frame) last);
                bool recent = known && (uint)(frame - last.Frame) <= 1;
                Assert.True(stamp == (known ? last.Stamp : 0) || (!recent && stamp == 0), $"{key:x}: {stamp}, {last}");
                if (recent) remembered++;
                stamp = ++stamps;
                model[key] = (stamp, frame);
            }
        }

        Assert.True(remembered > 20, $"only {remembered} pairs were asked for again");
    }

    [Fact]
    public void ItDoesNotGrowWithPairsThatAreNotAskedForAgain()
    {
        var table = new WarmStartTable();
        for (int i = 0; i < 100_000; i++) table.Find((ulong)i + 1, i / 10);
        Assert.InRange(table.Count, 1, 64);
    }

    [Fact]
    public void AllPairsOfOneFrameAreKeptUpToItsLargestSize()
    {
        const int largest = 1 << 18;
        var table = new WarmStartTable();
        for (int i = 0; i < largest / 8; i++) Stamp(ref table.Find((ulong)i + 1, 0)) = i;
        for (int i = 0; i < largest / 8; i++) Assert.Equal(i, Stamp(ref table.Find((ulong)i + 1, 0)));
        Assert.Equal(largest / 8, table.Count);
        for (int i = 0; i < 2 * largest; i++) table.Find((ulong)i + 1, 0);
        Assert.InRange(table.Count, 1, largest / 2);
    }

    /// <summary>The first number of a warm start, which the table must carry about unread.</summary>
    private static ref int Stamp(ref WarmStart start) => ref Unsafe.As<WarmStart, int>(ref start);
}
