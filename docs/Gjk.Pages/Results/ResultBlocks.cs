using System.IO;
using System.Text.RegularExpressions;

namespace Gjk.Pages;

/// <summary>Fills in what pages show of bench/results: the lines between <c>&lt;!-- results: name --&gt;</c> and
/// <c>&lt;!-- end of results --&gt;</c>.</summary>
internal static partial class ResultBlocks
{
    private const string End = "<!-- end of results -->";

    /// <summary>The pages that have such lines.</summary>
    public static readonly string[] Pages = ["README.md", "docs/performance.md", "docs/cases.md"];

    /// <summary>The page with its blocks made anew.</summary>
    /// <param name="page">The page's text.</param>
    /// <param name="blocks">What to put into each block, by its name.</param>
    /// <exception cref="ArgumentException">A block has no end, or a name that is not known.</exception>
    public static string Fill(string page, IReadOnlyDictionary<string, string> blocks) => Block().Replace(page, found =>
    {
        string name = found.Groups["name"].Value;
        if (!blocks.TryGetValue(name, out string? text))
            throw new ArgumentException($"There are no results of the name '{name}'.", nameof(page));
        return $"<!-- results: {name} -->\n{text.TrimEnd('\n')}\n{End}";
    });

    public static IEnumerable<string> NamesIn(string page) => Block().Matches(page).Select(m => m.Groups["name"].Value);

    /// <summary>The page without what is made from results.</summary>
    public static string Without(string page) => Block().Replace(page, "");

    /// <summary>Every block, made from the files in bench/results.</summary>
    /// <param name="folder">The project's folder.</param>
    public static IReadOnlyDictionary<string, string> Make(string folder)
    {
        string results = Path.Combine(folder, "bench", "results");
        ResultFile peers = Only(results, "-peers.csv"), scale = Only(results, "-scale.csv"),
            judge = Only(results, "-judge.csv"), mono = Only(results, "-mono.csv"),
            cited = new(Path.Combine(results, "cited.csv"));
        ResultFile table = new(peers.Path.Replace("-peers.csv", ".csv"));
        return new Dictionary<string, string>
        {
            ["machine"] = MachineText.Of(table, peers, scale),
            ["library"] = LibraryTable.Make(table, cited),
            ["primitives"] = LibraryTable.Primitives(table),
            ["cited cold"] = LibraryTable.Cited(cited, "cold"),
            ["cited warm"] = LibraryTable.Cited(cited, "warm"),
            ["cited boolean"] = LibraryTable.Cited(cited, "boolean"),
            ["peers"] = PeerTables.Ratios(peers),
            ["surfaces"] = PeerTables.Surfaces(peers),
            ["scenes"] = SceneTable.Make(scale),
            ["runtimes"] = RuntimeTable.Make(mono),
            ["runtimes in short"] = RuntimeTable.Short(mono),
            ["judge"] = JudgeTable.Make(judge),
            ["engines"] = JudgeTable.Summary(judge, peers),
        };
    }

    /// <summary>The charts of the same files.</summary>
    /// <param name="folder">The project's folder.</param>
    public static IEnumerable<Figure> Charts(string folder)
    {
        ResultFile scale = Only(Path.Combine(folder, "bench", "results"), "-scale.csv");
        return ResultCharts.Draw(new(scale.Path.Replace("-scale.csv", ".csv")), scale);
    }

    /// <summary>Of two machines a page would have to choose, so only one is kept.</summary>
    private static ResultFile Only(string folder, string ending) =>
        Directory.GetFiles(folder, "*" + ending) is [var file]
            ? new ResultFile(file)
            : throw new ArgumentException($"{folder} needs one file that ends in {ending}.", nameof(folder));

    [GeneratedRegex(@"<!-- results: (?<name>[\w ]+) -->\n(?s:.*?)<!-- end of results -->")]
    private static partial Regex Block();
}
