using Gjk.Bench.Reporting;

namespace Gjk.Bench.Table;

/// <summary>A figure of how the cost of a distance query grows with the hull. It shows the hull rows of the
/// table.</summary>
internal static class CostFigure
{
    /// <summary>The common prefix of the sets that differ only in the number of vertices.</summary>
    private const string HullSets = "hull";

    public static string Draw(IReadOnlyCollection<TableRow> rows, string machine)
    {
        TableRow[] hulls =
        [
            .. rows.Where(r => r.Set.StartsWith(HullSets, StringComparison.Ordinal)).OrderBy(r => r.Vertices),
        ];
        TableRow[] cold = [.. hulls.Where(r => r.Query == Query.Cold)];
        TableRow[] warm = [.. hulls.Where(r => r.Query == Query.Warm)];
        return new LogLogChart(
        [
            new ChartLine(
                "the report's algorithm", "#6e7781", [.. cold.Select(r => ((double)r.Vertices, r.Baseline!.Value))]),
            new ChartLine("Gjk, cold", "#0969da", [.. cold.Select(r => ((double)r.Vertices, r.Library))]),
            new ChartLine(
                "Gjk, warm start, nothing moved", "#bf5b04", [.. warm.Select(r => ((double)r.Vertices, r.Library))]),
        ])
        {
            Title = "Distance and closest points: time over the hulls",
            Subtitle = "Pairs of equal size, a fifth to two fifths overlapping. " + machine,
            AxisX = "vertices per hull",
            AxisY = "time per pair",
            Unit = TimeText.Of,
        }.Draw();
    }
}
