using System.Globalization;
using System.Net;
using System.Text.RegularExpressions;
using System.Xml.Linq;

namespace Gjk.Demo.Tests.View;

/// <summary>The still picture is valid SVG, and it does not contain hidden parts.</summary>
public sealed class PictureTests
{
    private const string Front = """{"shape":{"type":"box","halfExtents":[2,2,2]},"position":[3.4,4.2,10]}""";

    private const string Behind = """{"shape":{"type":"box","halfExtents":[0.5,0.5,0.5]}}""";

    private const string Thin = """{"shape":{"type":"box","halfExtents":[0.5,3,3]}}""";

    private const string Wide =
        """{"name":"wide","shape":{"type":"box","halfExtents":[3,5,5]},"position":[2,0,0]}""";

    private const string Ground = "#12161d", Outline = "#0a0d12", White = "#fff";

    private const string Arrow = "#7cc4ff", Contact = "#f0a6ff";

    [Theory]
    [InlineData("cubes")]
    [InlineData("spheres")]
    public void ThePicturesInTheReadmeAreWhatTheDemoDraws(string scene)
    {
        using var directory = new TempDirectory();
        DemoRun.Of("view", "--builtin", scene, "--svg", directory.File("a.svg")).AssertDone();
        string drawn = File.ReadAllText(directory.File("a.svg"));
        AssertSound(drawn);
        Assert.InRange(drawn.Length, 5_000, 300_000);
        Assert.Contains($"<title>{scene}: 20 objects, 190 pairs, 5 intersecting</title>", drawn);
        Assert.Equal(File.ReadAllText(Repository.File($"docs/{scene}.svg")), drawn);
    }

    [Fact]
    public void IntersectingIsRedAndTheRestGreen()
    {
        string hit = Draw(
            """{"shape":{"type":"sphere","radius":1}},{"shape":{"type":"sphere","radius":1},"position":[1,0,0]}""");
        Assert.All(FaceColors(hit), c => Assert.True(IsRed(c), c));
        Assert.DoesNotContain($"stroke=\"{White}\"", hit);

        string free = Draw(
            """{"shape":{"type":"sphere","radius":1}},{"shape":{"type":"sphere","radius":1},"position":[3,0,0]}""");
        Assert.All(FaceColors(free), c => Assert.False(IsRed(c), c));
        Assert.Contains($"stroke=\"{White}\"", free);
    }

    /// <summary>Colour is not all that tells what intersects. The stripes are clipped by exactly the red
    /// faces.</summary>
    [Fact]
    public void IntersectingIsStriped()
    {
        string mixed = Draw(
            """
            {"shape":{"type":"box","halfExtents":[1,1,1]}},
            {"shape":{"type":"box","halfExtents":[1,1,1]},"position":[1,0.5,0]},
            {"shape":{"type":"box","halfExtents":[1,1,1]},"position":[5,0,0]}
            """);
        Assert.Contains("fill=\"url(#hatch)\" clip-path=\"url(#hit)\"", mixed);
        string[] used = [.. Regex.Matches(mixed, "<use href=\"#(hit\\d+)\"/>").Select(m => m.Groups[1].Value)];
        string[] red = [.. Regex.Matches(mixed, "<path fill=\"(#[0-9a-f]{6})\"[^>]* id=\"(hit\\d+)\"")
            .Where(m => IsRed(m.Groups[1].Value)).Select(m => m.Groups[2].Value)];
        Assert.Equal(used, red);
        Assert.Equal(FaceColors(mixed).Count(IsRed), used.Length);
        Assert.Contains(FaceColors(mixed), color => !IsRed(color));

        string free = Draw("""{"shape":{"type":"sphere","radius":1}}""");
        Assert.DoesNotContain("hatch", free);
        Assert.Contains("<title>scene: 1 object, 0 pairs, 0 intersecting</title>", free);
    }

