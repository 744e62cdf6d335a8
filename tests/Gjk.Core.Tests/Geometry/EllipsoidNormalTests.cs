namespace Gjk.Core.Tests.Geometry;

/// <summary>The nearest point of an ellipsoid has the normal that is asked for: from it the given point lies along the
/// normal, and no other point of the surface is nearer.</summary>
public class EllipsoidNormalTests
{
    [Fact]
    public void TheWayAlongTheNormalIsTheShortest()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(500); seed++)
        {
            var rng = new Rng(51_000 + seed);
            var radii = new Double3(rng.LogFloat(0.1, 1), rng.LogFloat(0.1, 1), rng.LogFloat(0.1, 1));
            Double3 point = Double3.Multiply(radii, (Double3)rng.UnitVector() * rng.Float(0, 1.2));
            if (seed % 3 == 0) point = new Double3(seed % 2 == 0 ? 0 : point.X, point.Y, 0);
            if (seed % 7 == 0) point = new Double3(0, 0, point.Z);
            AssertNearest(radii, point, rng, seed);
        }
    }

    /// <summary>Where the ways to both sides are equally short, and near it.</summary>
    [Theory]
    [InlineData(0, 0, 0)]
    [InlineData(0.1, 0, 0)]
    [InlineData(0, 0.2, 0)]
    [InlineData(0, 0, 0.05)]
    [InlineData(1e-12, 1e-9, 1e-300)]
    [InlineData(0.93, 0, 0)]
    [InlineData(0.84, 0, 0)]
    [InlineData(0.8400001, 1e-9, -1e-12)]
    public void PointsOnTheAxesHaveOne(double x, double y, double z) =>
        AssertNearest(new Double3(1, 0.5, 0.4), new Double3(x, y, z), new Rng(1), 0);

    [Theory]
    [InlineData(1e-30)]
    [InlineData(1e30)]
    public void ASizeIsOnlyAFactor(double size)
    {
        var radii = new Double3(0.9, 0.3, 0.5);
        var point = new Double3(0.2, -0.1, 0.05);
        Double3 usual = EllipsoidNormal.Nearest(radii, point);
        Double3 scaled = EllipsoidNormal.Nearest(radii * size, point * size);
        Assert.InRange((usual - scaled).Length, 0, 1e-14);
    }

    /// <summary>Needles and plates: the unknown is as small as the least radius is beside the others.</summary>
    [Theory]
    [InlineData(1, 1e-6, 1e-6)]
    [InlineData(1, 1, 1e-6)]
    [InlineData(1e6, 1, 1e-6)]
    public void ThinOnesEndToo(double x, double y, double z)
    {
        var radii = new Double3(x, y * 1.1, z);
        for (ulong seed = 0; seed < 50; seed++)
        {
            var rng = new Rng(seed);
            AssertNearest(radii, Double3.Multiply(radii, (Double3)rng.UnitVector() * rng.Float(0, 1)), rng, seed);
        }
    }

    private static void AssertNearest(in Double3 radii, in Double3 point, Rng rng, ulong seed)
    {
        Double3 normal = EllipsoidNormal.Nearest(radii, point);
        Assert.InRange(normal.Length, 1 - 1e-12, 1 + 1e-12);
        double way = Way(radii, point, normal), size = Math.Max(Math.Max(radii.X, radii.Y), radii.Z);
        for (int i = 0; i < 300; i++)
        {
            Double3 other = i % 2 == 0 ? rng.UnitVector() : normal + (Double3)rng.UnitVector() * rng.Float(0, 0.01);
            other *= 1 / other.Length;
            Assert.True(
                way <= Way(radii, point, other) + 1e-14 * size, $"seed {seed}: {radii} {point}: {way:R} {normal}");
        }
    }

    /// <summary>How far the point is from the plane that touches the ellipsoid across a normal.</summary>
    private static double Way(in Double3 radii, in Double3 point, in Double3 normal) =>
        Double3.Multiply(radii, normal).Length - Double3.Dot(point, normal);
}
