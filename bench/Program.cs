using System;
using System.IO;
using System.Linq;
using BenchmarkDotNet.Configs;
using BenchmarkDotNet.Jobs;
using BenchmarkDotNet.Reports;
using BenchmarkDotNet.Running;
using BenchmarkDotNet.Toolchains.InProcess.Emit;
using Gjk.Bench.Reporting;

namespace Gjk.Bench;

public static class Program
{
    private const int Done = 0;
    private const int Failed = 1;
    private const int BadArguments = 2;

    /// <summary>Options of BenchmarkDotNet that print something and measure nothing.</summary>
    private static readonly string[] PrintOnly = ["--list", "--info", "--version"];

    public static int Main(string[] args)
    {
        BenchOptions? options = BenchOptions.Parse(args, out string error);
        if (options is null) return Complain(error, BadArguments);
        if (options.Help) return PrintHelp(options);
        if (options.Factor) return CheckFactors();

        string? results = options.Csv ? ResultsFolder() : null;
        return options.Csv && results is null
            ? Complain("--csv: the folder of Gjk.Bench.csproj was not found above the program or the current folder", BadArguments)
            : Measure(options, results);
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

    private static int Measure(BenchOptions options, string? results)
    {
        string[] args = [.. options.Remaining];
        bool printOnly = args.Any(a => PrintOnly.Contains(a));
        // Without a filter BenchmarkDotNet asks on the console, which a script cannot answer.
        if (!printOnly && !args.Any(a => a is "--filter" or "-f")) args = [.. args, "--filter", "*"];

        Summary[] summaries = [.. BenchmarkSwitcher.FromAssembly(typeof(Program).Assembly).Run(args, Config(options.Quick))];
        if (summaries.Length == 0) return printOnly ? Done : Failed;

        string machine = options.MachineName is null ? "" : options.MachineName.ReplaceLineEndings(" ") + ": ";
        string text = SummaryCsv.Format(summaries, machine + Machine.Description + (options.Quick ? ", quick run" : ""));
        SummaryCsv.Write(Path.Combine(DefaultConfig.Instance.ArtifactsPath, "summary.csv"), text);
        if (results is not null)
        {
            string file = Path.Combine(results, Machine.FileName(options.MachineName ?? Machine.CpuModel) + ".csv");
            SummaryCsv.Write(file, text);
            Console.WriteLine($"Figures kept in {file}");
        }

        bool complete = summaries.All(s => !s.HasCriticalValidationErrors && s.Reports.Length == s.BenchmarksCases.Length && s.Reports.All(r => r.Success));
        return complete ? Done : Failed;
    }

    private static IConfig? Config(bool quick) => !quick
        ? null
        : DefaultConfig.Instance
            .AddJob(Job.ShortRun.WithToolchain(InProcessEmitToolchain.Instance))
            .AddFilter(new QuickFilter());

    /// <summary>bench/results, found from where the program was built or is run.</summary>
    private static string? ResultsFolder()
    {
        foreach (string start in new[] { AppContext.BaseDirectory, Environment.CurrentDirectory, Path.Combine(Environment.CurrentDirectory, "bench") })
        {
            for (DirectoryInfo? folder = new(start); folder is not null; folder = folder.Parent)
                if (File.Exists(Path.Combine(folder.FullName, "Gjk.Bench.csproj"))) return Path.Combine(folder.FullName, "results");
        }

        return null;
    }

    private static int Complain(string message, int exitCode)
    {
        Console.Error.WriteLine(message);
        return exitCode;
    }
}
