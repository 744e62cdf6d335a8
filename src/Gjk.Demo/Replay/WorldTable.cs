using Spectre.Console;

namespace Gjk.Demo.Replay;

/// <summary>Prints the cost of a world's frame, with one column per scene.</summary>
internal static class WorldTable
{
    public static void Print(IAnsiConsole console, IReadOnlyList<WorldReport> reports, bool plain)
    {
        if (reports.Count == 0) return;
        TextTable.Print(console, Rows(reports), plain);
        console.WriteLine();
        console.WriteLine($"here: {TextTable.ThisMachine}");
    }

    /// <summary>The rows of the table as text. The first row is the heading.</summary>
    private static List<string[]> Rows(IReadOnlyList<WorldReport> reports)
    {
        var rows = new List<string[]>();
        void Add(string title, Func<WorldReport, string> cell) => rows.Add([title, .. reports.Select(cell)]);

        Add("per scene", r => r.Name);
        Add("objects", r => Text(r.Objects));
        Add("vertices (of the hull)", r => $"{Text(r.VerticesPerObject)} ({Text(r.HullVertices)})");
        Add("broad phase", r => r.Settings.BroadPhaseName);
        Add("sizes per frame moved", r => Text(r.Settings.Speed, "R"));
        Add("threads", r => Text(r.Settings.Threads));
        Add("pairs", r => Text(r.PairsPerFrame));
        Add("calls made per frame", r => Text(r.CallsPerFrame, "0.#"));
        Add("calls saved per frame", r => Text(r.CallsSavedPerFrame, "0.#"));
        Add("calls saved", r => Text(100 * r.CallsSavedPerFrame / r.PairsPerFrame, "0.##") + " %");
        Add("intersecting pairs", r => Text(r.IntersectingPairs, "0.#"));
        Add("ms in the broad phase, median", r => Text(r.BroadMs, "F4"));
        Add("ms in the narrow phase, median", r => Text(r.NarrowMs, "F4"));
        Add("ms per frame, median", r => Text(r.MedianMs, "F4"));
        Add("ms per frame, 99 %", r => Text(r.P99Ms, "F4"));
        Add("bytes per frame", r => Text(r.BytesPerFrame, "0.##"));
        Add("frames measured", r => Text(r.Frames));
        Add("frames counted and hashed", r => Text(r.CountedFrames));
        Add("hash of their pairs", r => r.Hash);
        return rows;
    }

    private static string Text(long value) => value.ToString(CultureInfo.InvariantCulture);

    private static string Text(double value, string format) => value.ToString(format, CultureInfo.InvariantCulture);
}
