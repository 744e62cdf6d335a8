using System.Text.RegularExpressions;
using Xunit.Abstractions;

namespace Gjk.Core.Tests.Api;

/// <summary>The folders of the library depend on each other as CONTRIBUTING draws it. Solvers know nothing of shapes,
/// shapes know nothing of solvers, and queries join them. The test reads the sources, because the compiler does not
/// know folders.</summary>
public class FolderTests(ITestOutputHelper output)
{
    /// <summary>What each folder may use; the folders below come first.</summary>
    private static readonly (string Folder, string[] Uses)[] Allowed =
    [
        ("Arithmetic", []),
        ("Geometry", ["Arithmetic"]),
        ("Sorting", ["Geometry"]),
        ("Threading", []),
        ("Hulls/Building", ["Arithmetic", "Geometry"]),
        ("Hulls/Lookup", ["Arithmetic", "Geometry"]),
        ("Hulls", ["Arithmetic", "Geometry", "Hulls/Building", "Hulls/Lookup"]),
        ("Cores", ["Arithmetic", "Geometry", "Hulls", "Hulls/Lookup"]),
        ("Shapes", ["Arithmetic", "Geometry", "Hulls", "Hulls/Lookup", "Cores"]),
        ("Simplex", ["Arithmetic", "Geometry"]),
        ("Minkowski", ["Arithmetic", "Geometry", "Cores", "Simplex"]),
        ("Solvers/Trace", ["Geometry", "Minkowski", "Simplex"]),
        ("Solvers", ["Arithmetic", "Geometry", "Cores", "Minkowski", "Simplex", "Solvers/Trace"]),
        (
            "Solvers/Depth",
            ["Arithmetic", "Geometry", "Cores", "Minkowski", "Simplex", "Solvers", "Solvers/Trace"]),
        (
            "Solvers/Motion",
            [
                "Arithmetic", "Geometry", "Cores", "Minkowski", "Simplex", "Solvers", "Solvers/Trace", "Solvers/Depth",
            ]),
        ("Contacts", ["Geometry", "Minkowski", "Simplex", "Solvers"]),
        ("Queries/Rays", ["Arithmetic", "Geometry", "Hulls", "Cores", "Minkowski"]),
        (
            "Queries",
            [
                "Arithmetic", "Geometry", "Cores", "Shapes", "Minkowski", "Simplex", "Solvers", "Solvers/Trace",
                "Solvers/Depth", "Solvers/Motion", "Contacts", "Queries/Rays",
            ]),
        ("BroadPhase", ["Geometry", "Sorting", "Threading"]),
        ("Concave/Trees", ["Arithmetic", "Geometry", "Minkowski", "Threading"]),
        (
            "Concave",
            [
                "Arithmetic", "Geometry", "Hulls/Building", "Cores", "Shapes", "Solvers", "Solvers/Motion",
                "Solvers/Trace", "Contacts", "Queries", "Queries/Rays", "Concave/Trees", "Sorting", "BroadPhase",
                "Threading",
            ]),
        (
            "Diagnostics",
            ["Arithmetic", "Geometry", "Hulls", "Cores", "Shapes", "Queries", "Queries/Rays"]),
        (
            "Wide",
            [
                "Arithmetic", "Geometry", "Hulls", "Hulls/Lookup", "Cores", "Shapes", "Minkowski", "Simplex", "Solvers",
                "Queries", "BroadPhase", "Threading",
            ]),
        ("Batch", ["Geometry", "Shapes", "Solvers", "Queries", "Concave", "Threading", "BroadPhase", "Wide"]),
        (
            "World",
            [
                "Geometry", "Cores", "Shapes", "Solvers", "Contacts", "Queries", "Queries/Rays", "Concave",
                "Concave/Trees", "Threading", "Sorting", "BroadPhase", "Wide", "Batch",
            ]),
    ];

    /// <summary>Lines of code that each folder may have: as many as it had when this was last set.</summary>
    private static readonly Dictionary<string, int> Budgets = new()
    {
        ["Arithmetic"] = 128,
        ["Batch"] = 164,
        ["BroadPhase"] = 993,
        ["Concave"] = 4062,
        ["Concave/Trees"] = 648,
        ["Contacts"] = 1011,
        ["Cores"] = 566,
        ["Diagnostics"] = 651,
        ["Geometry"] = 612,
        ["Hulls"] = 208,
        ["Hulls/Building"] = 822,
        ["Hulls/Lookup"] = 873,
        ["Minkowski"] = 338,
        ["Queries"] = 1897,
        ["Queries/Rays"] = 569,
        ["Shapes"] = 1280,
        ["Simplex"] = 885,
        ["Solvers"] = 604,
        ["Solvers/Depth"] = 1287,
        ["Solvers/Motion"] = 907,
        ["Solvers/Trace"] = 110,
        ["Sorting"] = 89,
        ["Threading"] = 211,
        ["Wide"] = 908,
        ["World"] = 1219,
    };

