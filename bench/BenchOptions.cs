namespace Gjk.Bench;

/// <summary>This program's own options, taken from the command line. The remaining arguments belong to
/// BenchmarkDotNet.</summary>
public sealed class BenchOptions
{
    public const string HelpText =
        """
        Gjk.Bench measures how fast the library is, compared with the algorithm of the report that it grew from.

          dotnet run -c Release --project bench -- [options] [BenchmarkDotNet's options]

          --filter GLOB     Run these benchmarks, e.g. '*', '*ReportSceneFrames*', '*Primitives*' (default '*', which
                            takes half an hour; BenchmarkDotNet's --job short takes a part of that).
          --table           Measure the report's scenes, random pairs, primitives, hulls of up to 100,000 vertices, the
                            depths and contact points of overlapping pairs, and casts and rays. Library and baseline
                            run in turn in this process, without BenchmarkDotNet. Print one table. Takes about two and a
                            half minutes.
          --scale           Find the intersecting pairs among 20 to 100,000 cubes, at rest and moving, with every broad
                            phase, on one thread and on all, without BenchmarkDotNet. Print the ms per frame in the
                            broad and in the narrow phase, candidates, pairs, memory and bytes allocated. Measure the
                            report's scenes too, and the first frames of the process. Takes four minutes.
          --peers           Build small programs against the Debian packages of Bullet, libccd, FCL and ODE, which are
                            installed where that can be done, and run library and engines in turn on the same pairs:
                            distances, booleans and depths, with the wrong answers counted. Takes two minutes.
          --mono            Build a program of these scenes for Mono, which Unity runs, and for .NET with the net10.0
                            and the netstandard2.1 library, and run library and baseline in turn on each. Print one
                            table with the ratios. Needs Mono (Debian's mono-devel). Takes two minutes.
          --answers DIR     With --peers: time nothing. Write each engine's answers to the pairs of tests/Cases as
                            DIR/ENGINE.FAMILY.csv, for 'gjk-demo judge'.
          --seconds S       Measure for S seconds, from 0.01 to 600. With --table this is per set (default 6, and a part
                            of it for primitives, depths and the largest hulls), with --scale per row (default 1),
                            with --peers per row (default 2), with --mono per runtime (default 30).
          --csv             Keep the figures in bench/results: with --table in MACHINE.csv, with --scale in
                            MACHINE-scale.csv, with --peers in MACHINE-peers.csv, with --mono in MACHINE-mono.csv.
          --machine NAME    Use this name for those files and for their first line (default: the CPU's model).
          --factor          Check that both algorithms agree on the report's scenes, and that the library takes no more
                            supports there than it should, and no memory. Counts, not times, so a busy machine changes
                            nothing. Exit with 1 if a count is above its limit.
          --help            Print this text. '--help all' adds BenchmarkDotNet's.

        BenchmarkDotNet's figures are per pair, per call of SupportAlone, or per frame of 190 pairs in
        ReportSceneFrames, and in BenchmarkDotNet.Artifacts, too.
        On one core (taskset), set DOTNET_TC_DelaySingleProcMultiplier=1, because .NET optimises ten times later there.
        Exit codes: 0 done, 1 a benchmark or a check failed or no benchmark was found, 2 bad arguments.

        """;

    public bool Help { get; private set; }

    public bool Csv { get; private set; }

    public bool Factor { get; private set; }

    public bool Table { get; private set; }

    public bool Scale { get; private set; }

    public bool Peers { get; private set; }

    public bool Mono { get; private set; }

    /// <summary>The folder for the engines' answers; null if none was given.</summary>
    public string? Answers { get; private set; }

    /// <summary>Null if none were given.</summary>
    public double? Seconds { get; private set; }

    public string? MachineName { get; private set; }

    /// <summary>The arguments for BenchmarkDotNet.</summary>
    public List<string> Remaining { get; } = [];

    /// <summary>Parses the arguments. Invalid arguments give null and an error of one line.</summary>
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
                case "--peers":
                    options.Peers = true;
                    break;
                case "--mono":
                    options.Mono = true;
                    break;
                case "--seconds":
                    options.Seconds = i + 1 < args.Length ? SecondsOf(args[++i]) : null;
                    if (options.Seconds is not null) break;
                    error = "--seconds: a number from 0.01 to 600 must follow";
                    return null;
                case "--answers" when i + 1 < args.Length && !args[i + 1].StartsWith('-'):
                    options.Answers = args[++i];
                    break;
                case "--answers":
                    error = "--answers: a folder must follow";
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
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double seconds)
            && seconds is >= 0.01 and <= 600
            ? seconds
            : null;

    private bool IsConsistent(out string error)
    {
        error = "";
        bool hasForeign = Factor || Remaining.Count > 0;
        if (Peers && (hasForeign || Table || Scale))
            error = "--peers: takes --answers, or --seconds, --csv and --machine only";
        else if (Mono && (hasForeign || Table || Scale || Peers))
            error = "--mono: takes --seconds, --csv and --machine only";
        else if (Answers is not null && (!Peers || Csv || Seconds is not null))
            error = "--answers: goes with --peers only, and without --seconds and --csv";
        else if (Table && (hasForeign || Scale))
            error = "--table: takes --seconds, --csv and --machine only";
        else if (Scale && hasForeign)
            error = "--scale: takes --seconds, --csv and --machine only";
        else if (Seconds is not null && !Table && !Scale && !Peers && !Mono)
            error = "--seconds: goes with --table, --scale, --peers and --mono only";
        else if (Factor && (Csv || MachineName is not null || Remaining.Count > 0))
            error = "--factor: takes no other option";
        else if (Csv && !Table && !Scale && !Peers && !Mono)
            error = "--csv: goes with --table, --scale, --peers and --mono only";
        else if (Help && Remaining.Count > 0 && (Remaining.Count > 1 || Remaining[0] != "all"))
            error = "--help: takes nothing but 'all'";
        return error.Length == 0;
    }
}
