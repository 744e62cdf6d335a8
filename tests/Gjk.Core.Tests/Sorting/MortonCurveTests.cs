namespace Gjk.Core.Tests.Sorting;

/// <summary>Places on the curve, against bits put together one by one.</summary>
public class MortonCurveTests
{
    [Fact]
    public void ACellIsTheBitsOfItsThreeNumbersInTurn()
    {
        var rng = new Rng(1);
        var corner = new Double3(-3, 5, 1e6);
        for (int i = 0; i < 2000; i++)
        {
            int x = rng.Below(1024), y = rng.Below(1024), z = rng.Below(1024);
            Double3 point = corner + new Double3(x + 0.5, y + 0.5, z + 0.5) * 0.25;
            Assert.Equal(Interleaved(x, y, z), MortonCurve.Cell(point, corner, new Double3(4, 4, 4)));
        }
    }

    [Fact]
    public void WhatLiesOutsideCountsToTheNearestCell()
    {
        var perUnit = new Double3(1, 1, 1);
        Assert.Equal(0u, MortonCurve.Cell(new Double3(-5, double.NaN, -1e300), default, perUnit));
        Assert.Equal(Interleaved(1023, 1023, 0), MortonCurve.Cell(new Double3(1024, 1e300, 0), default, perUnit));
        Assert.Equal(0, MortonCurve.PerUnit(0));
    }

    [Fact]
    public void ASplitIsWhereTheHighestBitThatDiffersChanges()
    {
        var rng = new Rng(2);
        for (int i = 0; i < 500; i++)
        {
            uint range = 1u << rng.Below(31);
            ulong[] curve = [.. Enumerable.Range(0, 2 + rng.Below(60)).Select(_ => rng.Next() % range << 32).Order()];
            int split = MortonCurve.Split(curve, 0, curve.Length);
            uint[] cells = [.. curve.Select(k => (uint)(k >> 32))];
            if (cells[0] == cells[^1])
            {
                Assert.Equal(curve.Length / 2, split);
                continue;
            }

            int bit = 31 - int.LeadingZeroCount((int)(cells[0] ^ cells[^1]));
            Assert.Equal(Array.FindIndex(cells, c => (c >> bit & 1) != 0), split);
        }
    }

    private static uint Interleaved(int x, int y, int z)
    {
        uint cell = 0;
        for (int bit = 9; bit >= 0; bit--) cell = cell << 3 | Bit(x, bit) << 2 | Bit(y, bit) << 1 | Bit(z, bit);
        return cell;
    }

    private static uint Bit(int x, int bit) => (uint)(x >> bit & 1);
}
