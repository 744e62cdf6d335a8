namespace Gjk.Pages;

/// <summary>The library where Unity runs and where it goes: Mono, .NET, and the netstandard2.1 build on .NET.</summary>
internal static class RuntimeTable
{
    private static readonly string[] Runtimes = ["mono", "net10.0", "netstandard2.1"];

    /// <summary>Every row of the run, with its ratio to the report's algorithm on the same runtime.</summary>
    public static string Make(ResultFile runs)
    {
        string[] names = [.. runs.Rows(("runtime", Runtimes[0])).Select(row => runs.Cell(row, "row"))];
        return Shown.Table(
            ["question", "Mono", "of the report's", ".NET 10", "of the report's", "netstandard2.1 on .NET",
                "of the report's"],
            1, names.Select(name => (IEnumerable<string>)
            [
                name, .. Runtimes.SelectMany(r => (string[])[Time(runs, name, r), Ratio(runs, name, r)]),
            ]));
    }

    /// <summary>One line for a page that has no room for the table.</summary>
    public static string Short(ResultFile runs) =>
        $"A cold distance of two cubes takes {Time(runs, "cubes cold", Runtimes[1])} on .NET 10, "
        + $"{Time(runs, "cubes cold", Runtimes[0])} on Mono, and {Time(runs, "cubes cold", Runtimes[2])} with the "
        + "netstandard2.1 build on .NET.";

    private static string Time(ResultFile runs, string name, string runtime)
    {
        double ns = runs.Number("ns", ("row", name), ("runtime", runtime));
        return ns < 1e5 ? $"{Shown.Whole(ns)} ns" : $"{Shown.Milliseconds(ns * 1e-6)} ms";
    }

    private static string Ratio(ResultFile runs, string name, string runtime) =>
        Shown.TwoDigits(runs.Number("ratio", ("row", name), ("runtime", runtime)));
}
