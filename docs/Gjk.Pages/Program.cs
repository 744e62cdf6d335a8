using System.IO;

namespace Gjk.Pages;

internal static class Program
{
    /// <summary>Writes the figures, the reference and the tables of results into the project that it runs
    /// in.</summary>
    private static int Main(string[] args)
    {
        if (args.Length > 0 || !Directory.Exists("docs") || !Directory.Exists("src"))
        {
            Console.Error.WriteLine(
                "Gjk.Pages writes docs/figures, docs/api and what pages show of bench/results. It takes no arguments "
                + "and runs in the project's folder: dotnet run -c Release --project docs/Gjk.Pages");
            return args is ["--help"] or ["-h"] ? 0 : 2;
        }

        foreach (Figure figure in AllFigures.Make("."))
            File.WriteAllText(Path.Combine("docs", "figures", figure.Name + ".svg"), figure.Svg);
        string api = Directory.CreateDirectory(Path.Combine("docs", "api")).FullName;
        foreach ((string name, string text) in ReferencePages.Make(Path.Combine("src", "Gjk.Core")))
            File.WriteAllText(Path.Combine(api, name), text);
        var blocks = ResultBlocks.Make(".");
        foreach (string page in ResultBlocks.Pages)
            File.WriteAllText(page, ResultBlocks.Fill(File.ReadAllText(page), blocks));
        return 0;
    }
}
