namespace Gjk.Bench.Mono;

/// <summary>The library on Unity's runtime and on .NET, each measured beside the report's algorithm.</summary>
internal static class MonoRun
{
    /// <summary>Seconds for each runtime.</summary>
    public const double DefaultSeconds = 30;

    /// <summary>Each runtime measures so often, in turns, and the least figure counts: a slow spell of the machine then
    /// meets all of them.</summary>
    private const int Turns = 2;

    /// <returns>For each runtime the nanoseconds of each row, in the order of <see cref="MonoColumn.All"/>.</returns>
    /// <exception cref="FactorCheckException">Mono is missing, or a program does not build or ends early.</exception>
    public static List<Dictionary<string, double>> Run(
        TextWriter progress, string project, double seconds, out string mono)
    {
        mono = MonoBuild.MonoVersion();
        string folder = Directory.CreateTempSubdirectory("gjk-runtimes").FullName;
        try
        {
            var files = new List<string>();
            foreach (MonoColumn column in MonoColumn.All)
            {
                progress.WriteLine($"building for {column.Name}");
                files.Add(MonoBuild.Build(project, folder, column));
            }

            List<Dictionary<string, double>> figures = [.. files.Select(_ => new Dictionary<string, double>())];
            for (int turn = 0; turn < Turns; turn++)
            {
                for (int i = 0; i < files.Count; i++)
                {
                    progress.WriteLine($"measuring on {MonoColumn.All[i].Name}");
                    foreach ((string row, double time) in MonoBuild.Run(files[i], MonoColumn.All[i], seconds / Turns))
                        figures[i][row] = Math.Min(time, figures[i].GetValueOrDefault(row, double.PositiveInfinity));
                }
            }

            return figures;
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }
}
