using System.Text;

namespace Gjk.Bench.Table;

/// <summary>The rows as text.</summary>
internal static class TableReport
{
    private const string CsvHeader = "set,vertices,pairs,query,library_ns,baseline_ns,factor,goal_ns,goal_here_ns,met";

    public static string Markdown(IReadOnlyCollection<TableRow> rows, double meanSlowness)
    {
        var text = new StringBuilder();
        text.Append("| set | query | library | baseline | factor | goal | goal here | | best other | here | wins |\n");
        text.Append("|---|---|--:|--:|--:|--:|--:|---|--:|--:|---|\n");
        foreach (TableRow r in rows.Where(r => !DepthReport.Covers(r) && r.Query != Query.Cast))
        {
            string met = r.Met switch { true => "met", false => "missed", null => "" };
            text.Append(
                CultureInfo.InvariantCulture,
                $"| {r.Set} | {Name(r.Query)} | {Time(r.Library)} | {Time(r.Baseline!.Value)} | {r.Factor:0.0} "
                + $"| {r.Goal:0} | {r.GoalHere:0} | {met} | {Engine(r)} | {r.BestHere:0} | {r.Winner} |\n");
        }

        TableRow[] judged = [.. rows.Where(r => r.Met is not null)];
        text.Append(
            CultureInfo.InvariantCulture,
            $"""

            The figures are nanoseconds per pair, in the fastest repetition of the whole list. The factor is baseline
            over library. On hulls of 8,192 vertices and more the baseline gets only the first hundred pairs.
            "Goal here" is the goal times the slowness of this machine for that set. The slowness is the time of the
            baseline here, divided by its time where the goals were set. The primitives use its average,
            {meanSlowness:0.00}. "Best other" is the best of the engines that were measured beside the goals,
            and "here" is its time times the same slowness.
            {judged.Count(r => r.Met == true)} of {judged.Length} goals met.

            """);
        DepthReport.Append(text, rows, meanSlowness);
        CastReport.Append(text, rows, meanSlowness);
        return text.ToString();
    }

    /// <summary>One line per row. The first line describes the machine.</summary>
    public static string Csv(IEnumerable<TableRow> rows, string machine)
    {
        var text = new StringBuilder();
        text.Append("# ").Append(machine).Append('\n').Append(CsvHeader).Append('\n');
        foreach (TableRow r in rows)
        {
            string vertices = r.Vertices == 0 ? "" : r.Vertices.ToString(CultureInfo.InvariantCulture);
            string met = r.Met switch { true => "true", false => "false", null => "" };
            text.Append(
                CultureInfo.InvariantCulture,
                $"{r.Set},{vertices},{r.Pairs},{Name(r.Query)},{r.Library:0.##},{r.Baseline:0.##},{r.Factor:0.###},"
                + $"{r.Goal:0.##},{r.GoalHere:0.##},{met}\n");
        }

        return text.ToString();
    }

    private static string Engine(TableRow r) => r.Best is (string engine, double time)
        ? string.Create(CultureInfo.InvariantCulture, $"{engine} {time:0}")
        : "";

    private static string Name(Query query) => query.ToString().ToLowerInvariant();

    private static string Time(double nanoseconds) =>
        nanoseconds.ToString(nanoseconds < 100 ? "0.0" : "0", CultureInfo.InvariantCulture);
}
