using System.Text.RegularExpressions;
using Gjk.Core.Tests.Support;
using Gjk.Pages;

namespace Gjk.Docs.Tests;

/// <summary>The figures of speed and of wrong answers that pages show are those in bench/results, and each is at one
/// place. <c>bench/renew.sh --pages</c> writes them.</summary>
public partial class ResultFigureTests
{
    /// <summary>Pages that say how long something takes, which is not a figure of performance.md.</summary>
    private static readonly Dictionary<string, string> OtherTimes = new()
    {
        ["docs/exactness.md"] = "a pair of fuzz",
        ["docs/tasks/many-machines.md"] = "a part of a scene with its start",
        ["samples/EnterExit/README.md"] = "what the sample prints",
        ["samples/NearestObstacle/README.md"] = "what the sample prints",
        ["src/Gjk.Web/npm/README.md"] = "a query on WebAssembly",
    };

    public static TheoryData<string> PagesWithResults => [.. ResultBlocks.Pages];

    public static TheoryData<string> Texts => [.. Page.Names().Concat(
    [
        "CHANGELOG.md", "src/Gjk.Core/Package/README.md", "src/Gjk.Import/Package/README.md",
        "src/Gjk.Web/npm/README.md", "unity/com.gjk.core/README.md", "unity/com.gjk.core/CHANGELOG.md",
        "unity/com.gjk.core/Documentation~/index.md",
    ]).Where(p => p != "docs/performance.md" && !p.StartsWith("docs/api/", StringComparison.Ordinal))];

    [Theory, MemberData(nameof(PagesWithResults))]
    public void TablesAreMadeFromTheResults(string page)
    {
        string text = Page.Read(page);
        Assert.NotEmpty(ResultBlocks.NamesIn(text));
        Assert.Equal(ResultBlocks.Fill(text, ResultBlocks.Make(ProjectFolder.Root)), text);
    }

    /// <summary>A table that two pages show could be renewed on one of them only by hand.</summary>
    [Fact]
    public void EveryTableIsShownOnce()
    {
        string[] shown = [.. ResultBlocks.Pages.SelectMany(p => ResultBlocks.NamesIn(Page.Read(p)))];
        Assert.Equal(
            ResultBlocks.Make(ProjectFolder.Root).Keys.Order(StringComparer.Ordinal),
            shown.Order(StringComparer.Ordinal));
    }

    /// <summary>What a query costs is in docs/performance.md alone, so that no two pages can differ.</summary>
    [Theory, MemberData(nameof(Texts))]
    public void OtherPagesSayNoTimesOfQueries(string page)
    {
        string text = ResultBlocks.Without(Page.Read(page));
        if (OtherTimes.ContainsKey(page)) Assert.Matches(Time(), text);
        else Assert.DoesNotMatch(Time(), text);
    }

    [Fact]
    public void NumbersAreWrittenWithTheDigitsThatTheyHave()
    {
        double[] numbers = [1234, 12.34, 1.234, 0.1234, 0.01234, 0.001234, double.NaN];
        string[] shown = [.. numbers.Select(Shown.TwoDigits)];
        Assert.Equal(["1,234", "12", "1.2", "0.12", "0.01", "0.001", "-"], shown);
    }

    /// <summary>A new run must not leave a figure of the old one.</summary>
    [Fact]
    public void ABlockIsReplacedAsAWhole()
    {
        const string Page = "a\n<!-- results: x -->\nold\n| 1 |\n<!-- end of results -->\nb\n";
        string filled = ResultBlocks.Fill(Page, new Dictionary<string, string> { ["x"] = "new\n" });
        Assert.Equal("a\n<!-- results: x -->\nnew\n<!-- end of results -->\nb\n", filled);
        Assert.Throws<ArgumentException>(() => ResultBlocks.Fill(Page, new Dictionary<string, string>()));
    }

    [GeneratedRegex(@"\d\s+(ns|us|nanoseconds|microseconds)\b|\d\s+times\s+(faster|slower|as\s+long|as\s+much)|"
        + @"(two|three|four|five|six|ten)\s+times\s+(faster|slower|as\s+long|as\s+much)")]
    private static partial Regex Time();
}
