using System.Text;

namespace Gjk.Bench.Table;

/// <summary>Writes a table with a column per set, line by line.</summary>
internal static class SetColumns
{
    public static void Header(StringBuilder text, string title, TableRow[] rows)
    {
        text.Append('\n');
        Line(text, title, rows, r => r.Set);
        text.Append("|---|").Insert(text.Length, "--:|", rows.Length).Append('\n');
    }

    public static void Line(
        StringBuilder text, string name, IEnumerable<TableRow> rows, Func<TableRow, string> cell) =>
        text.Append("| ").Append(name).Append(" | ").AppendJoin(" | ", rows.Select(cell)).Append(" |\n");

    public static string Time(double? nanoseconds) => nanoseconds?.ToString("0", CultureInfo.InvariantCulture) ?? "-";
}
