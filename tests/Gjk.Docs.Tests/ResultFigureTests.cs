using System.Globalization;
using System.Text.RegularExpressions;

namespace Gjk.Docs.Tests;

/// <summary>The figures that pages show are those in bench/results, rounded as they are shown: whoever measures anew
/// rewrites the pages, or these tests fail.</summary>
public class ResultFigureTests
{
    private const string Performance = "docs/performance.md";

    private static readonly string[] Sets =
        ["cubes", "spheres", "box", "hull8", "hull32", "hull128", "hull512", "hull2048"];

    private static readonly string[] Engines = ["gjk", "bullet", "libccd", "fcl", "ode"];

    [Theory]
    [InlineData("**Gjk**, cold", "cold", "library_ns")]
    [InlineData("**Gjk**, warm, nothing moved", "warm", "library_ns")]
    [InlineData("**Gjk**, warm, moving", "moving", "library_ns")]
    [InlineData("**Gjk**, boolean", "boolean", "library_ns")]
    [InlineData("**Gjk**, batch, cold", "batchcold", "library_ns")]
    [InlineData("**Gjk**, batch, warm, nothing moved", "batchwarm", "library_ns")]
    [InlineData("**Gjk**, batch, boolean", "batchboolean", "library_ns")]
    [InlineData("the report's algorithm", "cold", "baseline_ns")]
    [InlineData("the report's algorithm, boolean", "boolean", "baseline_ns")]
    public void TheTableOfTheLibrary(string row, string query, string column)
    {
        string[] cells = Row(Performance, row);
        for (int i = 0; i < Sets.Length; i++)
            AssertShows(cells[i + 1], Value("amd-epyc.csv", column, ("set", Sets[i]), ("query", query)));
    }

    [Fact]
    public void TheTableOfThePeers()
    {
        string[] questions = ["distance", "boolean", "depth"];
        string[][] rows = [.. Rows(Performance).Where(r => r.Length == 8 && questions.Contains(r[1]))];
        Assert.True(rows.Length > 25, $"{rows.Length} rows");
        foreach (string[] row in rows)
        {
            double[] times = [.. Engines.Select(e => Peer(row[0], row[1], e, "ns"))];
            for (int i = 0; i < Engines.Length; i++) AssertPeer(row[i + 2], row[0], row[1], Engines[i]);
            AssertShows(row[7], times[0] / times[1..].Where(t => !double.IsNaN(t)).Min());
        }
    }

    [Fact]
    public void TheTableOfSurfaces()
    {
        string[][] rows = [.. Rows(Performance).Where(r => r.Length == 7 && r[0].Contains("100k"))];
        Assert.Equal(13, rows.Length);
        foreach (string[] row in rows)
        {
            string[] questions = ["distance", "boolean"];
            for (int i = 0; i < questions.Length; i++)
            {
                double library = Peer(row[0], questions[i], "gjk", "ns") / 1000;
                double other = Peer(row[0], questions[i], "fcl", "ns") / 1000;
                AssertShows(row[3 * i + 1], library);
                AssertShows(row[3 * i + 2], other);
                AssertShows(row[3 * i + 3], library / other);
            }
        }
    }

    [Fact]
    public void TheTableOfTheReadme()
    {
        string[] sets = ["cubes", "spheres", "box", "hull32", "hull512", "hull2048"];
        for (int i = 0; i < sets.Length; i++)
        {
            string set = sets[i];
            AssertPeer(Row("README.md", "**Gjk**, distance, cold")[i + 1], set, "distance", "gjk");
            AssertPeer(Row("README.md", "Bullet 3.24, distance")[i + 1], set, "distance", "bullet");
            AssertPeer(Row("README.md", "FCL 0.7, distance")[i + 1], set, "distance", "fcl");
            AssertPeer(Row("README.md", "**Gjk**, boolean")[i + 1], set, "boolean", "gjk");
            AssertPeer(Row("README.md", "libccd 2.1, boolean")[i + 1], set, "boolean", "libccd");
            AssertShows(
                Row("README.md", "**Gjk**, warm, nothing moved")[i + 1],
                Value("amd-epyc.csv", "library_ns", ("set", set), ("query", "warm")));
            AssertShows(
                Row("README.md", "the report's algorithm, distance")[i + 1],
                Value("amd-epyc.csv", "baseline_ns", ("set", set), ("query", "cold")));
        }
    }

