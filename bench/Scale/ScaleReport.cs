using System.Text;

namespace Gjk.Bench.Scale;

/// <summary>The rows as text.</summary>
internal static class ScaleReport
{
    private const string CsvHeader =
        "scene,question,objects,motion,broad_phase,threads,broad_ms,narrow_ms,frame_ms,candidates,pairs,touching_share,"
        + "bytes_per_frame,memory_mb";

    public static string Markdown(IReadOnlyCollection<ScaleRow> rows, string startUp)
    {
        var text = new StringBuilder();
        text.Append("| objects | | broad phase | threads | move + broad, ms | narrow, ms | frame, ms | candidates ");
        text.Append("| pairs | touching | bytes per frame | memory, MB |\n");
        text.Append("|--:|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
        foreach (ScaleRow r in rows.Where(r => r.Scene == ScaleRun.Room))
        {
            FrameFigures f = r.Figures;
            text.Append(
                CultureInfo.InvariantCulture,
                $"| {r.Objects:#,0} | {Motion(r)} | {PhaseName(r.Phase)} | {r.Threads} | {Ms(f.BroadMs)} "
                + $"| {Ms(f.NarrowMs)} | {Ms(f.FrameMs)} | {f.Candidates:#,0} | {f.Pairs:#,0} "
                + $"| {f.TouchingShare:0 %} | {f.BytesPerFrame:0.##} | {f.MemoryMb:0.0} |\n");
        }

        AppendReportScenes(text, rows);
        text.Append(CultureInfo.InvariantCulture, $"\n{Growth(rows)}\n{startUp}");
        text.Append(
            CultureInfo.InvariantCulture,
            $"""
            The figures are medians over a second of frames, after a second of warm-up. Both phases run on all threads;
            the narrow one is what a whole frame takes beyond one that ends after the broad phase. At rest, a pair keeps
            its answer from frame to frame: nothing is solved.

            """);
        return text.ToString();
    }

    private static void AppendReportScenes(StringBuilder text, IEnumerable<ScaleRow> rows)
    {
        text.Append("\n| the report's scenes | | frame, ms | pairs | bytes per frame |\n|---|---|--:|--:|--:|\n");
        foreach (ScaleRow r in rows.Where(r => r.Scene != ScaleRun.Room))
        {
            text.Append(
                CultureInfo.InvariantCulture,
                $"| {r.Scene}, {QuestionName(r)} | {Motion(r)} | {Ms(r.Figures.FrameMs)} | {r.Figures.Pairs:#,0} "
                + $"| {r.Figures.BytesPerFrame:0.##} |\n");
        }
    }

    /// <summary>One line per row. The first line describes the machine.</summary>
    public static string Csv(IEnumerable<ScaleRow> rows, string machine)
    {
        var text = new StringBuilder();
        text.Append("# ").Append(machine).Append('\n').Append(CsvHeader).Append('\n');
        foreach (ScaleRow r in rows)
        {
            FrameFigures f = r.Figures;
            text.Append(
                CultureInfo.InvariantCulture,
                $"{r.Scene},{r.Question.ToString().ToLowerInvariant()},{r.Objects},{Motion(r).Replace(' ', '-')},"
                + $"{PhaseName(r.Phase).Replace(' ', '-')},{r.Threads},");
            text.Append(
                CultureInfo.InvariantCulture,
                $"{f.BroadMs:0.######},{f.NarrowMs:0.######},{f.FrameMs:0.######},{f.Candidates:0.#},{f.Pairs:0.#},"
                + $"{f.TouchingShare:0.###},{f.BytesPerFrame:0.##},{f.MemoryMb:0.##}\n");
        }

        return text.ToString();
    }

    public static string PhaseName(Core.BroadPhaseKind phase) => phase switch
    {
        Core.BroadPhaseKind.SortAndSweep => "sort and sweep",
        Core.BroadPhaseKind.DynamicTree => "dynamic tree",
        _ => throw new ArgumentOutOfRangeException(nameof(phase)),
    };

    /// <summary>How the time of the tree's moving frames grows over the three largest scenes, on all threads, compared
    /// with n log n.</summary>
    private static string Growth(IEnumerable<ScaleRow> rows)
    {
        ScaleRow[] tree =
        [
            .. rows.Where(r => r is
            {
                Scene: ScaleRun.Room, IsMoving: true, Phase: Core.BroadPhaseKind.DynamicTree, Objects: >= 2_000,
            })
            .OrderBy(r => r.Objects).ThenBy(r => r.Threads),
        ];
        ScaleRow last = tree[^1], first = tree.First(r => r.Threads == last.Threads);
        double expected = last.Objects * Math.Log(last.Objects) / (first.Objects * Math.Log(first.Objects));
        return string.Create(
            CultureInfo.InvariantCulture,
            $"From {first.Objects:#,0} to {last.Objects:#,0} moving objects a frame takes "
            + $"{last.Figures.FrameMs / first.Figures.FrameMs:0} times as long; n log n grows by {expected:0}.");
    }

    private static string QuestionName(ScaleRow r) =>
        r.Question == Question.Distances ? "190 distances, warm" : "intersecting pairs";

    private static string Motion(ScaleRow r) => r.IsMoving ? "moving" : "at rest";

    /// <summary>Writes a time with at least three digits.</summary>
    private static string Ms(double? milliseconds) => milliseconds switch
    {
        null => "",
        < 0.1 => milliseconds.Value.ToString("0.0000", CultureInfo.InvariantCulture),
        < 10 => milliseconds.Value.ToString("0.000", CultureInfo.InvariantCulture),
        _ => milliseconds.Value.ToString("0.0", CultureInfo.InvariantCulture),
    };
}
