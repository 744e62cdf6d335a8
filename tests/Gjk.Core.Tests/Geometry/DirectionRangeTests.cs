using System;
using Gjk.Core.Tests.Support;

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
            Vector3D v = new Vector3D(rng.Signed(), rng.Signed(), rng.Signed()) * Math.ScaleB(1, rng.Below(1980) - 960);
            Vector3D unit = DirectionRange.ToUnit(v);
            Assert.InRange(Largest(unit), 1, Math.BitDecrement(2.0));
            double factor = Largest(unit) / Largest(v);
            Assert.Equal(v * factor, unit);
            Assert.Equal(0.5, Math.Abs(factor) / Math.ScaleB(2, Math.ILogB(factor)));
        }
    }

    [Fact]
    public void DenormalDirectionsAreBroughtToUnitSizeToo()
    {
        Assert.Equal(new Vector3D(1, -1, 0), DirectionRange.ToUnit(new Vector3D(double.Epsilon, -double.Epsilon, 0)));
        Assert.Equal(new Vector3D(0, 0, 1.5), DirectionRange.ToUnit(new Vector3D(0, 0, 3 * double.Epsilon)));
    }

    [Fact]
    public void WhatHasNoDirectionStaysAsItIs()
    {
        Assert.Equal(default, DirectionRange.ToUnit(default));
        Assert.Equal(double.PositiveInfinity, DirectionRange.ToUnit(new Vector3D(0, double.PositiveInfinity, 1)).Y);
        Assert.True(double.IsNaN(DirectionRange.ToUnit(new Vector3D(double.NaN, 0, 0)).X));
    }

    [Fact]
    public void DirectionsOfOrdinaryLengthAreSafeAsTheyAre()
    {
        var ordinary = new Vector3D(3e90, -1e-90, 0);
        Assert.Equal(ordinary, DirectionRange.ToSafe(ordinary));
        Assert.InRange(Largest(DirectionRange.ToSafe(new Vector3D(1e-250, 0, 0))), 1, 2);
        Assert.InRange(Largest(DirectionRange.ToSafe(new Vector3D(0, 1e250, 0))), 1, 2);
        Assert.False(DirectionRange.IsSafe(0));
        Assert.True(DirectionRange.IsSafe(-1));
        Assert.False(DirectionRange.IsSafe(double.PositiveInfinity));
    }

    private static double Largest(in Vector3D v) => Math.Max(Math.Abs(v.X), Math.Max(Math.Abs(v.Y), Math.Abs(v.Z)));
}