    [Theory]
    [InlineData("docs/cases.md")]
    [InlineData("README.md")]
    public void TheTableOfTheReferee(string page)
    {
        string[] names = ["FCL 0.7", "Bullet 3.24", "libccd 2.1", "ODE 0.16", "**Gjk**"];
        string[] engines = ["fcl", "bullet", "libccd", "ode", "gjk"];
        string[] columns = ["pairs", "wrong", "wrong_1e-5"];
        for (int e = 0; e < names.Length; e++)
        {
            string[] cells = Row(page, names[e]);
            for (int i = 0; i < 6; i++)
            {
                double value = Value(
                    "amd-epyc-judge.csv", columns[i % 3], ("engine", engines[e]),
                    ("question", i < 3 ? "distance" : "depth"));
                if (double.IsNaN(value)) Assert.Equal("", cells[i + 1]);
                else AssertShows(cells[i + 1], value);
            }
        }
    }

    [Theory]
    [InlineData("20")]
    [InlineData("200")]
    [InlineData("2,000")]
    [InlineData("20,000")]
    [InlineData("100,000")]
    public void TheTableOfScenes(string objects)
    {
        string[] cells = Row(Performance, objects);
        string count = objects.Replace(",", "");
        double Of(string column, string broad, string threads) => Value(
            "amd-epyc-scale.csv", column, ("scene", "room"), ("question", "overlaps"), ("objects", count),
            ("motion", "moving"), ("broad_phase", broad), ("threads", threads));
        AssertShows(cells[3], Of("broad_ms", "sort-and-sweep", "1"));
        AssertShows(cells[4], Of("broad_ms", "dynamic-tree", "1"));
        AssertShows(cells[5], Of("narrow_ms", "dynamic-tree", "1"));
        AssertShows(cells[6], Of("frame_ms", "dynamic-tree", "1"));
        AssertShows(cells[7], Of("frame_ms", "dynamic-tree", "2"));
    }

    /// <summary>Sentences, each with a number in it that the results have.</summary>
    [Theory]
    [InlineData(Performance, @"spheres ([\d.]+), capsules", "sphere-sphere", 1)]
    [InlineData(Performance, @"capsules ([\d.]+), boxes", "capsule-capsule", 1)]
    [InlineData(Performance, @"equal sides ([\d.]+), boxes", "box-box cubes", 1)]
    [InlineData(Performance, @"sides \d+, boxes ([\d.]+), tri", "box-box random", 1)]
    [InlineData(Performance, @"triangles ([\d.]+)\.\n", "triangle-triangle", 1)]
    [InlineData("docs/book/concave.md", @"query 0.2 to ([\d.]+) microseconds", "hull2048", 1e-3)]
    public void TheFiguresOfSentences(string page, string pattern, string set, double unit)
    {
        Match found = Regex.Match(Page.Read(page), pattern);
        Assert.True(found.Success, pattern);
        double value = Value("amd-epyc.csv", "library_ns", ("set", set), ("query", "cold"));
        AssertShows(found.Groups[1].Value, value * unit);
    }

    [Fact]
    public void WhatAWarmStartSavesOfMovingPairs()
    {
        double[] factors = [.. Sets.Select(set => Cold(set, "cold") / Cold(set, "moving"))];
        foreach (string page in new[] { "README.md", "src/Gjk.Core/Package/README.md" })
        {
            Match found = Regex.Match(Page.Read(page), @"([\d.]+) to\s+([\d.]+)\s+times\s+faster");
            Assert.True(found.Success, page);
            AssertShows(found.Groups[1].Value, factors.Min());
            AssertShows(found.Groups[2].Value, factors.Max());
        }

        static double Cold(string set, string query) =>
            Value("amd-epyc.csv", "library_ns", ("set", set), ("query", query));
    }

