using System.Text;

namespace Gjk.Bench.Worst;

/// <summary>The rows as text.</summary>
internal static class WorstReport
{
    /// <summary>The design goals for any cloud of 100,000 points, in milliseconds, nanoseconds and
    /// microseconds.</summary>
    private const double BuildGoalMs = 5000, SupportGoalNs = 2000, QueryGoalUs = 1000;

    private const string CsvHeader =
        "family,points,distinct,corners,build_ms,surface_ms,random_mean_ns,random_worst_ns,"
        + "normal_mean_ns,normal_worst_ns,near_mean_ns,near_worst_ns,query_us,placement,iterations";

    private const string Header =
        "| cloud | points | distinct | corners | build, ms | surface, ms | random | normals | near | query, µs "
        + "| placement | steps |\n"
        + "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|--:|\n";

    private const string Legend =
        """

        "Surface" is the part of the build that finds corners and triangles. "Random", "normals" and "near" are ns per
        support in random directions, along the normals of facets, and 1e-18 to 1e-1 off these normals. Each has the
        mean over 500 directions / the slowest direction. "Query" is the distance of two copies, placed where it takes
        longest.

        | worst | cloud | figure | goal | |
        |---|---|--:|--:|---|

        """;

    public static string Markdown(IReadOnlyCollection<WorstRow> rows)
    {
        var text = new StringBuilder();
        text.Append(Header);
        foreach (WorstRow r in rows)
        {
            QueryCost q = r.Query;
            text.Append(
                CultureInfo.InvariantCulture,
                $"| {r.Family} | {r.Points:#,0} | {r.Distinct:#,0} | {r.Corners:#,0} ");
            text.Append(
                CultureInfo.InvariantCulture,
                $"| {r.BuildMs:0.0} | {r.SurfaceMs:0.0} | {Cost(r.Random)} | {Cost(r.Normals)} ");
            text.Append(
                CultureInfo.InvariantCulture,
                $"| {Cost(r.NearNormals)} | {q.Microseconds:0.0} | {q.Placement} | {q.Iterations} |\n");
        }

        text.Append(Legend);
        foreach (int points in WorstRun.Sizes)
        {
            WorstRow[] sized = [.. rows.Where(r => r.Points == points)];
            double share = (double)points / WorstRun.Sizes[^1];
            WorstRow build = sized.MaxBy(r => r.BuildMs)!;
            WorstRow support = sized.MaxBy(WorstSupport)!;
            WorstRow query = sized.MaxBy(r => r.Query.Microseconds)!;
            AppendGoal(text, points, "build, ms", build.Family, build.BuildMs, share * BuildGoalMs);
            AppendGoal(text, points, "support, ns", support.Family, WorstSupport(support), SupportGoalNs);
            AppendGoal(text, points, "distance, µs", query.Family, query.Query.Microseconds, QueryGoalUs);
        }

        return text.ToString();
    }

    /// <summary>One line per row. The first line describes the machine.</summary>
    public static string Csv(IEnumerable<WorstRow> rows, string machine)
    {
        var text = new StringBuilder();
        text.Append("# ").Append(machine).Append('\n').Append(CsvHeader).Append('\n');
        foreach (WorstRow r in rows)
        {
            text.Append(
                CultureInfo.InvariantCulture,
                $"{r.Family},{r.Points},{r.Distinct},{r.Corners},{r.BuildMs:0.###},{r.SurfaceMs:0.###},");
            text.Append(
                CultureInfo.InvariantCulture,
                $"{Cells(r.Random)},{Cells(r.Normals)},{Cells(r.NearNormals)},");
            text.Append(
                CultureInfo.InvariantCulture,
                $"{r.Query.Microseconds:0.###},{r.Query.Placement.Replace(", ", " ")},{r.Query.Iterations}\n");
        }

        return text.ToString();
    }

    private static double WorstSupport(WorstRow r) =>
        Math.Max(r.Random.Worst, Math.Max(r.Normals.Worst, r.NearNormals.Worst));

    private static string Cost(SupportCost cost) =>
        string.Create(CultureInfo.InvariantCulture, $"{cost.Mean:0} / {cost.Worst:0}");

    private static string Cells(SupportCost cost) =>
        string.Create(CultureInfo.InvariantCulture, $"{cost.Mean:0.#},{cost.Worst:0.#}");

    private static void AppendGoal(
        StringBuilder text, int points, string what, string family, double figure, double goal)
    {
        string met = figure <= goal ? "met" : "missed";
        text.Append(
            CultureInfo.InvariantCulture,
            $"| {points:#,0} points: {what} | {family} | {figure:0} | {goal:0} | {met} |\n");
    }
}
