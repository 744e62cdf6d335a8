using System.Globalization;
using System.Text;

namespace Gjk.Pages;

/// <summary>How results are written.</summary>
internal static class Shown
{
    /// <summary>At least two digits, and no more than is needed for them.</summary>
    public static string TwoDigits(double value)
    {
        if (double.IsNaN(value)) return "-";
        double size = Math.Abs(value);
        string format = size >= 9.95 || size == 0 ? "#,0" : size >= 0.995 ? "0.0" : size >= 0.0095 ? "0.00" : "0.000";
        return value.ToString(format, CultureInfo.InvariantCulture);
    }

    /// <summary>Nanoseconds, or a count.</summary>
    public static string Whole(double value) =>
        double.IsNaN(value) ? "-" : value.ToString("0", CultureInfo.InvariantCulture);

    public static string Milliseconds(double value) =>
        value.ToString(value < 0.1 ? "0.0000" : value < 10 ? "0.000" : "0.0", CultureInfo.InvariantCulture);

    public static string Bold(string text, bool isBold) => isBold && text != "-" ? $"**{text}**" : text;

    /// <summary>A Markdown table; columns from the <paramref name="numbers"/>th on are aligned to the right.</summary>
    public static string Table(IReadOnlyList<string> heads, int numbers, IEnumerable<IEnumerable<string>> rows)
    {
        var text = new StringBuilder();
        Line(heads);
        text.Append('|').Append(string.Concat(heads.Select((_, i) => i < numbers ? "---|" : "--:|"))).Append('\n');
        foreach (IEnumerable<string> row in rows) Line(row);
        return text.ToString();

        void Line(IEnumerable<string> cells) => text.Append("| ").AppendJoin(" | ", cells).Append(" |\n");
    }
}

/// <summary>Says where the figures were measured.</summary>
internal static class MachineText
{
    public static string Of(params ResultFile[] files) =>
        string.Join("; ", files.Select(f => f.Machine).Distinct()) + ".";
}
