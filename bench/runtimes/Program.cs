using System.Reflection;
using System.Runtime.Versioning;
using Gjk.Bench.Table;

namespace Gjk.Bench.Runtimes;

/// <summary>Measures the queries on the runtime that started it, the library and the report's algorithm in turn. The
/// arguments are for how many seconds, and which build of the library it must be. Prints a line for each row: the name
/// and the nanoseconds of a call.</summary>
internal static class Program
{
    /// <summary>The most seconds of warm-up.</summary>
    private const double WarmUpSeconds = 10;

    private static void Main(string[] args)
    {
        string build = typeof(ConvexQuery).Assembly.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName;
        if (build != args[1]) throw new InvalidOperationException($"The library is the build for {build}.");
        double seconds = double.Parse(args[0], CultureInfo.InvariantCulture);
        (string Name, TimedLoop Loop)[] rows = [.. RuntimeRows.All()];
        TimedLoop[] loops = [.. rows.Select(r => r.Loop)];
        TurnTaking.WarmUp(loops, Math.Min(WarmUpSeconds, seconds));
        TurnTaking.Measure(loops, seconds);
        foreach ((string name, TimedLoop loop) in rows)
            Console.WriteLine(FormattableString.Invariant($"{name},{loop.Nanoseconds:0.###}"));
    }
}
