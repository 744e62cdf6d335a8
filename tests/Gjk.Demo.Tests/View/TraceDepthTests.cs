using System.Text.Json;

namespace Gjk.Demo.Tests.View;

/// <summary>Tests what the page of <c>trace</c> holds about an overlapping pair. Its depth is that of
/// <c>query --depth</c>, and the surfaces lead to it.</summary>
public sealed class TraceDepthTests
{
    private const string Scene = """
        {"version":1,"name":"deep","meshes":{"roof":[[0,0,0],[1,0,0],[0,1,0],[0,0,1],[1,1,0]]},"objects":[
          {"shape":{"type":"box","halfExtents":[1,1,1]},"rotation":[0.5,0.5,0.5,0.5],"position":[10,20,30]},
          {"shape":{"type":"mesh","mesh":"roof"},"position":[10.5,20.2,30.1],"rotation":[0,0,0.6,0.8],"scale":2},
          {"shape":{"type":"capsule","radius":0.5,"halfHeight":1},"position":[10,20.5,30]},
          {"shape":{"type":"sphere","radius":0.5},"position":[11.2,20,30]},
          {"shape":{"type":"box","halfExtents":[1,0.5,1]},"position":[10.2,20.4,30.3]},
          {"shape":{"type":"ellipsoid","radii":[1,0.999,0.998]},"position":[10,20,30]},
          {"shape":{"type":"cone","radius":1,"halfHeight":1},"position":[0,0,0]},
          {"shape":{"type":"triangle","a":[0,0,0],"b":[1,0,0],"c":[0,1,0]},"position":[10,20,30]},
          {"shape":{"type":"triangle","a":[0,0,0],"b":[1,0,0],"c":[0,1,0]},"position":[10.1,20.1,30]},
          {"shape":{"type":"ellipsoid","radii":[1,0.999,0.998]},"position":[10,20,30]}]}
        """;

    [Theory]
    [InlineData(0, 1, "BoundsMet")]
    [InlineData(1, 0, "BoundsMet")]
    [InlineData(0, 2, "BoundsMet")]
    [InlineData(0, 4, "BoundsMet")]
    [InlineData(1, 5, "BoundsMet")]
    [InlineData(5, 9, "OutOfRoom")]
    [InlineData(7, 8, "Flat")]
    [InlineData(0, 3, null)]
    public void TheDepthIsThatOfQueryAndTheSurfacesLeadToIt(int a, int b, string? outcome)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene.Insert(Scene.LastIndexOf('}'), $",\"pairs\":[[{a},{b}]]"));
        DemoRun.Of("trace", scene, "--pair", $"{a},{b}", "--out", directory.File("t.html")).AssertDone();
        var page = new PageText(directory.File("t.html"));
        JsonElement depth = page.Data.GetProperty("depth"), result = depth.GetProperty("result");
        CsvRow row = Assert.Single(CsvRow.Parse(DemoRun.Of("query", scene, "--depth").Out));
        Assert.Equal((row.Status, row.Distance, row.LowerBound, row.Iterations), (
            result.GetProperty("status").GetString(), result.GetProperty("distance").GetSingle(),
            result.GetProperty("lowerBound").GetSingle(), result.GetProperty("iterations").GetInt32()));

        JsonElement[] steps = [.. depth.GetProperty("steps").EnumerateArray()];
        Assert.Equal(steps.Length, page.Count("depth-steps"));
        Assert.Equal(outcome, steps.LastOrDefault() is { ValueKind: not JsonValueKind.Undefined } last
            ? last.GetProperty("outcome").GetString()
            : null);
        int vertices = depth.GetProperty("vertices").GetArrayLength();
        AssertSurfaces(steps, vertices);
        if (outcome is null or "Flat") return;
        double margins = page.Data.GetProperty("marginA").GetDouble() + page.Data.GetProperty("marginB").GetDouble();
        double below = steps[^1].GetProperty("below").GetDouble(), above = steps[^1].GetProperty("above").GetDouble();
        Assert.InRange(-row.Distance - margins, below - 1e-6, above + 1e-6);
    }

    [Fact]
    public void ShapesThatAreApartHaveNoDepth()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene);
        DemoRun.Of("trace", scene, "--pair", "0,6", "--out", directory.File("t.html")).AssertDone();
        var page = new PageText(directory.File("t.html"));
        Assert.False(page.Data.TryGetProperty("depth", out _));
        Assert.Equal(0, page.Count("depth-steps"));
    }

    /// <summary>Asserts that the faces, put together from what is new in each step, are a closed surface.</summary>
    private static void AssertSurfaces(JsonElement[] steps, int vertices)
    {
        var faces = new Dictionary<int, int[]>();
        foreach (JsonElement step in steps.Where(s => s.TryGetProperty("lowest", out _)))
        {
            foreach (JsonElement face in step.GetProperty("removed").EnumerateArray())
                Assert.True(faces.Remove(face.GetInt32()));
            foreach (JsonElement face in step.GetProperty("added").EnumerateArray())
                faces[face[0].GetInt32()] = [face[1].GetInt32(), face[2].GetInt32(), face[3].GetInt32()];
            Assert.Equal(step.GetProperty("count").GetInt32(), faces.Count);
            Assert.Contains(step.GetProperty("lowest").GetInt32(), faces.Keys);
            Assert.InRange(step.GetProperty("vertex").GetInt32(), 4, vertices - 1);
            (int, int)[] edges = [.. faces.Values.SelectMany(f => new[] { (f[0], f[1]), (f[1], f[2]), (f[2], f[0]) })];
            Assert.Equal(edges.Order(), edges.Select(e => (e.Item2, e.Item1)).Order());
        }
    }
}
