using System.Runtime.InteropServices;
using Spectre.Console;

namespace Gjk.Demo.Replay;

/// <summary>Prints a table of text. Titles are aligned to the left, figures to the right.</summary>
internal static class TextTable
{
    /// <summary>A description of the machine on which the figures were measured.</summary>
    public static string ThisMachine =>
        $"{RuntimeInformation.FrameworkDescription}, {RuntimeInformation.ProcessArchitecture}, "
        + $"{Environment.ProcessorCount} processors";

    /// <param name="console">Where to print.</param>
    /// <param name="rows">The rows. The first one is the heading.</param>
    /// <param name="plain">Prints Markdown.</param>
    public static void Print(IAnsiConsole console, IReadOnlyList<string[]> rows, bool plain)
    {
        if (plain) PrintMarkdown(console, rows);
        else console.Write(Table(rows));
    }

    private static Table Table(IReadOnlyList<string[]> rows)
    {
        var table = new Table { Border = TableBorder.Rounded };
        for (int column = 0; column < rows[0].Length; column++)
        {
            Justify side = column == 0 ? Justify.Left : Justify.Right;
            table.AddColumn(new TableColumn(new Text(rows[0][column])) { Alignment = side });
        }

        foreach (string[] row in rows.Skip(1)) table.AddRow(row.Select(cell => new Text(cell)));
        return table;
    }

    /// <summary>Prints Markdown, which is readable in a pipe and can be pasted into a page.</summary>
    private static void PrintMarkdown(IAnsiConsole console, IReadOnlyList<string[]> rows)
    {
        int[] widths = [.. Enumerable.Range(0, rows[0].Length).Select(column => rows.Max(row => row[column].Length))];
        string Rule(int width, int column) => column == 0 ? new string('-', width) : new string('-', width - 1) + ":";
        string[] rule = [.. widths.Select(Rule)];
        foreach (string[] row in (IEnumerable<string[]>)[rows[0], rule, .. rows.Skip(1)])
        {
            IEnumerable<string> cells = row.Select((cell, column) =>
                column == 0 ? cell.PadRight(widths[column]) : cell.PadLeft(widths[column]));
            console.WriteLine($"| {string.Join(" | ", cells)} |");
        }
    }
}
