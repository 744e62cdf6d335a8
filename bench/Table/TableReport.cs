using System.Text;

namespace Gjk.Bench.Table;

/// <summary>The rows as text.</summary>
internal static class TableReport
{
    private const string CsvHeader = "set,vertices,pairs,query,library_ns,baseline_ns,factor";

    public static string Markdown(IEnumerable<TableRow> rows)
    {
        var text = new StringBuilder();
        text.Append("| set | query | library | baseline | factor |\n|---|---|--:|--:|--:|\n");
        foreach (TableRow r in rows)
        {
            text.Append(
                CultureInfo.InvariantCulture,
                $"| {r.Set} | {Name(r.Query)} | {Time(r.Library)} | {Time(r.Baseline)} | {r.Factor:0.0} |\n");
        }

        return text.Append(
            """

            The figures are nanoseconds per pair, in the fastest repetition of the whole list. The factor is baseline
            over library. On hulls of 8,192 vertices and more the baseline gets only the first hundred pairs. It answers
            no depths and no casts. Moving depths are 1 % of the smaller object's size apart, across the way out.
            Contacts on top are a cold call with contact points minus a cold depth, both measured in turns. A gap of 1 %
            of the smaller object's size counts as a contact. One object of each pair of casts moves. Points are asked
            as rays.

            """).ToString();
    }

    /// <summary>One line per row. The first line describes the machine.</summary>
    public static string Csv(IEnumerable<TableRow> rows, string machine)
    {
        var text = new StringBuilder();
        text.Append("# ").Append(machine).Append('\n').Append(CsvHeader).Append('\n');
        foreach (TableRow r in rows)
        {
            string vertices = r.Vertices == 0 ? "" : r.Vertices.ToString(CultureInfo.InvariantCulture);
            text.Append(
                CultureInfo.InvariantCulture,
                $"{r.Set},{vertices},{r.Pairs},{Name(r.Query)},{r.Library:0.##},{r.Baseline:0.##},{r.Factor:0.###}\n");
        }

        return text.ToString();
    }

    private static string Name(Query query) => query.ToString().ToLowerInvariant();

    private static string Time(double? nanoseconds) =>
        nanoseconds?.ToString(nanoseconds < 100 ? "0.0" : "0", CultureInfo.InvariantCulture) ?? "";
}
