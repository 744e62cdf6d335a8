using System.Text.RegularExpressions;

namespace Gjk.Core.Tests.Support;

/// <summary>The project's folder, for tests that read the sources.</summary>
internal static partial class ProjectFolder
{
    /// <summary>The folder with the solution, above the one that the tests run in.</summary>
    public static string Root { get; } = Find();

    /// <summary>All C# files below some folders of the project, without what builds leave there.</summary>
    public static IEnumerable<string> Sources(params string[] folders) =>
        folders.Select(f => Path.Combine(Root, f)).Where(Directory.Exists)
            .SelectMany(f => Directory.EnumerateFiles(f, "*.cs", SearchOption.AllDirectories))
            .Where(f => !Built().IsMatch(f));

    private static string Find()
    {
        string? folder = AppContext.BaseDirectory;
        while (folder is not null && !File.Exists(Path.Combine(folder, "Gjk.sln")))
            folder = Path.GetDirectoryName(folder);
        return folder ?? throw new InvalidOperationException("The tests do not run inside the project's folder.");
    }

    [GeneratedRegex(@"[\\/](bin|obj|node_modules|TestResults)[\\/]")]
    private static partial Regex Built();
}
