namespace Gjk.Core.Tests.Regression;

/// <summary>A large mesh gave wrong vertices towards directions shorter than 1e-307, and any mesh towards some longer
/// than 1e270: dot products left the range of double.</summary>
public class HullDirectionLengthTests
{
    [Theory]
    [InlineData(-1060)]
    [InlineData(-1000)]
    [InlineData(-700)]
    [InlineData(800)]
    [InlineData(1019)]
    public void TheLengthDoesNotMatter(int exponent)
    {
        double factor = Math.Pow(2, exponent);
        for (ulong seed = 0; seed < 200; seed++)
        {
            ConvexHull hull = Hull(seed);
            var rng = new Rng(seed);
            for (int i = 0; i < 50; i++)
            {
                // Few bits, so that even denormal components hold them.
                var d = new Double3(rng.Below(31) - 15, rng.Below(31) - 15, rng.Below(31) - 15);
                int id = HullSupport.Find(hull.Cells, d * factor, out _);
                int expected = HullSupport.Find(hull.Cells, d, out _);
                Assert.True(id == expected, $"seed {seed}: vertex {id}, not {expected}, towards {d} x 2^{exponent}");
                Assert.Equal(expected, PlainScan.Furthest(hull.Cells, d * factor));
            }
        }
    }

    [Fact]
    public void AComponentAcrossAFlatHullDoesNotHideTheOthers()
    {
        ConvexHull square = new([new(1, 0, 1), new(-1, 0, 1), new(1, 0, -1), new(-1, 0, -1)]);
        ConvexHull disc = new(HostileClouds.Disc(500));
        foreach (double big in new[] { 1e300, 1, 1e-10, 0 })
        {
            HullSupport.Find(square.Cells, new Double3(1e-320, big, -1e-320), out Double3 corner);
            Assert.Equal(new Double3(1, 0, -1), corner);
            HullSupport.Find(disc.Cells, new Double3(0, 5e-324, -big), out Double3 top);
            Assert.Equal(1, top.Y);
        }
    }

    [Theory]
    [InlineData(0, 0, 0)]
    [InlineData(double.NaN, 1, 1)]
    [InlineData(1, 1, double.NaN)]
    [InlineData(double.PositiveInfinity, 1, 0)]
    [InlineData(1, double.NegativeInfinity, double.PositiveInfinity)]
    public void WhatIsNoDirectionGivesAVertex(double x, double y, double z)
    {
        for (ulong seed = 0; seed < 200; seed++)
        {
            ConvexHull hull = Hull(seed);
            var d = new Double3(x, y, z);
            int id = HullSupport.Find(hull.Cells, d, out Double3 point);
            Assert.InRange(id, 0, hull.VertexCount - 1);
            Assert.Equal(PlainScan.Furthest(hull.Cells, d), id);
            Assert.Equal((Double3)hull.GetVertex(id), point);
        }

        foreach (string kind in new[] { "prism", "disc", "turned disc" })
        {
            var hull = new ConvexHull(HostileClouds.Create(kind));
            var d = new Double3(x, y, z);
            Assert.Equal(PlainScan.Furthest(hull.Cells, d), HullSupport.Find(hull.Cells, d, out _));
        }
    }

    private static ConvexHull Hull(ulong seed)
    {
        var random = new Rng(seed);
        Vector3[] cloud = MadeMeshes.Any(random);
        float size = (float)random.Of(1, 1, 1e-38, 1e37);
        return new ConvexHull(Array.ConvertAll(cloud, p => seed % 7 == 0 ? size * p with { Z = 1 } : size * p));
    }
}
