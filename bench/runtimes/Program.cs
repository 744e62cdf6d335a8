using Gjk.Bench.Table;

namespace Gjk.Bench.Runtimes;

/// <summary>Measures the queries on the runtime that started it, the library and the report's algorithm in turn. The
/// only argument is for how many seconds. Prints a line for each row: name, what a call is, its nanoseconds.</summary>
internal static class Program
{
    /// <summary>The most seconds of warm-up.</summary>
    private const double WarmUpSeconds = 10;

    private static void Main(string[] args)
    {
        double seconds = double.Parse(args[0], CultureInfo.InvariantCulture);
        (string Name, TimedLoop Loop)[] rows = [.. RuntimeRows.All()];
        TimedLoop[] loops = [.. rows.Select(r => r.Loop)];
        TurnTaking.WarmUp(loops, Math.Min(WarmUpSeconds, seconds));
        TurnTaking.Measure(loops, seconds);
        foreach ((string name, TimedLoop loop) in rows)
            Console.WriteLine(FormattableString.Invariant($"{name},{loop.Nanoseconds:0.###}"));
    }
}
