using System.Runtime.InteropServices;
using System.Text.Json;
using System.Text.RegularExpressions;

namespace Gjk.Demo.Tests.View;

/// <summary>Surfaces and compounds on the page and in the picture of <c>view</c>.</summary>
public sealed class ConcaveViewTests
{
    /// <summary>A folded sheet, a compound above its second triangle, a point inside a solid, and two balls.</summary>
    private const string Scene = """
        {"version":1,"meshes":{
          "fold":{"vertices":[[0,0,0],[2,0,0],[0,2,0],[2,2,1]],"triangles":[[0,1,2],[1,3,2]]},
          "t":{"vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],"triangles":[[0,2,1],[0,1,3],[1,2,3],[0,3,2]]}},
        "objects":[
          {"shape":{"type":"surface","mesh":"fold"},"scale":[1,1,2]},
          {"shape":{"type":"compound","parts":[
            {"shape":{"type":"box","halfExtents":[1,1,1]},"position":[0,0,20]},
            {"shape":{"type":"segment","a":[0,0,0],"b":[0,0,1]},"position":[2,2,4]}]}},
          {"shape":{"type":"surface","mesh":"t","solid":true},"position":[50,0,0]},
          {"shape":{"type":"point"},"position":[50.125,0.25,0.25]},
          {"shape":{"type":"surface","mesh":"t"},"position":[50.5,0,0]}],
        "pairs":[[0,1],[2,3],[2,4],[1,3]]}
        """;

    [Fact]
    public void ThePageHasTheTrianglesAndTheNearestParts()
    {
        using var directory = new TempDirectory();
        string page = directory.File("c.html");
        string scene = directory.Write("c.json", Scene);
        DemoRun.Of("view", scene, "--out", page).AssertDone();
        var text = new PageText(page);
        JsonElement[] shapes = [.. text.Data.GetProperty("shapes").EnumerateArray()];

        JsonElement fold = shapes[0];
        Assert.Equal(2, fold.GetProperty("dimension").GetInt32());
        Assert.Equal([0, 1, 2, 1, 3, 2], Column<int>(fold, "triangles"));
        Assert.Equal([0, 1, 2], Column<int>(fold, "partStarts"));
        Assert.Equal(10, Column<int>(fold, "edges").Length);
        Assert.Equal(2, Column<float>(fold, "vertices")[^1]);

        JsonElement compound = shapes[1];
        Assert.Equal([0, 12, 12], Column<int>(compound, "partStarts"));
        Assert.Equal(10, Column<float>(compound, "vertices").Length / 3);
        Assert.Equal(26, Column<int>(compound, "edges").Length);

        Assert.False(shapes[3].TryGetProperty("partStarts", out _));
        int[] partA = text.Column<int>("partA");
        Assert.Equal([1, 3, 1], [partA[0], partA[1], partA[3]]);
        Assert.Equal([1, -1, -1], text.Column<int>("partB").Where((_, pair) => pair != 2));
        float[] distances = text.Column<float>("distance");
        Assert.Equal([-0.125f, 0], distances[1..3]);
        Assert.Equal([0, 1, 1, 0], text.Column<byte>("status"));
        Assert.Equal([2], text.Column<int>("overlapping"));
    }

    /// <summary>The answers on the page are those of <c>query</c>.</summary>
    [Fact]
    public void ThePageSaysWhatQuerySays()
    {
        using var directory = new TempDirectory();
        string page = directory.File("c.html");
        string scene = directory.Write("c.json", Scene);
        DemoRun.Of("view", scene, "--out", page).AssertDone();
        DemoRun query = DemoRun.Of("query", scene, "--depth", "--parts");
        query.AssertDone();
        var text = new PageText(page);
        int[] partA = text.Column<int>("partA"), partB = text.Column<int>("partB");
        string[][] rows = [.. query.Out.TrimEnd('\n').Split('\n').Skip(1).Select(row => row.Split(','))];
        Assert.Equal(rows.Select(row => row[^2]), partA.Select(Cell));
        Assert.Equal(rows.Select(row => row[^1]), partB.Select(Cell));
        Assert.Equal(rows.Select(row => float.Parse(row[4])), text.Column<float>("distance"));
    }

