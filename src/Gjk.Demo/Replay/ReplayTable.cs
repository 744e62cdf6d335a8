using Spectre.Console;

namespace Gjk.Demo.Replay;

/// <summary>Prints the report's Table 1, where it has the scene, beside the figures of this machine, and the pairs that
/// intersect.</summary>
internal static class ReplayTable
{
    private const string None = "-";

    public static void Print(IAnsiConsole console, IReadOnlyList<SceneReport> reports, bool plain)
    {
        if (reports.Count == 0) return;
        TextTable.Print(console, Rows(reports), plain);
        console.WriteLine();
        if (reports.Any(r => r.Published is not null)) console.WriteLine($"report: {PublishedFigures.Machine}");
        console.WriteLine($"here:   {TextTable.ThisMachine}");
        console.WriteLine($"hash:   {string.Join(", ", reports.Select(r => $"{PlainText.Of(r.Name)} {r.Hash}"))}");
        console.WriteLine();
        foreach (string line in Explanations(reports.Any(r => r.Published is not null))) console.WriteLine(line);
        foreach (SceneReport report in reports) PrintPairs(console, report);
    }

    private static IEnumerable<string> Explanations(bool hasFactor)
    {
        yield return "loops: supports asked of each shape until the answer is proved, mean of all";
        yield return "time in support: what a second search of each support point adds to the time";
        if (hasFactor) yield return "factor: the report's milliseconds per frame over the median here";
        yield return "hash: of the bits of all answers, the same on every machine";
    }

    /// <summary>The rows of the table as text. The first row is the heading.</summary>
    private static List<string[]> Rows(IReadOnlyList<SceneReport> reports)
    {
        var rows = new List<string[]>();
        void Add(string title, Func<PublishedFigures, string> published, Func<SceneReport, string> here) =>
            rows.Add(Row(reports, title, published, here));

        rows.Add(
            [
                "per scene",
                .. reports.SelectMany(
                    r => r.Published is null ? [PlainText.Of(r.Name)] : new[] { $"{r.Name} report", $"{r.Name} here" }),
            ]);
        Add("objects", p => Text(p.Objects), r => Text(r.ObjectNames.Length));
        Add("vertices (hull)", p => Text(p.Vertices), Vertices);
        Add("calls per frame", p => Text(p.CallsPerFrame), r => Text(r.Results.Length));
        Add("intersecting", _ => None, r => Text(r.IntersectingPairs));
        Add("loops per call", p => Text(p.LoopsPerCall, "F2"), r => Text(r.LoopsPerCall, "F2"));
        Add("ms/frame, median", p => Text(p.MsPerFrame, "F0"), r => Text(r.MedianMs, "F4"));
        Add("ms/frame, 99 %", _ => None, r => Text(r.P99Ms, "F4"));
        Add(
            "time in support", p => p.SupportShare,
            r => r.SupportShare is { } share ? Text(share * 100, "F0") + " %" : None);
        Add("factor", _ => "1", r => r.Published is { } p ? Text(p.MsPerFrame / r.MedianMs, "F0") : None);
        Add("bytes per call", _ => None, r => Text(r.BytesPerCall, "0.##"));
        Add("iteration limits", _ => None, r => Text(r.IterationLimits));
        Add("frames measured", _ => None, r => Text(r.Frames));
        return rows;
    }

    /// <summary>A scene that the report has gets a column for what it says.</summary>
    private static string[] Row(
        IReadOnlyList<SceneReport> reports, string title, Func<PublishedFigures, string> published,
        Func<SceneReport, string> here) =>
        [
            title,
            .. reports.SelectMany(
                r => r.Published is { } p ? new[] { published(p), here(r) } : [here(r)]),
        ];

    private static string Vertices(SceneReport report) => report.HullVertices is not { } hull
        ? None
        : report.VerticesPerObject is { } given ? $"{Text(given)} ({Text(hull)})" : $"({Text(hull)})";

    private static void PrintPairs(IAnsiConsole console, SceneReport report)
    {
        console.WriteLine();
        console.WriteLine($"{PlainText.Of(report.Name)}, intersecting pairs:");
        for (int i = 0; i < report.Results.Length; i++)
        {
            if (!report.Results[i].IsOverlapping) continue;
            string a = PlainText.Of(report.ObjectNames[report.A[i]]), b = PlainText.Of(report.ObjectNames[report.B[i]]);
            console.WriteLine($"  {a} - {b}");
        }
    }

    private static string Text(int value) => value.ToString(CultureInfo.InvariantCulture);

    private static string Text(double value, string format) => value.ToString(format, CultureInfo.InvariantCulture);
}
