using System.Text;
using Gjk.Bench.Reporting;

namespace Gjk.Bench.Mono;

/// <summary>The figures of the runtimes as text.</summary>
internal static class MonoReport
{
    private const string Report = " report", CubesReport = "cubes cold" + Report, Peer = " OpenGJKSharp";

    public static string Markdown(IReadOnlyList<Dictionary<string, double>> figures, string mono)
    {
        var text = new StringBuilder("| row |");
        foreach (MonoColumn column in MonoColumn.All)
            text.Append(CultureInfo.InvariantCulture, $" {column.Name} | ratio |");
        text.Append("\n|---|").Insert(text.Length, "--:|--:|", figures.Count).Append('\n');
        foreach (string row in figures[0].Keys)
        {
            text.Append(CultureInfo.InvariantCulture, $"| {row} |");
            foreach (Dictionary<string, double> times in figures)
            {
                string ratio = RatioText(times, row, "0.00#");
                text.Append(CultureInfo.InvariantCulture, $" {TimeText.Of(times[row])} | {ratio} |");
            }

            text.Append('\n');
        }

        text.Append(
            CultureInfo.InvariantCulture,
            $"""

            The time of one query, or of one frame, in the fastest pass over all pairs. The ratio is to the report's
            algorithm: on the same pairs where there is such a row, else to its distance on the cubes. Each runtime
            measured library and algorithm in turns. mono: {mono} with the netstandard2.0 library. netstandard2.1: that
            library on .NET, the nearest to IL2CPP that is run here. A frame of 20 objects asks for all 190 distances,
            as the report's experiment does.

            """);
        return text.ToString();
    }

    /// <summary>One line per row and runtime. The first line describes the machine.</summary>
    public static string Csv(IReadOnlyList<Dictionary<string, double>> figures, string machine, string mono)
    {
        var text = new StringBuilder($"# {machine}; {mono}\nrow,runtime,ns,ratio\n");
        foreach (string row in figures[0].Keys)
        {
            for (int i = 0; i < figures.Count; i++)
            {
                text.Append(
                    CultureInfo.InvariantCulture,
                    $"{row},{MonoColumn.All[i].Name},{figures[i][row]:0.##},{RatioText(figures[i], row, "0.####")}\n");
            }
        }

        return text.ToString();
    }

    /// <summary>Empty for a frame without one of the report's: it is compared with no single query.</summary>
    private static string RatioText(Dictionary<string, double> column, string row, string format)
    {
        bool isFrame = row.StartsWith("frame", StringComparison.Ordinal);
        bool isCompared = row.EndsWith(Report, StringComparison.Ordinal) || column.ContainsKey(row + Report);
        return isFrame && !isCompared ? "" : Ratio(column, row).ToString(format, CultureInfo.InvariantCulture);
    }

    /// <summary>To the report's algorithm: that of the row's own set, where one is measured; of the cubes for the
    /// others.</summary>
    private static double Ratio(Dictionary<string, double> column, string row)
    {
        string set = row.Replace(" depth", " cold", StringComparison.Ordinal).Split(Peer)[0];
        return column[row] / (row.EndsWith(Report, StringComparison.Ordinal)
            ? column[row]
            : column.GetValueOrDefault(set + Report, column[CubesReport]));
    }
}
