namespace Gjk.Core.Tests.Arithmetic;

public class ArcTangentTests
{
    /// <summary>As the runtime's own, which is right to a unit in the last place or so.</summary>
    [Fact]
    public void ItIsTheRuntimesToAFewUnits()
    {
        var rng = new Rng(2);
        for (int i = 0; i < 200_000; i++)
        {
            double scale = Math.Pow(10, rng.Range(-100, 100)), small = i % 2 == 0 ? 1 : Math.Pow(10, rng.Range(-20, 0));
            double sine = rng.Range(-1, 1) * scale * small, cosine = rng.Range(-1, 1) * scale;
            double expected = Math.Atan2(sine, cosine), found = ArcTangent.Atan2(sine, cosine);
            double room = Math.Min(1e-15, 1e-15 * Math.Abs(expected));
            Assert.True(Math.Abs(found - expected) <= room, $"{sine:R}, {cosine:R}: {found:R}, not {expected:R}");
        }
    }

    /// <summary>The largest angle that the series is asked for, where what is left out counts most.</summary>
    [Fact]
    public void AnEighthOfATurn()
    {
        for (int i = 0; i < 1000; i++)
        {
            double angle = Math.PI / 4 * (1 - 1e-4 * i);
            double sine = Math.Sin(angle), cosine = Math.Cos(angle);
            Assert.Equal(Math.Atan2(sine, cosine), ArcTangent.Atan2(sine, cosine), 5e-16);
        }
    }

    [Theory]
    [InlineData(0, 0, 0)]
    [InlineData(0, 3, 0)]
    [InlineData(3, 0, 0.5)]
    [InlineData(-3, 0, -0.5)]
    [InlineData(0, -3, 1)]
    [InlineData(2, 2, 0.25)]
    [InlineData(2, -2, 0.75)]
    [InlineData(-2, -2, -0.75)]
    public void HalvesAndQuarters(double sine, double cosine, double halves) =>
        Assert.Equal(halves * Math.PI, ArcTangent.Atan2(sine, cosine), 4e-16);
}