    [Fact]
    public void WhatHasNoSurfaceIsMarkedToo()
    {
        const string Segment = """{"shape":{"type":"segment","a":[-2,0,0],"b":[2,0,0]}}""";
        const string Point = """{"shape":{"type":"point"}}""";
        string hit = Draw($"{Segment},{Point}");
        Assert.Matches("<path[^>]* stroke-dasharray=", hit);
        Assert.Matches("<circle[^>]* stroke=\"#fff\"", hit);
        string free = Draw($"{Segment},{Point.Replace("}}", "},\"position\":[0,1,0]}")}");
        Assert.DoesNotContain("dasharray", free);
        Assert.DoesNotMatch("<circle[^>]* stroke=", free);
    }

    [Fact]
    public void AnEmptySceneSaysSo()
    {
        Assert.Contains(">This scene has no objects.</text>", Draw(""));
    }

    /// <summary>The arrow of the way out is as long in the picture as the box is there that it leads through. Touching
    /// draws none.</summary>
    [Fact]
    public void AnIntersectingPairHasAnArrowAsLongAsItIsDeep()
    {
        string hit = Draw($"{Thin},{Wide}");
        Assert.Contains("<title>#0 – wide: depth 1.5</title>", WebUtility.HtmlDecode(hit));
        Match path = Regex.Match(hit, $"<path stroke=\"{Arrow}\"[^>]* d=\"M([\\d.]+) ([\\d.]+)l([^m]*)m([^z]*)z\"");
        Assert.True(path.Success, hit);

        // From where the shaft begins, along it and on to the tip, which is where the head begins.
        double[] steps = [.. Numbers(path.Groups[3].Value), .. Numbers(path.Groups[4].Value)];
        (double x, double y) = (steps[0] + steps[2], steps[1] + steps[3]);

        // The bodies end at x = -1 and 5; the arrow is a quarter of that long, in the middle and seen aslant.
        double width = Polygons(hit).SelectMany(p => p).Max(p => p.X) - Polygons(hit).SelectMany(p => p).Min(p => p.X);
        Assert.InRange(x, 0.1 * width, 0.2 * width);
        Assert.InRange(Math.Abs(y), 0, 0.2 * x);

        string touching = Draw($"{Thin},{Wide.Replace("[2,0,0]", "[3.5,0,0]")}");
        Assert.All(FaceColors(touching), c => Assert.True(IsRed(c), c));
        Assert.DoesNotContain(Arrow, touching);
        Assert.DoesNotContain("depth", touching);
    }

    /// <summary>The dots are the corners of the thin box's face, and the words say how far B's face is from
    /// them.</summary>
    [Theory]
    [InlineData("[2,0,0]", 4, "4 contact points, gap -1.5")]
    [InlineData("[3.5,0,0]", 4, "4 contact points, gap 0")]
    [InlineData("[2,0,0],\"rotation\":[0,0,0.0017453,0.9999985]", 4, "4 contact points, gaps -1.51")]
    [InlineData("[3.51,0,0]", 0, null)]
    public void AnIntersectingPairHasItsContactPoints(string position, int dots, string? words)
    {
        string svg = Draw($"{Thin},{Wide.Replace("[2,0,0]", position)}");
        MatchCollection found = Regex.Matches(svg, "<circle cx=\"([\\d.]+)\" cy=\"([\\d.]+)\" r=");
        Assert.Equal(dots, found.Count);
        Assert.Equal(dots > 0, svg.Contains(Contact));
        if (words is null) return;
        Assert.Contains($"<title>#0 – wide: {words}", WebUtility.HtmlDecode(svg));

        // A quarter of the picture's breadth at least is between the left and the right ones.
        double[] x = [.. found.Select(m => double.Parse(m.Groups[1].Value, CultureInfo.InvariantCulture))];
        Assert.InRange(x.Max() - x.Min(), 100, 700);
    }

    [Fact]
    public void WhatIsHiddenIsNotDrawn()
    {
        string alone = Draw(Front);
        string pair = Draw($"{Front},{Behind}");
        string beside = Draw($"{Front},{Behind.Replace("}}", "},\"position\":[12,0,0]}")}");
        Assert.Equal(3, Polygons(alone).Count);
        Assert.Equal(3, Polygons(pair).Count);
        Assert.Equal(6, Polygons(beside).Count);
        Assert.DoesNotContain($"stroke=\"{White}\"", pair);
        Assert.Contains($"stroke=\"{White}\"", beside);
    }

    [Fact]
    public void OverlappingFacesDoNotOverlapInThePicture()
    {
        // Three boxes through each other. The visible parts tile the outline of the union. So their areas add up to the
        // area of the union of the silhouettes.
        const string Cross = """
            {"shape":{"type":"box","halfExtents":[3,0.6,0.6]}},
            {"shape":{"type":"box","halfExtents":[0.6,3,0.6]}},
            {"shape":{"type":"box","halfExtents":[0.6,0.6,3]}}
            """;
        List<List<(double X, double Y)>> polygons = Polygons(Draw(Cross));
        var random = new Rng(3);
        int covered = 0, twice = 0;
        for (int i = 0; i < 20_000; i++)
        {
            (double x, double y) = (random.Unit() * 960, random.Unit() * 700);
            int count = polygons.Count(p => Contains(p, x, y));
            if (count > 0) covered++;
            if (count > 1) twice++;
        }

        Assert.InRange(covered, 2_000, 15_000);
        Assert.True(twice <= covered / 500, $"{twice} of {covered} points are covered twice");
    }

    /// <summary>Asserts that the SVG is well-formed, that every number is finite, that every path lies inside the
    /// picture, and that the picture has its own background.</summary>
    internal static void AssertSound(string svg)
    {
        XElement root = XDocument.Parse(svg).Root!;
        XNamespace ns = "http://www.w3.org/2000/svg";
        Assert.Equal(ns + "svg", root.Name);
        string[] viewBox = root.Attribute("viewBox")!.Value.Split(' ');
        double[] box = [.. viewBox.Select(n => double.Parse(n, CultureInfo.InvariantCulture))];
        Assert.Equal([0, 0, 960], box[..3]);
        Assert.InRange(box[3], 400, 801);
        Assert.Equal(Ground, root.Element(ns + "rect")!.Attribute("fill")!.Value);
        Assert.DoesNotContain("NaN", svg);
        Assert.DoesNotContain("∞", svg);
        foreach ((double x, double y) in Polygons(svg).SelectMany(p => p))
        {
            Assert.InRange(x, -0.5, 960.5);
            Assert.InRange(y, -0.5, box[3] + 0.5);
        }
    }

    private static string Draw(string objects)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", $"{{\"version\":1,\"objects\":[{objects}]}}");
        DemoRun.Of("view", scene, "--svg", directory.File("a.svg")).AssertDone();
        string svg = File.ReadAllText(directory.File("a.svg"));
        AssertSound(svg);
        return svg;
    }

    private static IEnumerable<string> FaceColors(string svg)
    {
        IEnumerable<string> fills = Regex.Matches(svg, "fill=\"(#[0-9a-f]{6})\"").Select(m => m.Groups[1].Value);
        string[] colors = [.. fills.Where(c => c is not (Ground or Outline or Arrow or Contact))];
        Assert.NotEmpty(colors);
        return colors;
    }

    private static bool IsRed(string color) => Convert.ToInt32(color[1..3], 16) > Convert.ToInt32(color[3..5], 16);

    private static bool Contains(List<(double X, double Y)> p, double x, double y)
    {
        bool inside = false;
        for (int i = 0, j = p.Count - 1; i < p.Count; j = i++)
        {
            if (p[i].Y > y != p[j].Y > y && x < (p[j].X - p[i].X) * (y - p[i].Y) / (p[j].Y - p[i].Y) + p[i].X)
                inside = !inside;
        }

        return inside;
    }

    /// <summary>The filled outlines, read as an SVG reader would.</summary>
    private static List<List<(double X, double Y)>> Polygons(string svg)
    {
        var result = new List<List<(double X, double Y)>>();
        foreach (Match path in Regex.Matches(svg, "<path fill=\"#[^>]* d=\"([^\"]*)\""))
        {
            double x = 0, y = 0;
            foreach (string subpath in path.Groups[1].Value.Split('z', StringSplitOptions.RemoveEmptyEntries))
            {
                double[] steps = Numbers(subpath);
                var polygon = new List<(double X, double Y)>();
                for (int i = 0; i < steps.Length; i += 2)
                {
                    x += steps[i];
                    y += steps[i + 1];
                    polygon.Add((x, y));
                }

                (x, y) = polygon[0];
                result.Add(polygon);
            }
        }

        return result;
    }

    private static double[] Numbers(string path)
    {
        MatchCollection numbers = Regex.Matches(path, "-?(\\d+(\\.\\d+)?|\\.\\d+)");
        return [.. numbers.Select(m => double.Parse(m.Value, CultureInfo.InvariantCulture))];
    }
}
