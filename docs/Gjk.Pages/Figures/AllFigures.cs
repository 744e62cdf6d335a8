namespace Gjk.Pages;

/// <summary>The figures of the book, in its order, and those of the results.</summary>
internal static class AllFigures
{
    /// <param name="folder">The project's folder.</param>
    public static IEnumerable<Figure> Make(string folder)
    {
        yield return OriginFigure.Draw();
        yield return DifferenceFigure.Draw();
        yield return SupportFigure.Draw();
        yield return DropFigure.Draw();
        yield return RegionsFigure.Draw();
        yield return DistanceFigure.Draw();
        yield return WeightsFigure.Draw();
        yield return BoundsFigure.Draw();
        yield return TouchingFigure.Draw();
        yield return EpsilonFigure.Draw();
        yield return DepthFigure.Draw();
        yield return MarginsFigure.Draw();
        yield return ConcaveFigure.Draw();
        foreach (Figure chart in ResultBlocks.Charts(folder)) yield return chart;
    }
}
