using System.Runtime.Versioning;
using System.Text.RegularExpressions;

namespace Gjk.Core.Tests.Api;

/// <summary>What lies in the repository is known, can be started, and is started by something.</summary>
public class RepositoryTests
{
    /// <summary>What a clone has in its root. A file that some command left there is noticed.</summary>
    private static readonly string[] Known =
    [
        ".ci", ".editorconfig", ".gitattributes", ".github", ".gitignore", "CHANGELOG.md", "CODE_OF_CONDUCT.md",
        "CONTRIBUTING.md", "Directory.Build.props", "Directory.Packages.props", "Directory.Solution.targets",
        "Gjk.sln", "Gjk.snk", "LICENSE", "README.md", "SECURITY.md", "bench", "docs", "global.json",
        "pack.sh", "proofs", "samples", "src", "tests", "unity",
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
        Assert.All(scripts, CanBeStarted);
    }

    /// <summary>A project is part of the solution, or its folder is named by a run.</summary>
    [Fact]
    public void EveryProjectIsBuiltBySomething()
    {
        string solution = Read("Gjk.sln").Replace('\\', '/'), runs = Read(".ci/run") + Read("tests/long.sh");
        string[] projects = [.. Tracked("*.csproj").Select(p => Path.GetRelativePath(ProjectFolder.Root, p))];
        Assert.True(projects.Length > 20, $"{projects.Length} projects");
        Assert.All(projects.Select(p => p.Replace('\\', '/')), p => Assert.True(
            solution.Contains($"\"{p}\"") || runs.Contains(p[..p.LastIndexOf('/')]), p));
    }

    /// <summary>The steps of tests/long.sh that run the long counts: those of namespaces, that of what they leave, and
    /// those of projects.</summary>
    [Fact]
    public void TheLongCountsLeaveNoTestOut()
    {
        string script = Read("tests/long.sh");
        string[] List(string name) => Regex.Match(script, $"(?m)^{name}='([^']*)'").Groups[1].Value.Split(' ');
        string[] steps = [.. Regex.Matches(script, "(?m)^counts-([A-Za-z]+) ").Select(m => m.Groups[1].Value)];
        Assert.Equal(new[] { "netstandard", "others", "rest" }.Union(List("shares")).Order(), steps.Order());
        string[] spaces = [.. GetType().Assembly.GetTypes().Select(t => t.Namespace + ".").Distinct()];
        Assert.All(List("shares"), s => Assert.Contains(spaces, n => n.StartsWith($"Gjk.Core.Tests.{s}.")));

        int start = script.IndexOf("run_step()", StringComparison.Ordinal);
        string runs = script[start..] + string.Join(' ', List("others"));
        string[] projects = [.. Tracked("*.csproj").Where(p => Regex.IsMatch(
            File.ReadAllText(p), @"<IsTestProject>true|Gjk\.Core\.Tests\.props"))];
        Assert.True(projects.Length > 6, $"{projects.Length} projects");
        Assert.All(projects.Select(p => Path.GetFileNameWithoutExtension(p)!), p => Assert.Matches(
            $@"\b{Regex.Escape(p)}(?=\s|$)", runs));
    }

    [UnsupportedOSPlatform("windows")]
    private static void CanBeStarted(string script) =>
        Assert.True((File.GetUnixFileMode(script) & UnixFileMode.UserExecute) != 0, script);

    private static string Read(string path) => File.ReadAllText(Path.Combine(ProjectFolder.Root, path));

    private static IEnumerable<string> Tracked(string pattern) =>
        new[] { "bench", "docs", "proofs", "samples", "src", "tests", "unity" }
            .SelectMany(f => Directory.EnumerateFiles(
                Path.Combine(ProjectFolder.Root, f), pattern, SearchOption.AllDirectories))
            .Where(f => !Regex.IsMatch(f, @"[\\/](bin|obj|node_modules|TestResults)[\\/]"));
}
