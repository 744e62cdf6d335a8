using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;

namespace Gjk.Bench.Table;

/// <summary>The rows as text.</summary>
internal static class TableReport
{
    private const string CsvHeader = "set,vertices,pairs,query,library_ns,baseline_ns,factor,goal_ns,goal_here_ns,met";

    public static string Markdown(IReadOnlyCollection<TableRow> rows, double meanSlowness)
    {
        var text = new StringBuilder();
        text.Append("| set | query | library | baseline | factor | goal | goal here | |\n|---|---|--:|--:|--:|--:|--:|---|\n");
        foreach (TableRow r in rows)
        {
            string met = r.Met switch { true => "met", false => "missed", null => "" };
            text.Append(
                CultureInfo.InvariantCulture,
                $"| {r.Set} | {Name(r.Query)} | {Time(r.Library)} | {Time(r.Baseline)} | {r.Factor:0.0} | {r.Goal:0} | {r.GoalHere:0} | {met} |\n");
        }

        TableRow[] judged = [.. rows.Where(r => r.Met is not null)];
        text.Append(
            CultureInfo.InvariantCulture,
            $"""

            Nanoseconds per pair, the fastest repetition of the whole list. Factor: baseline over library;
            on hulls of 8,192 vertices and more the baseline gets the first hundred pairs only. {judged.Count(r => r.Met == true)} of {judged.Length} goals met.
            Goal here: the goal times what the baseline needs here over what it needed where the goals were set, per set; {meanSlowness:0.00} on average, which is
            used for the primitives.

            """);
        return text.ToString();
    }

    /// <summary>One line per row, under a first line that describes the machine.</summary>
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
                $"{r.Set},{vertices},{r.Pairs},{Name(r.Query)},{r.Library:0.##},{r.Baseline:0.##},{r.Factor:0.###},{r.Goal:0.##},{r.GoalHere:0.##},{met}\n");
        }

        return text.ToString();
    }

    private static string Name(Query query) => query.ToString().ToLowerInvariant();

    private static string Time(double nanoseconds) => nanoseconds.ToString(nanoseconds < 100 ? "0.0" : "0", CultureInfo.InvariantCulture);
}
