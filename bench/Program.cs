using BenchmarkDotNet.Reports;
using BenchmarkDotNet.Running;
using Gjk.Bench.Mono;
using Gjk.Bench.Peers;
using Gjk.Bench.Reporting;
using Gjk.Bench.Scale;
using Gjk.Bench.Table;

namespace Gjk.Bench;

public static class Program
{
    private const int Done = 0;
    private const int Failed = 1;
    private const int BadArguments = 2;

    /// <summary>Options of BenchmarkDotNet that print something but measure nothing.</summary>
    private static readonly string[] PrintOnly = ["--list", "--info", "--version"];

    public static int Main(string[] args)
    {
        BenchOptions? options = BenchOptions.Parse(args, out string error);
        if (options is null) return Complain(error, BadArguments);
        if (options.Help) return PrintHelp(options);
        if (options.Factor) return CheckFactors();

        string? project = options.Csv ? ProjectFolder() : null;
        if (options.Csv && project is null)
            return Complain(
                "--csv: the folder of Gjk.Bench.csproj was not found above the program or the current folder",
                BadArguments);
        if (options.Table) return PrintTable(options, project);
        if (options.Peers) return PrintPeers(options);
        if (options.Mono) return PrintMono(options);
        return options.Scale ? PrintScale(options, project) : Measure([.. options.Remaining]);
    }

    private static int PrintHelp(BenchOptions options)
    {
        Console.Write(BenchOptions.HelpText);
        if (options.Remaining.Count > 0) BenchmarkSwitcher.FromAssembly(typeof(Program).Assembly).Run(["--help"]);
        return Done;
    }

    private static int CheckFactors()
    {
        try
        {
            return FactorCheck.Run(Console.Out) ? Done : Failed;
        }
        catch (FactorCheckException e)
        {
            return Complain(e.Message, Failed);
        }
    }

    /// <param name="options">The options that were given with --table.</param>
    /// <param name="project">The folder for the figures, or null.</param>
    private static int PrintTable(BenchOptions options, string? project)
    {
        List<TableRow> rows;
        try
        {
            rows = TableRun.Run(Console.Error, options.Seconds ?? TableRun.DefaultSeconds);
        }
        catch (FactorCheckException e)
        {
            return Complain(e.Message, Failed);
        }

        Console.Write(TableReport.Markdown(rows));
        if (project is null) return Done;
        return Keep(options, project, "", TableReport.Csv(rows, MachineLine(options)));
    }

    /// <inheritdoc cref="PrintTable"/>
    private static int PrintScale(BenchOptions options, string? project)
    {
        double seconds = options.Seconds ?? ScaleRun.DefaultSeconds;
        List<ScaleRow> rows = ScaleRun.Run(Console.Error, seconds, out string startUp);
        Console.Write(ScaleReport.Markdown(rows, startUp));
        if (project is null) return Done;
        return Keep(options, project, "-scale", ScaleReport.Csv(rows, MachineLine(options)));
    }

    private static int PrintPeers(BenchOptions options)
    {
        if (ProjectFolder() is not string project)
            return Complain("--peers: the folder bench with the programs' sources was not found", BadArguments);
        try
        {
            if (options.Answers is { } folder)
            {
                PeerAnswers.Run(Console.Error, project, folder);
                return Done;
            }

            List<PeerRow> rows = PeersRun.Run(
                Console.Error, project, options.Seconds ?? PeersRun.DefaultSeconds, out List<PeerProgram> programs);
            Console.Write(PeersReport.Markdown(rows, programs));
            return options.Csv ? Keep(options, project, "-peers", PeersReport.Csv(rows, MachineLine(options))) : Done;
        }
        catch (FactorCheckException e)
        {
            return Complain(e.Message, Failed);
        }
    }

    private static int PrintMono(BenchOptions options)
    {
        if (ProjectFolder() is not string project)
            return Complain("--mono: the folder bench with the program's sources was not found", BadArguments);
        try
        {
            List<Dictionary<string, double>> figures = MonoRun.Run(
                Console.Error, project, options.Seconds ?? MonoRun.DefaultSeconds, out string mono);
            Console.Write(MonoReport.Markdown(figures, mono));
            return options.Csv
                ? Keep(options, project, "-mono", MonoReport.Csv(figures, MachineLine(options), mono))
                : Done;
        }
        catch (FactorCheckException e)
        {
            return Complain(e.Message, Failed);
        }
    }

    private static int Keep(BenchOptions options, string project, string suffix, string csv)
    {
        string name = Machine.FileName(options.MachineName ?? Machine.CpuModel);
        string file = Path.Combine(project, "results", name + suffix + ".csv");
        KeptFile.Write(file, csv);
        Console.Error.WriteLine($"Figures kept in {file}");
        return Done;
    }

    private static int Measure(string[] args)
    {
        bool printOnly = args.Any(a => PrintOnly.Contains(a));

        // Without a filter BenchmarkDotNet asks a question on the console, which a script cannot answer.
        if (!printOnly && !args.Any(a => a is "--filter" or "-f")) args = [.. args, "--filter", "*"];
        Summary[] summaries = [.. BenchmarkSwitcher.FromAssembly(typeof(Program).Assembly).Run(args)];
        if (summaries.Length == 0) return printOnly ? Done : Failed;
        bool complete = summaries.All(s =>
            !s.HasCriticalValidationErrors
            && s.Reports.Length == s.BenchmarksCases.Length
            && s.Reports.All(r => r.Success));
        return complete ? Done : Failed;
    }

    private static string MachineLine(BenchOptions options) =>
        (options.MachineName is null ? "" : options.MachineName.ReplaceLineEndings(" ") + ": ") + Machine.Description;

    /// <summary>The folder bench. It is found from the place where the program was built or is run.</summary>
    private static string? ProjectFolder()
    {
        string current = Environment.CurrentDirectory;
        foreach (string start in new[] { AppContext.BaseDirectory, current, Path.Combine(current, "bench") })
        {
            for (DirectoryInfo? folder = new(start); folder is not null; folder = folder.Parent)
                if (File.Exists(Path.Combine(folder.FullName, "Gjk.Bench.csproj"))) return folder.FullName;
        }

        return null;
    }

    private static int Complain(string message, int exitCode)
    {
        Console.Error.WriteLine(message);
        return exitCode;
    }
}
