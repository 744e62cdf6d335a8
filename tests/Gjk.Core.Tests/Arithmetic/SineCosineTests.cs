namespace Gjk.Core.Tests.Arithmetic;

public class SineCosineTests
{
    /// <summary>As the runtime's own, which is right to a unit in the last place or so; up to the largest angle, whose
    /// quarter turns are taken off without a rounding.</summary>
    [Fact]
    public void TheyAreTheRuntimesToAFewUnits()
    {
        var rng = new Rng(1);
        for (int i = 0; i < 100_000; i++)
        {
            double angle = rng.Range(-1, 1) * (i % 3 == 0 ? SineCosine.MaxAngle : i % 3 == 1 ? 100 : 1);
            SineCosine.Compute(angle, out double sine, out double cosine);
            Assert.True(Math.Abs(sine - Math.Sin(angle)) <= 4e-16, $"{angle:R}: {sine:R}");
            Assert.True(Math.Abs(cosine - Math.Cos(angle)) <= 4e-16, $"{angle:R}: {cosine:R}");
        }
    }

    /// <summary>Each quarter has its signs.</summary>
    [Theory]
    [InlineData(0, 0, 1)]
    [InlineData(1, 1, 0)]
    [InlineData(2, 0, -1)]
    [InlineData(3, -1, 0)]
    [InlineData(-1, -1, 0)]
    public void QuarterTurns(int quarters, int sine, int cosine)
    {
        SineCosine.Compute(quarters * (Math.PI / 2), out double s, out double c);
        Assert.Equal(sine, s, 1e-15);
        Assert.Equal(cosine, c, 1e-15);
    }
}
