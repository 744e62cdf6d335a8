namespace Gjk.Core.Tests.Geometry;

/// <summary>Directions of any length, brought to unit size without rounding.</summary>
public class DirectionRangeTests
{
    [Fact]
    public void UnitSizeChangesTheLengthByAPowerOfTwoOnly()
    {
        var rng = new Rng(1);
        for (int i = 0; i < 3000; i++)
        {
            // The components' own bits stay far above the end of the denormal numbers.
            Double3 v = new Double3(rng.Signed(), rng.Signed(), rng.Signed()) * Math.ScaleB(1, rng.Below(1980) - 960);
            Double3 unit = DirectionRange.ToUnit(v);
            Assert.InRange(Largest(unit), 1, Math.BitDecrement(2.0));
            double factor = Largest(unit) / Largest(v);
            Assert.Equal(v * factor, unit);
            Assert.Equal(0.5, Math.Abs(factor) / Math.ScaleB(2, Math.ILogB(factor)));
        }
    }

    [Fact]
    public void DenormalDirectionsAreBroughtToUnitSizeToo()
    {
        Assert.Equal(new Double3(1, -1, 0), DirectionRange.ToUnit(new Double3(double.Epsilon, -double.Epsilon, 0)));
        Assert.Equal(new Double3(0, 0, 1.5), DirectionRange.ToUnit(new Double3(0, 0, 3 * double.Epsilon)));
    }

    [Fact]
    public void WhatHasNoDirectionStaysAsItIs()
    {
        Assert.Equal(default, DirectionRange.ToUnit(default));
        Assert.Equal(double.PositiveInfinity, DirectionRange.ToUnit(new Double3(0, double.PositiveInfinity, 1)).Y);
        Assert.True(double.IsNaN(DirectionRange.ToUnit(new Double3(double.NaN, 0, 0)).X));
    }

    [Fact]
    public void DirectionsOfOrdinaryLengthAreSafeAsTheyAre()
    {
        var ordinary = new Double3(3e90, -1e-90, 0);
        Assert.Equal(ordinary, DirectionRange.ToSafe(ordinary));
        Assert.InRange(Largest(DirectionRange.ToSafe(new Double3(1e-250, 0, 0))), 1, 2);
        Assert.InRange(Largest(DirectionRange.ToSafe(new Double3(0, 1e250, 0))), 1, 2);
        Assert.False(DirectionRange.IsSafe(0));
        Assert.True(DirectionRange.IsSafe(-1));
        Assert.False(DirectionRange.IsSafe(double.PositiveInfinity));
    }

    private static double Largest(in Double3 v) => Math.Max(Math.Abs(v.X), Math.Max(Math.Abs(v.Y), Math.Abs(v.Z)));
}
