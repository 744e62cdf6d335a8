using System;
using System.Collections.Generic;
using System.Linq;
using Gjk.Bench.Reporting;

namespace Gjk.Bench.Table;

/// <summary>How the cost of a distance query grows with the hull: the table's hull rows as a figure.</summary>
internal static class CostFigure
{
    /// <summary>What the names of the sets that differ in nothing but the number of vertices begin with.</summary>
    private const string HullSets = "hull";

    public static string Draw(IReadOnlyCollection<TableRow> rows, string machine)
    {
        TableRow[] hulls = [.. rows.Where(r => r.Set.StartsWith(HullSets, StringComparison.Ordinal)).OrderBy(r => r.Vertices)];
        TableRow[] cold = [.. hulls.Where(r => r.Query == Query.Cold)], warm = [.. hulls.Where(r => r.Query == Query.Warm)];
        return new LogLogChart(
        [
            new ChartLine("the report's algorithm", "#6e7781", [.. cold.Select(r => ((double)r.Vertices, r.Baseline))]),
            new ChartLine("Gjk, cold", "#0969da", [.. cold.Select(r => ((double)r.Vertices, r.Library))]),
            new ChartLine("Gjk, warm start, nothing moved", "#bf5b04", [.. warm.Select(r => ((double)r.Vertices, r.Library))]),
        ])
        {
            Title = "Distance and closest points: time over the size of the hulls",
            Subtitle = "Random pairs of equal size, a fifth to two fifths overlapping. " + machine,
            AxisX = "vertices per hull",
            AxisY = "time per pair",
            Unit = TimeText.Of,
        }.Draw();
    }
}