    [Fact]
    public void EachFolderUsesOnlyWhatLiesBelowIt()
    {
        string root = Path.Combine(ProjectFolder.Root, "src", "Gjk.Core");
        Dictionary<string, string> sources = Sources();
        Dictionary<string, string> folderOf = DeclaredTypes(root, sources);
        Assert.True(folderOf.Count > 80, $"only {folderOf.Count} types were found");
        SortedDictionary<string, SortedSet<string>> graph = [];
        var faults = new List<string>();
        foreach ((string file, string source) in sources)
        {
            string folder = FolderOf(root, file);
            SortedSet<string> uses = graph.TryGetValue(folder, out SortedSet<string>? known)
                ? known
                : graph[folder] = [];
            foreach (string name in Regex.Matches(source, @"\b[A-Z]\w*").Select(m => m.Value).Distinct())
            {
                if (!folderOf.TryGetValue(name, out string? other) || other == folder) continue;
                uses.Add(other);
                if (!MayUse(folder, other)) faults.Add($"{folder}/{Path.GetFileName(file)} uses {name} of {other}");
            }
        }

        foreach ((string folder, SortedSet<string> uses) in graph)
            output.WriteLine($"{folder} -> {string.Join(", ", uses)}");
        Assert.Empty(faults);
        Assert.Empty(Allowed.SelectMany(a => a.Uses.Where(u => !graph[a.Folder].Contains(u)).Select(
            u => $"{a.Folder} may use {u}, and does not")));
        Assert.Equal(Allowed.Select(a => a.Folder).Order(), graph.Keys.Order());
    }

    /// <summary>A folder that must grow gets a larger budget in the commit that says why.</summary>
    [Fact]
    public void NoFolderHasMoreCodeThanItsBudget()
    {
        string root = Path.Combine(ProjectFolder.Root, "src", "Gjk.Core");
        var lines = ProjectFolder.Sources("src/Gjk.Core").GroupBy(file => FolderOf(root, file))
            .ToDictionary(folder => folder.Key, folder => folder.Sum(file => CodeLines.In(File.ReadAllText(file))));
        foreach ((string folder, int count) in lines.OrderBy(l => l.Key)) output.WriteLine($"{folder}: {count}");
        Assert.Equal(Budgets.Keys.Order(), lines.Keys.Order());
        Assert.Empty(lines.Where(l => l.Value > Budgets[l.Key]).Select(
            l => $"{l.Key} has {l.Value} lines of code, and {Budgets[l.Key]} are its budget"));
    }

    [Fact]
    public void OnlyCodeIsCounted()
    {
        const string source = """
            using System;

            namespace A;
            #if NET
            // No.
            /// <summary>No.</summary>
            class B
            {
                int _c; // Yes.
                int[] D() =>
                [
                ];
                });
                using var e = F();
            }
            #endif
            """;
        Assert.Equal(4, CodeLines.In(source));
    }

    [Fact]
    public void TheAllowedFoldersHaveNoCycle()
    {
        var seen = new HashSet<string>();
        foreach ((string folder, string[] uses) in Allowed)
        {
            Assert.All(uses, use => Assert.Contains(use, seen));
            Assert.True(seen.Add(folder), folder);
        }
    }

    /// <summary>A drawn arrow is a use, and every use follows from drawn arrows.</summary>
    [Fact]
    public void TheGuideForContributorsDrawsWhatTheFoldersUse()
    {
        string guide = File.ReadAllText(Path.Combine(ProjectFolder.Root, "CONTRIBUTING.md"));
        var drawn = new HashSet<(string User, string Used)>();
        foreach (string line in guide.Split('\n').Where(line => Regex.IsMatch(line, "/ +<-")))
        {
            string[][] groups = [.. Regex.Replace(line, "[ /]", "").Split("<-").Select(group => group.Split(','))];
            for (int i = 1; i < groups.Length; i++)
                drawn.UnionWith(groups[i].SelectMany(user => groups[i - 1].Select(used => (user, used))));
        }

        var uses = Allowed.SelectMany(a => a.Uses.Select(u => (User: Top(a.Folder), Used: Top(u))))
            .Where(use => use.User != use.Used).ToHashSet();
        Assert.Empty(drawn.Except(uses));
        var follows = new HashSet<(string User, string Used)>(drawn);
        foreach (string folder in Allowed.Select(a => Top(a.Folder)).Distinct())
        {
            follows.UnionWith(drawn.Where(d => d.User == folder).SelectMany(
                d => follows.Where(f => f.User == d.Used).Select(f => (folder, f.Used))).ToArray());
        }

        Assert.Empty(uses.Except(follows));

        static string Top(string folder) => folder.Split('/')[0];
    }

    private static bool MayUse(string folder, string other) =>
        Allowed.Any(a => a.Folder == folder && a.Uses.Contains(other));

    private static string FolderOf(string root, string file) =>
        Path.GetRelativePath(root, Path.GetDirectoryName(file)!).Replace('\\', '/');

    /// <summary>The sources without comments and strings.</summary>
    private static Dictionary<string, string> Sources() => ProjectFolder.Sources("src/Gjk.Core").ToDictionary(
        file => file, file => Regex.Replace(File.ReadAllText(file), @"//[^\n]*|""(\\.|[^""\\\n])*""", " "));

    /// <summary>The types that begin a line; nested ones are known by the type around them.</summary>
    private static Dictionary<string, string> DeclaredTypes(string root, Dictionary<string, string> sources)
    {
        const string declaration = @"^(?:public|internal)[ \w]*?\b(?:class|struct|interface|enum)\s+([A-Z]\w*)";
        var folderOf = new Dictionary<string, string>();
        foreach ((string file, string source) in sources)
        {
            foreach (Match match in Regex.Matches(source, declaration, RegexOptions.Multiline))
                folderOf[match.Groups[1].Value] = FolderOf(root, file);
        }

        return folderOf;
    }
}
