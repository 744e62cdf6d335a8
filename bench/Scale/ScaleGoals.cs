using Gjk.Bench.Scenes;
using Gjk.Bench.Table;

namespace Gjk.Bench.Scale;

/// <summary>The goals for frames, in milliseconds on two cores of the machine on which the other engines were measured.
/// They are scaled to this machine as <see cref="Goals"/> are.</summary>
internal static class ScaleGoals
{
    /// <summary>How many seconds are used to measure how slow this machine is.</summary>
    private const double BaselineSeconds = 1;

    /// <summary>The goal of a row. Null if none was set: at rest, no distance is solved.</summary>
    public static double? For(ScaleRow row, int cores) => row switch
    {
        { Question: Question.Distances, IsMoving: false } => null,
        { Question: Question.Distances, Scene: ReportScenes.Cubes } => 0.010,
        { Question: Question.Distances, Scene: ReportScenes.Spheres } => 0.014,
        { Scene: ReportScenes.Cubes or ReportScenes.Spheres } => 0.004,
        { IsMoving: true, Phase: Core.BroadPhaseKind.DynamicTree } when row.Threads == cores => row.Objects switch
        {
            2_000 => 0.5,
            20_000 => 6,
            100_000 => 35,
            _ => null,
        },
        _ => null,
    };

    /// <summary>How many times slower this machine is than the goals' machine. It is measured by the time that the
    /// report's algorithm needs for the report's scenes.</summary>
    public static double Slowness()
    {
        TableSet[] scenes = [.. ReportScenes.Names.Select(TableSet.OfReportScene)];
        foreach (TableSet scene in scenes)
        {
            TurnTaking.WarmUp([scene.Baseline!], BaselineSeconds);
            TurnTaking.Measure([scene.Baseline!], BaselineSeconds);
        }

        return Goals.MeanSlowness(scenes.Select(s => s.Slowness).OfType<double>());
    }
}
