using Gjk.Bench.Reporting;
using Gjk.Core;

namespace Gjk.Bench.Scale;

/// <summary>A figure of how the time of a frame grows with the number of moving objects.</summary>
internal static class ScaleFigure
{
    private const double NsPerMs = 1e6;

    private static readonly (BroadPhaseKind Phase, string Colour)[] Phases =
    [
        (BroadPhaseKind.SortAndSweep, "#8250df"), (BroadPhaseKind.DynamicTree, "#0969da"),
    ];

    public static string Draw(IReadOnlyCollection<ScaleRow> rows, string machine)
    {
        ScaleRow[] moving = [.. rows.Where(r => r.Scene == ScaleRun.Room && r.IsMoving && r.Threads == 1)];
        ScaleRow[] narrow = [.. moving.Where(r => r.Phase == BroadPhaseKind.DynamicTree)];
        return new LogLogChart(
        [
            .. Phases.Select(p => Line(
                ScaleReport.PhaseName(p.Phase), p.Colour, moving.Where(r => r.Phase == p.Phase),
                r => r.Figures.BroadMs)),
            Line("narrow phase", "#bf5b04", narrow, r => r.Figures.NarrowMs),
        ])
        {
            Title = "Intersecting pairs: time per frame over the objects",
            Subtitle = "Moving cubes, half touching another; one thread. " + machine,
            AxisX = "objects",
            AxisY = "time per frame",
            Unit = TimeText.Of,
        }.Draw();
    }

    private static ChartLine Line(
        string name, string colour, IEnumerable<ScaleRow> rows, Func<ScaleRow, double?> milliseconds) =>
        new(name, colour, [.. rows.Select(r => ((double)r.Objects, milliseconds(r)!.Value * NsPerMs))]);
}
