namespace Gjk.Pages;

/// <summary>How long a query takes, beside the best engine of those that were measured elsewhere.</summary>
internal static class LibraryTable
{
    private const string Baseline = "the report's algorithm";

    private static readonly string[] Sets =
        ["cubes", "spheres", "box", "hull8", "hull32", "hull128", "hull512", "hull2048"];

    private static readonly string[] Heads =
        ["cubes", "spheres 515", "box", "hull 8", "hull 32", "hull 128", "hull 512", "hull 2048"];

    private static readonly (string Query, string Name)[] Rows =
    [
        ("cold", "cold"), ("warm", "warm, nothing moved"), ("moving", "warm, moving"), ("boolean", "boolean"),
        ("batchcold", "batch, cold"), ("batchwarm", "batch, warm, nothing moved"), ("batchboolean", "batch, boolean"),
    ];

    public static string Make(ResultFile table, ResultFile cited)
    {
        var rows = new List<IEnumerable<string>>();
        foreach ((string query, string name) in Rows)
        {
            double[] own = [.. Sets.Select(s => table.Number("library_ns", ("set", s), ("query", query)))];
            (string Engine, double Time)[] best = [.. Sets.Select(s => Best(table, cited, query, s))];
            bool[] wins = [.. own.Select((ns, i) => ns < best[i].Time)];
            rows.Add([$"**Gjk**, {name}", .. own.Select((ns, i) => Shown.Bold(Shown.Whole(ns), wins[i]))]);
            if (best.All(b => double.IsNaN(b.Time))) continue;
            rows.Add([$"the best engine, {name}", .. best.Select((b, i) =>
                double.IsNaN(b.Time) ? "-" : Shown.Bold($"{b.Engine} {Shown.Whole(b.Time)}", !wins[i]))]);
        }

        foreach ((string query, string name) in new[] { ("cold", Baseline), ("boolean", Baseline + ", boolean") })
        {
            rows.Add([name, .. Sets.Select(
                s => Shown.Whole(table.Number("baseline_ns", ("set", s), ("query", query))))]);
        }

        return Shown.Table(["ns per pair", .. Heads], 1, rows);
    }

    public static string Primitives(ResultFile table)
    {
        (string Set, string Name)[] kinds =
        [
            ("sphere-sphere", "spheres"), ("capsule-capsule", "capsules"), ("box-box cubes", "boxes of equal sides"),
            ("box-box random", "boxes"), ("triangle-triangle", "triangles"),
        ];
        return "Primitives by their own types, cold: " + string.Join(", ", kinds.Select(kind =>
            $"{kind.Name} {Shown.Whole(table.Number("library_ns", ("set", kind.Set), ("query", "cold")))}")) + ".";
    }

    public static string Cited(ResultFile cited, string query) => Shown.Table(
        ["ns per pair", .. Heads], 1, cited.Rows(("query", query)).Select(row => (IEnumerable<string>)
            [cited.Cell(row, "engine"), .. Sets.Select(set => CitedCell(cited, row, set))]));

    /// <summary>The engines of the cited tables, whatever part of them was asked.</summary>
    public static IReadOnlyList<string> Engines(ResultFile cited) =>
        [.. cited.Rows().Select(row => Short(cited.Cell(row, "engine"))).Where(e => e != Baseline).Distinct()];

    private static string CitedCell(ResultFile cited, string[] row, string set)
    {
        string time = cited.Cell(row, set), box = set == "box" ? cited.Cell(row, "box_shape") : "";
        return time.Length == 0 ? "-" : box.Length == 0 ? time : $"{time} ({box} as a box)";
    }

    /// <summary>The least time of another engine, as it would be here: scaled by the cold time of the report's
    /// algorithm, which ran in both places.</summary>
    private static (string Engine, double Time) Best(ResultFile table, ResultFile cited, string query, string set)
    {
        double there = cited.Number(set, ("query", "cold"), ("engine", Baseline));
        double slowness = table.Number("baseline_ns", ("set", set), ("query", "cold")) / there;
        (string Engine, double Time) best = ("", double.NaN);
        foreach (string[] row in cited.Rows(("query", query)))
        {
            string engine = cited.Cell(row, "engine");
            if (engine == Baseline) continue;
            string[] columns = set == "box" ? ["box", "box_shape"] : [set];
            foreach (string time in columns.Select(c => cited.Cell(row, c)).Where(c => c.Length > 0))
            {
                double here = ResultFile.Parse(time) * slowness;
                if (!(here >= best.Time)) best = (Short(engine), here);
            }
        }

        return best;
    }

    /// <summary>An engine's name without its version and the part that was asked.</summary>
    private static string Short(string engine) => engine == Baseline ? engine : engine.Split(' ')[0];
}
