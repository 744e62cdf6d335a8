using System.Text.RegularExpressions;
using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests.Api;

/// <summary>What lies in the repository is known, can be started, and is started by something.</summary>
public class RepositoryTests
{
    /// <summary>What a clone has in its root. A file that some command left there is noticed.</summary>
    private static readonly string[] Known =
    [
        ".ci", ".editorconfig", ".gitattributes", ".github", ".gitignore", "CHANGELOG.md", "CODE_OF_CONDUCT.md",
        "CONTRIBUTING.md", "Directory.Build.props", "Directory.Packages.props", "Gjk.sln", "Gjk.snk", "LICENSE",
        "README.md", "SECURITY.md", "bench", "docs", "global.json", "pack.sh", "proofs", "samples", "src", "tests",
        "unity",
    ];

    [Fact]
    public void EveryEntryOfTheRootIsKnown()
    {
        string[] ignored = File.ReadAllLines(Path.Combine(ProjectFolder.Root, ".gitignore"));
        bool IsIgnored(string name) =>
            name == ".git" || ignored.Any(i => i.Trim('/') == name || (i.StartsWith('*') && name.EndsWith(i[1..])));
        Assert.Equal(
            Known.Order(StringComparer.Ordinal),
            Directory.EnumerateFileSystemEntries(ProjectFolder.Root).Select(e => Path.GetFileName(e)!)
                .Where(name => !IsIgnored(name)).Order(StringComparer.Ordinal));
    }

    [Fact]
    public void EveryScriptCanBeStarted()
    {
        string[] scripts = [.. Tracked("*.sh").Where(s => File.ReadLines(s).First().StartsWith("#!"))];
        Assert.True(scripts.Length > 15, $"{scripts.Length} scripts");
        if (OperatingSystem.IsWindows()) return;
        Assert.Empty(scripts.Where(s => (File.GetUnixFileMode(s) & UnixFileMode.UserExecute) == 0));
    }

    /// <summary>A project is part of the solution, or has a script beside it that is part of a run.</summary>
    [Fact]
    public void EveryProjectIsBuiltBySomething()
    {
        string solution = Read("Gjk.sln").Replace('\\', '/'), runs = Read(".ci/run") + Read("tests/long.sh");
        string[] projects = [.. Tracked("*.csproj").Select(p => Path.GetRelativePath(ProjectFolder.Root, p))];
        Assert.True(projects.Length > 20, $"{projects.Length} projects");
        Assert.Empty(projects.Select(p => p.Replace('\\', '/')).Where(
            p => !solution.Contains($"\"{p}\"") && !runs.Contains(p[..p.LastIndexOf('/')] + "/run.sh")));
    }

    private static string Read(string path) => File.ReadAllText(Path.Combine(ProjectFolder.Root, path));

    private static IEnumerable<string> Tracked(string pattern) =>
        new[] { "bench", "docs", "proofs", "samples", "src", "tests", "unity" }
            .SelectMany(f => Directory.EnumerateFiles(
                Path.Combine(ProjectFolder.Root, f), pattern, SearchOption.AllDirectories))
            .Where(f => !Regex.IsMatch(f, @"[\\/](bin|obj|node_modules|TestResults)[\\/]"));
}
