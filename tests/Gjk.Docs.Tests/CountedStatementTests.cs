using System.Text.Json;
using System.Text.RegularExpressions;
using Gjk.Core;
using Gjk.Pages;

namespace Gjk.Docs.Tests;

/// <summary>What pages say and what can be counted agrees with what is there.</summary>
public class CountedStatementTests
{
    private static readonly string[] Words =
    [
        "no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve",
        "thirteen", "fourteen", "fifteen", "sixteen",
    ];

    /// <summary>"A sample with every convex shape that ends": the types of the format's table that are no parts of
    /// others.</summary>
    [Fact]
    public void TheExampleHasEveryConvexShape()
    {
        string format = Page.Read("docs/scene-format.md");
        Assert.Matches(@"a sample\s+with\s+every\s+convex\s+shape\s+that\s+ends\]\(example\.scene\.json\)", format);
        string shapes = format[format.IndexOf("## The shapes", StringComparison.Ordinal)..];
        string[] types = [.. Regex.Matches(shapes, @"^\| `(\w+)` \|", RegexOptions.Multiline)
            .Select(m => m.Groups[1].Value).Except(["surface", "compound", "halfspace"])];
        using JsonDocument scene = JsonDocument.Parse(Page.Read("docs/example.scene.json"));
        string[] shown = [.. scene.RootElement.GetProperty("objects").EnumerateArray()
            .Select(o => o.GetProperty("shape").GetProperty("type").GetString()!).Distinct()];
        Assert.Equal(types.Order(StringComparer.Ordinal), shown.Order(StringComparer.Ordinal));
    }

    [Fact]
    public void TheBestEngineIsOneOfThoseThatAreListed()
    {
        var cited = new ResultFile(Page.PathOf("bench/results/cited.csv"));
        int engines = LibraryTable.Engines(cited).Count;
        Assert.Equal(Word(engines), Found("docs/performance.md", @"the best of the (\w+) \[below\]"));
    }

    [Fact]
    public void TheAdaptersHaveSoManyLines()
    {
        int[] lines = [.. Directory.GetFiles(Page.PathOf("bench/peers"), "*.cpp")
            .Select(f => File.ReadLines(f).Count()).Order()];
        Match said = Regex.Match(Page.Read("docs/cases.md"), @"(\w+) adapters of (\d+) to (\d+) lines");
        string[] counted = [Word(lines.Length), $"{lines[0]}", $"{lines[^1]}"];
        Assert.Equal(counted, said.Groups.Values.Skip(1).Select(g => g.Value.ToLowerInvariant()));
    }

    [Fact]
    public void TheCasesAreSoMany()
    {
        int rows = Directory.GetFiles(Page.PathOf("tests/Cases"), "*.expected.csv")
            .Sum(f => File.ReadLines(f).Count() - 1);
        Assert.Equal($"{rows:#,0}", Found("docs/cases.md", @"has ([\d,]+) pairs"));
    }

    [Fact]
    public void TheBookHasSoManyChaptersAndQuestions()
    {
        string[] pages = [.. Directory.GetFiles(Page.PathOf("docs/book"), "*.md").Select(f => Path.GetFileName(f))];
        int chapters = pages.Count(p => char.IsAsciiDigit(p[0])), questions = pages.Length - chapters - 1;
        Assert.Equal(Word(chapters), Found("docs/index.md", @"in (\w+) chapters"));
        Assert.Equal(Word(questions), Found("docs/index.md", @"answers (\w+) questions"));
    }

    /// <summary>Names in the changelog exist, so that it lists nothing that has another name today.</summary>
    [Fact]
    public void TheChangelogNamesWhatThereIs()
    {
        string changes = Page.Read("CHANGELOG.md");
        HashSet<string> names = [.. typeof(ConvexQuery).Assembly.GetExportedTypes()
            .SelectMany(t => t.GetMembers().Select(m => m.Name).Append(t.Name).Append(t.Namespace!))];
        names.UnionWith(["Gjk.Import", "gjk-demo", "gjk-core", "com.gjk.core"]);
        string[] said = [.. Regex.Matches(changes, @"`([^`]+)`").Select(m => m.Groups[1].Value)];
        Assert.True(said.Length > 15, $"{said.Length} names");
        Assert.All(said, name => Assert.Contains(name, names));
        Assert.DoesNotContain("Changed", changes);
    }

    [Fact]
    public void TheChangelogListsEveryCommand()
    {
        string[] listed = Found("CHANGELOG.md", @"`gjk-demo`: ([\w\s,]+)\.")
            .Split([",", " and "], StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries);
        string[] commands = [.. Regex.Matches(Page.Read("docs/command.md"), @"^\| `(\w+)` \|", RegexOptions.Multiline)
            .Select(m => m.Groups[1].Value)];
        Assert.Equal(commands.Order(StringComparer.Ordinal), listed.Order(StringComparer.Ordinal));
        using var folder = new PageFolder([]);
        string help = folder.Run("gjk-demo --help");
        Assert.All(commands, command => Assert.Matches($@"(?m)^\s+{command}\b", help));
    }

    /// <summary>The package's README and the project's show the same three lines of Unity.</summary>
    [Fact]
    public void TheUnitySnippetIsThatOfThePackage()
    {
        CodeBlock shown = CodeBlock.Of(Page.Read("README.md")).Single(b => b.Has("unity"));
        Assert.Equal(CodeBlock.Of(Page.Read("unity/com.gjk.core/README.md")).Single().Text, shown.Text);
    }

    [Theory]
    [InlineData("README.md")]
    [InlineData("src/Gjk.Core/Package/README.md")]
    [InlineData("src/Gjk.Import/Package/README.md")]
    public void PackagesOfACandidateAreAskedForAsSuch(string page)
    {
        MatchCollection adds = Regex.Matches(Page.Read(page), @"dotnet (?:add package|tool install)[^`\n]*");
        Assert.NotEmpty(adds);
        Assert.All(adds, add => Assert.Contains("--prerelease", add.Value));
    }

    private static string Word(int number) => Words[number];

    private static string Found(string page, string pattern)
    {
        Match found = Regex.Match(Page.Read(page), pattern);
        Assert.True(found.Success, $"{page} lacks {pattern}");
        return found.Groups[1].Value;
    }
}
