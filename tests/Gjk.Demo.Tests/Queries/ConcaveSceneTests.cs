namespace Gjk.Demo.Tests.Queries;

/// <summary>Surfaces and compounds in scene files and on the command line.</summary>
public sealed class ConcaveSceneTests
{
    private const string Tetrahedron =
        """{"vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],"triangles":[[0,2,1],[0,1,3],[1,2,3],[0,3,2]]}""";

    private const string Ball = """{"shape":{"type":"sphere","radius":0.01},"position":[0.2,0.2,0.2]}""";

    [Fact]
    public void PartsAreNamed()
    {
        string[] rows = Query(
            $$"""
            {"version":1,"meshes":{"t":{{Tetrahedron}}},"objects":[
              {"shape":{"type":"surface","mesh":"t"},"scale":2},
              {"shape":{"type":"point"},"position":[0.5,0.5,-3]},
              {"shape":{"type":"compound","parts":[
                {"shape":{"type":"box","halfExtents":[1,1,1]},"position":[0,0,9]},
                {"shape":{"type":"mesh","mesh":"t"},"position":[0.25,0.25,-5],"rotation":[1,0,0,0]}]} }]}
            """,
            "--parts");
        Assert.Equal("a,b,status,overlap,distance", string.Join(',', rows[0].Split(',').Take(5)));
        Assert.EndsWith(",part_a,part_b", rows[0]);
        Assert.StartsWith("0,1,Separated,false,3,", rows[1]);
        Assert.EndsWith(",0,", rows[1]);
        Assert.StartsWith("0,2,Separated,false,5,", rows[2]);
        Assert.EndsWith(",0,1", rows[2]);
        Assert.EndsWith(",,1", rows[3]);
    }

    /// <summary>Four triangles, then a box that is placed twice.</summary>
    [Fact]
    public void CompoundsAreNested()
    {
        string[] rows = Query(
            $$"""
            {"version":1,"meshes":{"t":{{Tetrahedron}}},"objects":[
              {"shape":{"type":"compound","parts":[
                {"shape":{"type":"surface","mesh":"t"},"position":[0,0,-9]},
                {"shape":{"type":"compound","parts":[
                  {"shape":{"type":"point"},"position":[0,0,50]},
                  {"shape":{"type":"box","halfExtents":[1,1,1]},"position":[0,3,0]}]},
                 "position":[0,0,2],"rotation":[1,0,0,0]}]},"scale":2},
              {"shape":{"type":"point"},"position":[0,-12,4]},
              {"shape":{"type":"point"},"position":[0.5,0.5,-21]}],"pairs":[[0,1],[0,2]]}
            """,
            "--parts");
        Assert.StartsWith("0,1,Separated,false,4,", rows[1]);
        Assert.EndsWith(",5,", rows[1]);
        Assert.StartsWith("0,2,Separated,false,3,", rows[2]);
        Assert.EndsWith(",0,", rows[2]);
    }

    [Theory]
    [InlineData("", "false", false)]
    [InlineData(",\"solid\":true", "true", true)]
    public void ASolidHasAnInside(string solid, string overlap, bool isInside)
    {
        string scene = $$"""
            {"version":1,"meshes":{"t":{{Tetrahedron}}},"objects":[
              {"shape":{"type":"surface","mesh":"t"{{solid}} } },{{Ball}},
              {"shape":{"type":"point"},"position":[0.125,0.25,0.25]}],"pairs":[[0,1],[0,2]]}
            """;
        string[] rows = Query(scene);
        Assert.All(rows[1..], row => Assert.Equal(overlap, row.Split(',')[3]));
        Assert.Equal(isInside ? "-0.125" : "0.125", Query(scene, "--depth")[2].Split(',')[4]);
    }

