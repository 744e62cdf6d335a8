namespace Gjk.Pages;

/// <summary>How times of bench/results grow with the number of corners, and of objects.</summary>
internal static class ResultCharts
{
    private const double NsPerMs = 1e6;

    /// <param name="table">What --table measured.</param>
    /// <param name="scale">What --scale measured.</param>
    public static IEnumerable<Figure> Draw(ResultFile table, ResultFile scale)
    {
        yield return LogLogChart.Draw(
            "cost", "Distance and closest points: time over the hulls",
            "A distance with closest points, over the corners of a hull. Pairs of equal size, some overlapping.",
            Line("the report's algorithm", Ink.Difference, table, "vertices", "baseline_ns", 1, Hulls(table, "cold")),
            Line("Gjk, cold", Ink.A, table, "vertices", "library_ns", 1, Hulls(table, "cold")),
            Line("Gjk, warm, nothing moved", Ink.B, table, "vertices", "library_ns", 1, Hulls(table, "warm")));
        IReadOnlyList<string[]> tree = Moving(scale, "dynamic-tree");
        yield return LogLogChart.Draw(
            "scale", "Intersecting pairs: time per frame over the objects",
            "A frame's intersecting pairs, over the objects. Moving cubes, half of them touching; one thread.",
            Line(
                "sort and sweep", Ink.Difference, scale, "objects", "broad_ms", NsPerMs,
                Moving(scale, "sort-and-sweep")),
            Line("dynamic tree", Ink.A, scale, "objects", "broad_ms", NsPerMs, tree),
            Line("narrow phase", Ink.B, scale, "objects", "narrow_ms", NsPerMs, tree));
    }

    private static IEnumerable<string[]> Hulls(ResultFile table, string query) => table.Rows(("query", query))
        .Where(row => table.Cell(row, "set").StartsWith("hull", StringComparison.Ordinal));

    private static IReadOnlyList<string[]> Moving(ResultFile scale, string phase) =>
        scale.Rows(("scene", "room"), ("motion", "moving"), ("threads", "1"), ("broad_phase", phase));

    private static ChartLine Line(
        string name, string color, ResultFile file, string count, string time, double unit,
        IEnumerable<string[]> rows)
    {
        double Of(string[] row, string column) => ResultFile.Parse(file.Cell(row, column));
        return new(name, color, [.. rows.Select(row => (Of(row, count), unit * Of(row, time))).OrderBy(p => p.Item1)]);
    }
}
