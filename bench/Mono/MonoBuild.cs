namespace Gjk.Bench.Mono;

/// <summary>Builds the program of <c>runtimes</c> for a runtime, and runs it there.</summary>
internal static class MonoBuild
{
    /// <summary>Lines of a failed build that are shown.</summary>
    private const int LinesShown = 3;

    /// <exception cref="FactorCheckException">Mono is not installed.</exception>
    public static string MonoVersion()
    {
        string text = Output(
            "mono", ["--version"], "--mono: Mono cannot be run; on Debian: apt-get install mono-devel");
        return text.Split('\n')[0].Split(" (")[0];
    }

    /// <summary>Builds the program and returns its file.</summary>
    /// <exception cref="FactorCheckException">It does not build.</exception>
    public static string Build(string project, string folder, MonoColumn column)
    {
        string output = Path.Combine(folder, column.Name);
        Output(
            "dotnet",
            [
                "build", Path.Combine(project, "runtimes"), "-c", "Release", "-v", "quiet", "--nologo", "-o", output,
                "-f", column.Framework, $"-p:LibraryTarget={column.Library}",
            ],
            $"--mono: the program for {column.Name} does not build");
        return Path.Combine(output, column.Framework == MonoColumn.MonoFramework ? "Gjk.Bench.exe" : "Gjk.Bench.dll");
    }

    /// <summary>Runs the program and returns the nanoseconds of each row.</summary>
    /// <exception cref="FactorCheckException">It ends early.</exception>
    public static Dictionary<string, double> Run(string file, MonoColumn column, double seconds)
    {
        string runtime = column.Framework == MonoColumn.MonoFramework ? "mono" : "dotnet";
        string text = Output(
            runtime, [file, seconds.ToString(CultureInfo.InvariantCulture), column.Build],
            $"--mono: the run on {column.Name} failed");
        return text.Split('\n', StringSplitOptions.RemoveEmptyEntries)
            .Select(line => line.Split(','))
            .ToDictionary(p => p[0], p => double.Parse(p[1], CultureInfo.InvariantCulture));
    }

    private static string Output(string program, string[] arguments, string complaint)
    {
        var start = new ProcessStartInfo(program, arguments)
        {
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        try
        {
            using Process process = Process.Start(start)!;
            Task<string> errors = process.StandardError.ReadToEndAsync();
            string text = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            if (process.ExitCode == 0) return text;
            IEnumerable<string> lines = (text + errors.Result).Split('\n').Where(l => l.Length > 0).Take(LinesShown);
            throw new FactorCheckException($"{complaint}: {string.Join(' ', lines)}");
        }
        catch (System.ComponentModel.Win32Exception e)
        {
            throw new FactorCheckException($"{complaint}: {e.Message}");
        }
    }
}