    [Fact]
    public void TheSentenceOfLargeScenes()
    {
        Match found = Regex.Match(
            Page.Read("docs/tasks/large-scene.md"),
            @"cost (\S+) ms a frame\s+for 20,000 objects and (\S+) ms for 100,000");
        Assert.True(found.Success);
        string[] counts = ["20000", "100000"];
        for (int i = 0; i < counts.Length; i++)
        {
            AssertShows(found.Groups[i + 1].Value, Value(
                "amd-epyc-scale.csv", "frame_ms", ("scene", "room"), ("question", "overlaps"), ("objects", counts[i]),
                ("motion", "moving"), ("broad_phase", "dynamic-tree"), ("threads", "1")));
        }
    }

    [Fact]
    public void DepthsOfHullsBesideTheFastestEngine()
    {
        string[] hulls = ["hull8", "hull32", "hull128", "hull512"];
        double[] ratios = [.. hulls.Select(set => Peer(set, "depth", "gjk", "ns")
            / Engines.Skip(1).Select(e => Peer(set, "depth", e, "ns")).Where(t => !double.IsNaN(t)).Min())];
        Match found = Regex.Match(Page.Read("README.md"), @"Depths of hulls take ([\d.]+) to ([\d.]+) of");
        AssertShows(found.Groups[1].Value, ratios.Min());
        AssertShows(found.Groups[2].Value, ratios.Max());
    }

    /// <summary>"Three times", "six times": what the two tables say of 64 times the corners.</summary>
    [Fact]
    public void WhatMoreCornersCost()
    {
        double peers = Peer("hull2048", "distance", "gjk", "ns") / Peer("hull32", "distance", "gjk", "ns");
        double table = Value("amd-epyc.csv", "library_ns", ("set", "hull2048"), ("query", "cold"))
            / Value("amd-epyc.csv", "library_ns", ("set", "hull32"), ("query", "cold"));
        AssertShows("3", peers);
        AssertShows("6", table);
        Assert.Contains("2,048 corners cost three times as much as 32", Page.Read("README.md"));
        Assert.Contains("cost three to six times as much", Page.Read("docs/book/concave.md").Replace("\n  ", " "));
    }

    private static void AssertPeer(string cell, string set, string question, string engine)
    {
        double ns = Peer(set, question, engine, "ns"), wrong = Peer(set, question, engine, "wrong");
        if (double.IsNaN(ns))
        {
            Assert.Equal("-", cell);
            return;
        }

        string[] parts = cell.Split(' ');
        AssertShows(parts[0], ns);
        Assert.Equal(wrong, parts.Length > 1 ? Number(parts[1].Trim('(', ')')) : 0);
    }

    private static double Peer(string set, string question, string engine, string column) => Value(
        "amd-epyc-peers.csv", column, ("set", set), ("question", question), ("engine", engine));

    /// <summary>The number is the value, rounded to as many digits as it has.</summary>
    private static void AssertShows(string cell, double value)
    {
        string text = cell.Trim('*', ' ').Replace(",", "");
        int dot = text.IndexOf('.'), decimals = dot < 0 ? 0 : text.Length - dot - 1;
        double half = 0.5000001 * Math.Pow(10, -decimals);
        Assert.True(Math.Abs(Number(text) - value) <= half, $"{cell} is shown, the results have {value}");
    }

    private static double Value(string file, string column, params (string Column, string Is)[] where)
    {
        string[][] lines = [.. File.ReadLines(Page.PathOf("bench/results/" + file))
            .Where(l => !l.StartsWith('#')).Select(l => l.Split(','))];
        int Index(string name) => Array.IndexOf(lines[0], name);
        string[]? line = lines.FirstOrDefault(l => where.All(w => l[Index(w.Column)] == w.Is));
        return line is null ? double.NaN : Number(line[Index(column)]);
    }

    private static string[] Row(string page, string first)
    {
        string[]? row = Rows(page).FirstOrDefault(r => r[0] == first);
        Assert.True(row is not null, $"{page} has no row '{first}'");
        return row!;
    }

    private static IEnumerable<string[]> Rows(string page) => Page.Read(page).Split('\n')
        .Where(l => l.StartsWith('|')).Select(l => l.Trim('|', ' ').Split('|').Select(c => c.Trim()).ToArray());

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
