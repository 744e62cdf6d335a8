using System.Globalization;
using System.IO;

namespace Gjk.Pages;

/// <summary>A table of bench/results. The first line says where it was measured.</summary>
internal sealed class ResultFile
{
    private readonly string[] _heads;
    private readonly List<string[]> _rows;

    public ResultFile(string path)
    {
        Path = path;
        string[] lines = File.ReadAllLines(path);
        Machine = lines[0].TrimStart('#', ' ');
        _heads = lines[1].Split(',');
        _rows = [.. lines.Skip(2).Select(l => l.Split(','))];
    }

    public string Path { get; }

    public string Machine { get; }

    /// <summary>The number in a column of the only row that has these values; NaN if it is empty or there is no
    /// row.</summary>
    public double Number(string column, params (string Column, string Is)[] where) =>
        Rows(where) is [var row] && Cell(row, column) is { Length: > 0 } text ? Parse(text) : double.NaN;

    public IReadOnlyList<string[]> Rows(params (string Column, string Is)[] where) =>
        [.. _rows.Where(row => where.All(w => Cell(row, w.Column) == w.Is))];

    public string Cell(string[] row, string column)
    {
        int index = Array.IndexOf(_heads, column);
        if (index < 0) throw new ArgumentException($"The results have no column '{column}'.", nameof(column));
        return row[index];
    }

    public static double Parse(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
