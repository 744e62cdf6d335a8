namespace Gjk.Bench.Scale;

/// <summary>Measures how the time of a frame grows with the number of objects. It measures every broad phase, at rest
/// and moving, on one thread and on all, and the report's scenes.</summary>
internal static class ScaleRun
{
    /// <summary>The name of the scenes with any number of cubes.</summary>
    public const string Room = "room";

    /// <summary>How many seconds a row is measured. With this value the whole run takes about four minutes.</summary>
    public const double DefaultSeconds = 1;

    private static readonly int[] Sizes = [20, 200, 2_000, 20_000, 100_000];

    private static readonly BroadPhaseKind[] Phases = [BroadPhaseKind.SortAndSweep, BroadPhaseKind.DynamicTree];

    /// <param name="progress">Receives a line per size.</param>
    /// <param name="seconds">How many seconds to measure a row, after a warm-up of one second.</param>
    /// <param name="startUp">The first frames of the process, as text.</param>
    public static List<ScaleRow> Run(TextWriter progress, double seconds, out string startUp)
    {
        progress.WriteLine("start-up");
        startUp = StartUpClock.Measure();
        using var workers = new Workers();
        return [.. ReportRows(progress, seconds), .. RoomRows(progress, seconds, workers)];
    }

    private static IEnumerable<ScaleRow> ReportRows(TextWriter progress, double seconds)
    {
        progress.WriteLine("the report's scenes");
        foreach (string name in ReportScenes.Names)
        {
            foreach (Question question in Enum.GetValues<Question>())
            {
                yield return ReportSceneClock.Measure(name, question, isMoving: false, seconds);
                yield return ReportSceneClock.Measure(name, question, isMoving: true, seconds);
            }
        }
    }

    private static IEnumerable<ScaleRow> RoomRows(TextWriter progress, double seconds, Workers workers)
    {
        foreach (int count in Sizes)
        {
            progress.WriteLine(FormattableString.Invariant($"{count} objects"));
            foreach (bool isMoving in new[] { false, true })
            {
                foreach (BroadPhaseKind phase in Phases)
                {
                    yield return Row(count, isMoving, phase, null, seconds);
                    if (workers.ThreadCount > 1) yield return Row(count, isMoving, phase, workers, seconds);
                }
            }
        }
    }

    private static ScaleRow Row(int count, bool isMoving, BroadPhaseKind phase, Workers? workers, double seconds) =>
        new(
            Room, Question.Overlaps, count, isMoving, phase, workers?.ThreadCount ?? 1,
            RoomClock.Measure(count, isMoving, phase, workers, seconds));
}