    [Fact]
    public void ASceneOfConvexShapesHasNoParts()
    {
        using var directory = new TempDirectory();
        string page = directory.File("c.html");
        DemoRun.Of("view", "--builtin", "cubes", "--out", page).AssertDone();
        Assert.False(new PageText(page).Data.TryGetProperty("partA", out _));
    }

    [Fact]
    public void ALivePageTakesConvexShapes()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("c.json", Scene), page = directory.File("c.html");
        DemoRun.Of("view", scene, "--out", page, "--live")
            .AssertRefused("$.objects[0].shape", "--live", "not a surface");
        Assert.False(File.Exists(page));
    }

    /// <summary>Of a sheet of two triangles the one that a point is nearest to is yellow, and only that.</summary>
    [Fact]
    public void APictureLightsTheNearestTriangle()
    {
        (string[] Green, string[] Yellow) first = Faces(Sheet(pair: 1)), second = Faces(Sheet(pair: 2));
        Assert.Single(first.Green);
        Assert.Single(first.Yellow);
        Assert.NotEqual(first.Green, first.Yellow);
        Assert.Equal(first.Green, second.Yellow);
        Assert.Equal(first.Yellow, second.Green);
    }

    [Fact]
    public void APictureOfCompoundsAndSolidsIsSound()
    {
        string svg = Picture(Scene);
        PictureTests.AssertSound(svg);
        Assert.Contains("is yellow", svg);
        Assert.Contains("class=\"hatch\"", svg);
    }

    [Fact]
    public void APictureOfTooManyTrianglesIsRefused()
    {
        using var directory = new TempDirectory();
        string triangles = string.Join(",", Enumerable.Repeat("[0,1,2]", 20_001));
        string scene = directory.Write(
            "c.json",
            $$"""
            {"version":1,"meshes":{"m":{"vertices":[[0,0,0],[1,0,0],[0,1,0]],"triangles":[{{triangles}}]} },
            "objects":[{"shape":{"type":"surface","mesh":"m"} }]}
            """);
        DemoRun.Of("view", scene, "--svg", directory.File("c.svg"))
            .AssertRefused("c.json", "--svg", "20001 triangles", "20000");
        Assert.False(File.Exists(directory.File("c.svg")));
    }

    /// <summary>The folded sheet with a point over each of its triangles, one of which is asked about.</summary>
    private static string Sheet(int pair) =>
        $$"""
        {"version":1,
        "meshes":{"fold":{"vertices":[[0,0,0],[2,0,0],[0,2,0],[2,2,1]],"triangles":[[0,1,2],[1,3,2]]} },
        "objects":[{"shape":{"type":"surface","mesh":"fold"} },
          {"shape":{"type":"point"},"position":[0.5,0.5,1]},{"shape":{"type":"point"},"position":[1.5,1.5,3]}],
        "pairs":[[0,{{pair}}]]}
        """;

    private static string Picture(string scene)
    {
        using var directory = new TempDirectory();
        string picture = directory.File("c.svg");
        DemoRun.Of("view", directory.Write("c.json", scene), "--svg", picture).AssertDone();
        return File.ReadAllText(picture);
    }

    /// <summary>The outlines of the faces of a picture, by their colour.</summary>
    private static (string[] Green, string[] Yellow) Faces(string scene)
    {
        var found = Regex.Matches(Picture(scene), "<path fill=\"#(..)(..)(..)\" [^>]* d=\"([^\"]*)\"")
            .Select(m => (IsYellow: string.CompareOrdinal(m.Groups[1].Value, m.Groups[3].Value) > 0, m.Groups[4].Value))
            .ToList();
        return (
            [.. found.Where(face => !face.IsYellow).Select(face => face.Value)],
            [.. found.Where(face => face.IsYellow).Select(face => face.Value)]);
    }

    private static string Cell(int part) => part < 0 ? "" : part.ToString();

    private static T[] Column<T>(JsonElement shape, string name)
        where T : unmanaged =>
        MemoryMarshal.Cast<byte, T>(shape.GetProperty(name).GetBytesFromBase64()).ToArray();
}
