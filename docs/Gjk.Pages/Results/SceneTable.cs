using System.Globalization;

namespace Gjk.Pages;

/// <summary>What a frame of a whole scene costs.</summary>
internal static class SceneTable
{
    public static string Make(ResultFile scale)
    {
        string[] counts = [.. scale.Rows(("scene", "room"), ("motion", "moving"))
            .Select(row => scale.Cell(row, "objects")).Distinct()];
        return Shown.Table(
            ["moving objects", "candidates", "pairs", "sort and sweep", "dynamic tree", "narrow phase",
                "whole frame, tree", "on 2 threads"],
            0, counts.Select(count => (IEnumerable<string>)
            [
                Thousands(ResultFile.Parse(count)), Thousands(Of(scale, count, "candidates")),
                Thousands(Of(scale, count, "pairs")),
                Shown.Milliseconds(Of(scale, count, "broad_ms", "sort-and-sweep")),
                .. new[] { "broad_ms", "narrow_ms", "frame_ms" }.Select(c => Shown.Milliseconds(Of(scale, count, c))),
                Shown.Milliseconds(Of(scale, count, "frame_ms", threads: "2")),
            ]));
    }

    private static string Thousands(double value) => value.ToString("#,0", CultureInfo.InvariantCulture);

    private static double Of(
        ResultFile scale, string count, string column, string broad = "dynamic-tree", string threads = "1") =>
        scale.Number(column, ("scene", "room"), ("question", "overlaps"), ("objects", count), ("motion", "moving"),
            ("broad_phase", broad), ("threads", threads));
}
