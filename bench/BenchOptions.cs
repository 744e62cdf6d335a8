using System.Collections.Generic;
using System.Globalization;

namespace Gjk.Bench;

/// <summary>This program's own options, taken out of the command line; what is left belongs to BenchmarkDotNet.</summary>
public sealed class BenchOptions
{
    public const string HelpText =
        """
        Gjk.Bench: how fast the library is, beside the algorithm of the report it grew from.

          dotnet run -c Release --project bench -- [options] [BenchmarkDotNet's options]

          --filter GLOB     which benchmarks, e.g. '*', '*ReportSceneFrames*', '*Primitives*' (default '*')
          --quick           the report's scenes, distance cold, warm and by the baseline, three short iterations in this process: a minute.
                            Without it every benchmark runs in a process of its own; '*' takes half an hour.
          --table           no BenchmarkDotNet: every figure of the goals, on the report's scenes, random pairs, primitives and hulls of up to 100,000
                            vertices, library and baseline in turn in this process; prints a table with the goals scaled to this machine.
                            Two minutes.
          --scale           no BenchmarkDotNet: which pairs intersect among 20 to 100,000 cubes, at rest and moving, for every broad phase, on one thread
                            and on all: ms per frame in the broad and in the narrow phase, candidates, pairs, memory, bytes allocated; and the report's
                            scenes, all judged by the goals. Four minutes.
          --worst           no BenchmarkDotNet: clouds made to be slow, of 10,000 and 100,000 points: building their hulls, the slowest supports and
                            the slowest distance of each. A few minutes.
          --scale-worst     no BenchmarkDotNet: the broad phases alone on the worst arrangements of boxes (rods, plates, points on a line,
                            identical, nested, ...). A minute.
          --seconds S       with --table: how long to measure each set (default 6); with --scale: each row (default 1), with --scale-worst
                            (default 0.5); from 0.01 to 600
          --csv             with --table: keep the figures as bench/results/MACHINE.csv and draw docs/cost.svg; with --scale: as MACHINE-scale.csv,
                            and docs/scale.svg; with --worst: as MACHINE-worst.csv; otherwise keep those of BenchmarkDotNet as MACHINE-benchmarkdotnet.csv (replaced whole: use it
                            with --filter '*')
          --machine NAME    the name for those files and their first line (default: the CPU's model)
          --factor          no BenchmarkDotNet: check that both algorithms agree on the report's scenes, time them in turn, print the
                            factor per scene, and exit 1 if it is below the wanted one. About ten seconds.
          --help            this text; '--help all' adds BenchmarkDotNet's

        Every run writes its figures to BenchmarkDotNet.Artifacts/summary.csv in the current folder. The columns: benchmark; set (its
        parameter, or the category where there is none); mean_ns and stddev_ns, per pair, per call of SupportAlone, per frame of 190 pairs
        in ReportSceneFrames; ratio, the mean over the baseline's of the same group and set (below 1 is faster); allocated_bytes, likewise.
        On one core (taskset), set DOTNET_TC_DelaySingleProcMultiplier=1: .NET optimises ten times later there.
        Exit codes: 0 done, 1 a benchmark or a check failed or none was found, 2 bad arguments.

        """;

    public bool Help { get; private set; }

    public bool Quick { get; private set; }

    public bool Csv { get; private set; }

    public bool Factor { get; private set; }

    public bool Table { get; private set; }

    public bool Scale { get; private set; }

    public bool Worst { get; private set; }

    public bool ScaleWorst { get; private set; }

    /// <summary>Null where none were given.</summary>
    public double? Seconds { get; private set; }

    public string? MachineName { get; private set; }

    /// <summary>What BenchmarkDotNet gets.</summary>
    public List<string> Remaining { get; } = [];

    /// <summary>Null and a one-line error for arguments that make no sense.</summary>
    public static BenchOptions? Parse(string[] args, out string error)
    {
        var options = new BenchOptions();
        error = "";
        for (int i = 0; i < args.Length; i++)
        {
            switch (args[i])
            {
                case "--help" or "-h" or "-?":
                    options.Help = true;
                    break;
                case "--quick":
                    options.Quick = true;
                    break;
                case "--csv":
                    options.Csv = true;
                    break;
                case "--factor":
                    options.Factor = true;
                    break;
                case "--table":
                    options.Table = true;
                    break;
                case "--scale":
                    options.Scale = true;
                    break;
                case "--worst":
                    options.Worst = true;
                    break;
                case "--scale-worst":
                    options.ScaleWorst = true;
                    break;
                case "--seconds":
                    options.Seconds = i + 1 < args.Length ? SecondsOf(args[++i]) : null;
                    if (options.Seconds is not null) break;
                    error = "--seconds: a number from 0.01 to 600 must follow";
                    return null;
                case "--machine" when i + 1 < args.Length && !args[i + 1].StartsWith('-'):
                    options.MachineName = args[++i];
                    break;
                case "--machine":
                    error = "--machine: a name must follow";
                    return null;
                default:
                    options.Remaining.Add(args[i]);
                    break;
            }
        }

        return options.IsConsistent(out error) ? options : null;
    }

    private static double? SecondsOf(string text) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double seconds) && seconds is >= 0.01 and <= 600 ? seconds : null;

    private bool IsConsistent(out string error)
    {
        error = "";
        bool hasForeign = Factor || Quick || Remaining.Count > 0;
        if (Worst && (hasForeign || Table || Scale || Seconds is not null)) error = "--worst: takes --csv and --machine only";
        else if (Table && (hasForeign || Scale)) error = "--table: takes --seconds, --csv and --machine only";
        else if (Scale && hasForeign) error = "--scale: takes --seconds, --csv and --machine only";
        else if (ScaleWorst && (hasForeign || Table || Scale || Csv)) error = "--scale-worst: takes --seconds only";
        else if (Seconds is not null && !Table && !Scale && !ScaleWorst)
            error = "--seconds: goes with --table, --scale and --scale-worst only";
        else if (Factor && (Quick || Csv || MachineName is not null || Remaining.Count > 0)) error = "--factor: takes no other option";
        else if (Help && Remaining.Count > 0 && (Remaining.Count > 1 || Remaining[0] != "all")) error = "--help: takes nothing but 'all'";
        return error.Length == 0;
    }
}