    /// <summary>Also where the solid is in a compound in a compound, scaled and moved.</summary>
    [Fact]
    public void ASolidInACompoundHasAnInside()
    {
        string[] rows = Query(
            $$"""
            {"version":1,"meshes":{"t":{{Tetrahedron}}},"objects":[
              {"shape":{"type":"compound","parts":[
                {"shape":{"type":"point"},"position":[9,0,0]},
                {"shape":{"type":"compound","parts":[
                  {"shape":{"type":"surface","mesh":"t","solid":true},"position":[0,0,1]}]},
                 "position":[0,1,0]}]},"scale":2},
              {"shape":{"type":"point"},"position":[0.4,2.4,2.4]},
              {"shape":{"type":"point"},"position":[1.4,3.4,3.4]}],"pairs":[[0,1],[0,2]]}
            """,
            "--parts");
        Assert.StartsWith("0,1,Overlapping,true,0,", rows[1]);
        Assert.EndsWith(",1,", rows[1]);
        Assert.StartsWith("0,2,Separated,false,", rows[2]);
    }

    [Theory]
    [InlineData("""{"type":"surface","mesh":"open","solid":true}""", "$.objects[0].shape.solid", "edge from vertex")]
    [InlineData("""{"type":"surface","mesh":"cloud"}""", "$.objects[0].shape.mesh", "no triangles")]
    [InlineData("""{"type":"surface","mesh":"no"}""", "$.objects[0].shape.mesh", "no mesh")]
    [InlineData("""{"type":"surface","mesh":"open","solid":1}""", "$.objects[0].shape.solid", "true or false")]
    [InlineData("""{"type":"surface","mesh":"open","rounding":1}""", "$.objects[0].shape.rounding", "unknown field")]
    [InlineData("""{"type":"compound","parts":[]}""", "$.objects[0].shape.parts", "at least one")]
    [InlineData("""{"type":"compound","parts":[{}]}""", "$.objects[0].shape.parts[0].shape", "missing")]
    [InlineData(
        """{"type":"compound","parts":[{"shape":{"type":"surface","mesh":"open","solid":true}}]}""",
        "$.objects[0].shape.parts[0].shape.solid", "edge from vertex")]
    [InlineData(
        """{"type":"compound","parts":[{"shape":{"type":"compound","parts":[{"shape":{"type":"halfspace"}}]}}]}""",
        "$.objects[0].shape.parts[0].shape.parts[0].shape.normal", "missing")]
    [InlineData(
        """{"type":"compound","parts":[{"shape":{"type":"mesh","mesh":"no"}}]}""",
        "$.objects[0].shape.parts[0].shape.mesh", "no mesh")]
    public void AFaultIsNamedWithItsPlace(string shape, string path, string reason)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write(
            "s.json",
            $$"""
            {"version":1,"meshes":{"cloud":[[0,0,0]],
              "open":{"vertices":[[0,0,0],[1,0,0],[0,1,0]],"triangles":[[0,1,2]]} },
              "objects":[{"shape":{{shape}} }]}
            """);
        DemoRun.Of("query", scene).AssertRefused(path, reason);
    }

    [Theory]
    [InlineData("""[[0,1,3]]""", "$.meshes.m.triangles[0][2]")]
    [InlineData("""[[0,1]]""", "$.meshes.m.triangles[0]")]
    [InlineData("""[[0,1,2,0]]""", "$.meshes.m.triangles[0]")]
    [InlineData("""[]""", "$.meshes.m.triangles")]
    public void ATriangleNamesThreeVertices(string triangles, string path)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write(
            "s.json",
            "{\"version\":1,\"meshes\":{\"m\":{\"vertices\":[[0,0,0],[1,0,0],[0,1,0]],\"triangles\":"
                + triangles + "}},\"objects\":[]}");
        DemoRun.Of("query", scene).AssertRefused(path);
    }

    [Fact]
    public void OtherCommandsTakeConvexShapes()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write(
            "s.json",
            $$"""
            {"version":1,"meshes":{"t":{{Tetrahedron}}},"objects":[{{Ball}},{"shape":{"type":"surface","mesh":"t"} }]}
            """);
        DemoRun.Of("trace", scene, "--pair", "0,1", "--out", directory.File("s.html"))
            .AssertRefused("$.objects[1].shape", "convex");
    }

    private static string[] Query(string scene, params string[] options)
    {
        using var directory = new TempDirectory();
        DemoRun run = DemoRun.Of(["query", directory.Write("s.json", scene), .. options]);
        run.AssertDone();
        return run.Out.TrimEnd('\n').Split('\n');
    }
}
