using Gjk.Pages;

namespace Gjk.Docs.Tests;

/// <summary>The figures are what the library draws now, and show what their captions say.</summary>
public class FigureTests
{
    public static TheoryData<string> Names => [.. AllFigures.Make(Page.PathOf(".")).Select(f => f.Name)];

    [Theory, MemberData(nameof(Names))]
    public void FiguresAreDrawnByTheLibrary(string name)
    {
        string drawn = AllFigures.Make(Page.PathOf(".")).Single(f => f.Name == name).Svg;
        Assert.Equal(Page.Read(Path.Combine("docs", "figures", name + ".svg")), drawn);
    }

    /// <summary>The pictures of a scene are drawn by the demo.</summary>
    [Fact]
    public void TheFirstPictureIsDrawnByTheDemo()
    {
        using var folder = new PageFolder([]);
        File.Copy(Page.PathOf("docs/figures/hero.json"), Path.Combine(folder.Name, "hero.json"));
        folder.Run("gjk-demo view hero.json --svg hero.svg --out hero.html");
        Assert.Equal(Page.Read("docs/figures/hero.svg"), File.ReadAllText(Path.Combine(folder.Name, "hero.svg")));
    }

    [Fact]
    public void AQueryAsksForFewOfTheDifferences() =>
        Assert.InRange(DifferenceFigure.Asked(Example.A, Example.B).Count, 2, 5);

    [Fact]
    public void ADroppedVertexIsNotInTheNextSimplex()
    {
        (Step before, Step after) = DropFigure.FirstDrop(Example.A, Example.B);
        Assert.Contains(after.Vertex, after.Simplex);
        Assert.True(after.Simplex.Count < before.Simplex.Count + 1);
        Assert.True(after.Nearest.Length() < before.Nearest.Length());
    }

    [Fact]
    public void TheBoundsMeet()
    {
        List<(int Number, double Above, double Below)> rows =
            BoundsFigure.Rows(BoundsFigure.Round(new(0, 0), 1).Explain(BoundsFigure.Round(new(1.6f, 2.2f), 0.2f)));
        for (int i = 1; i < rows.Count; i++)
        {
            Assert.True(rows[i].Above <= rows[i - 1].Above && rows[i].Below >= rows[i - 1].Below, $"step {i}");
        }

        Assert.InRange(rows[^1].Above - rows[^1].Below, -1e-7, 1e-7);
    }

    [Fact]
    public void TheOriginIsInTheDifferenceExactlyWhenTheShapesOverlap()
    {
        Assert.True(Example.A.Overlaps(Example.Deep));
        Assert.False(Example.A.Overlaps(Example.B));
        Assert.True(Example.A.Minus(Example.Deep).Overlaps(new PlaneShape(default(System.Numerics.Vector2))));
        Assert.False(Example.A.Minus(Example.B).Overlaps(new PlaneShape(default(System.Numerics.Vector2))));
    }

    [Theory]
    [InlineData(1e-5f), InlineData(1e-2f), InlineData(1), InlineData(1e5f)]
    public void AGapIsTheSamePartOfEverySize(float size) =>
        Assert.InRange(EpsilonFigure.MeasuredGap(size) / size, 0.99 / 4096, 1.01 / 4096);

    [Fact]
    public void MarginsAreTakenOffTheDistanceOfTheCores() => Assert.Equal(
        MarginsFigure.Ask(0, 0).Distance - 0.95f, MarginsFigure.Ask(0.35f, 0.6f).Distance, 1e-6f);

    [Fact]
    public void TheHullOfAConcaveShapeFillsItsNotch()
    {
        Assert.True(ConcaveFigure.Hull.Overlaps(ConcaveFigure.Guest));
        Assert.All(ConcaveFigure.Parts, part => Assert.False(part.Overlaps(ConcaveFigure.Guest)));
    }
}
