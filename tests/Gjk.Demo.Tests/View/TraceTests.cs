using System.Text.Json;

namespace Gjk.Demo.Tests.View;

/// <summary>Tests the page that <c>trace</c> writes, without a browser. Its answer is that of <c>query</c>, and its
/// steps lead to that answer.</summary>
public sealed class TraceTests
{
    private const string Scene = """
        {"version":1,"name":"both","meshes":{"roof":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]]},"objects":[
          {"name":"</script>","shape":{"type":"box","halfExtents":[1,1,1]},"rotation":[0.5,0.5,0.5,0.5]},
          {"shape":{"type":"mesh","mesh":"roof"},"position":[3,2,1],"rotation":[0,0,0.6,0.8],"scale":[1,-2,1]},
          {"shape":{"type":"capsule","radius":0.5,"halfHeight":1},"position":[0,0.5,0]},
          {"shape":{"type":"sphere","radius":0.5},"position":[0,9,0]},
          {"shape":{"type":"sphere","radius":0.25},"position":[0,7,0]},
          {"shape":{"type":"ellipsoid","radii":[1,0.5,0.25]},"position":[-5,1,2]},
          {"shape":{"type":"point"},"position":[-5,1,2]}]}
        """;

    [Theory]
    [InlineData(0, 1, false)]
    [InlineData(1, 0, false)]
    [InlineData(0, 2, true)]
    [InlineData(3, 4, false)]
    [InlineData(1, 5, false)]
    [InlineData(5, 6, true)]
    public void TheAnswerIsThatOfQuery(int a, int b, bool overlaps)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene);
        DemoRun run = DemoRun.Of("trace", scene, "--pair", $"{a},{b}", "--out", directory.File("t.html"));
        run.AssertDone();
        Assert.Equal("", run.Out);
        Assert.Equal([scene, directory.File("t.html")], directory.Files.Order());
        var page = new PageText(directory.File("t.html"));
        page.AssertSelfContained();

        string listed = directory.Write("pair.json", Scene.Insert(Scene.LastIndexOf('}'), $",\"pairs\":[[{a},{b}]]"));
        CsvRow row = Assert.Single(CsvRow.Parse(DemoRun.Of("query", listed).Out));
        JsonElement result = page.Data.GetProperty("result");
        Assert.Equal((row.Status, row.Distance, row.LowerBound, row.Iterations), (
            result.GetProperty("status").GetString(), result.GetProperty("distance").GetSingle(),
            result.GetProperty("lowerBound").GetSingle(), result.GetProperty("iterations").GetInt32()));
        Assert.Equal(overlaps, row.Overlap);
        Assert.Equal((a, b), ((int)page.Count("a"), (int)page.Count("b")));
        Assert.Equal(row.Iterations, page.Count("steps"));
        AssertSteps(page.Data, row);
    }

    [Fact]
    public void TheBuiltInScenesCanBeTraced()
    {
        using var directory = new TempDirectory();
        foreach (string scene in new[] { "cubes", "spheres" })
        {
            DemoRun.Of("trace", "--builtin", scene, "--pair", "0,19", "--out", directory.File("t.html"))
                .AssertDone();
            Assert.InRange(new PageText(directory.File("t.html")).Count("steps"), 2, 20);
        }
    }

    [Theory]
    [InlineData("trace", "SCENE.json")]
    [InlineData("trace a.json --out a.html", "--pair")]
    [InlineData("trace a.json --pair 0,1", "--out")]
    [InlineData("trace --pair 0,1 --out a.html", "SCENE.json, --builtin or --example is needed")]
    [InlineData("trace a.json --builtin cubes --pair 0,1 --out a.html", "exclude")]
    [InlineData("trace --example none --out a.html", "--example none", "must be loop or wrong")]
    [InlineData("trace --example loop --pair 0,1 --out a.html", "--example and --pair exclude each other")]
    [InlineData("trace a.json --example loop --out a.html", "--example and SCENE.json exclude each other")]
    [InlineData("trace --builtin cubes --example loop --out a.html", "--example and --builtin exclude each other")]
    [InlineData("trace a.json --pair 0 --out a.html", "--pair 0")]
    [InlineData("trace a.json --pair 0,0 --out a.html", "--pair 0,0")]
    [InlineData("trace a.json --pair 0,1 --out a.json", "overwrite the scene")]
    [InlineData("trace none.json --pair 0,1 --out none.html", "no such file")]
    [InlineData("trace --builtin cubes --pair 0,20 --out none.html", "--pair 0,20: the scene has 20 objects")]
    public void WrongArgumentsAreOneLine(string args, params string[] parts) =>
        DemoRun.Of(args.Split(' ')).AssertRefused(parts);

    [Fact]
    public void RefusalsLeaveNoFile()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene);
        string bad = directory.Write(
            "bad.json", """{"version":1,"objects":[{"shape":{"type":"sphere","radius":-1}}]}""");
        string target = directory.File("t.html"), nowhere = Path.Combine(directory.Path, "nowhere", "t.html");
        DemoRun.Of("trace", scene, "--pair", "0,7", "--out", target)
            .AssertRefused(scene, "--pair 0,7", "7 objects");
        DemoRun.Of("trace", bad, "--pair", "0,1", "--out", target).AssertRefused(bad, "$.objects[0].shape.radius");
        DemoRun.Of("trace", scene, "--pair", "0,1", "--out", nowhere).AssertRefused(nowhere, "no such directory");
        DemoRun.Of("trace", scene, "--pair", "0,1", "--out", directory.Path)
            .AssertRefused(directory.Path, "directory");
        if (File.Exists("/dev/full"))
        {
            DemoRun.Of("trace", scene, "--pair", "0,1", "--out", "/dev/full")
                .AssertRefused("/dev/full", "cannot be written");
        }

        Assert.Equal([bad, scene], directory.Files.Order());
    }

    /// <summary>Asserts that each vertex is the difference of its points and lies on the drawn surface or inside it.
    /// Each simplex continues the one before, and the last bounds meet at the answer.</summary>
    private static void AssertSteps(JsonElement data, CsvRow row)
    {
        var kept = new List<int>();
        double lower = 0, upper = double.PositiveInfinity;
        int at = 0;
        foreach (JsonElement step in data.GetProperty("steps").EnumerateArray())
        {
            Vector3 w = Vector(step, "w");
            Vector3 onA = Vector(step, "onA");
            Vector3 onB = Vector(step, "onB");
            Vector3 n = Vector(step, "normal");
            Assert.Equal(0, (onA - onB - w).Length(), 1e-5f);
            Assert.Equal(1, n.Length(), 1e-5f);
            Assert.Equal(Vector3.Dot(n, w), step.GetProperty("lower").GetDouble(), 1e-5);
            Assert.Equal(kept, step.GetProperty("before").EnumerateArray().Select(i => i.GetInt32()));
            lower = double.Max(lower, step.GetProperty("lower").GetDouble());
            if (step.TryGetProperty("after", out JsonElement after))
            {
                kept = [.. after.EnumerateArray().Select(i => i.GetInt32())];
                Assert.All(kept, i => Assert.InRange(i, 0, at));
                Assert.Equal(kept.Count, step.GetProperty("weights").GetArrayLength());
                Assert.True(step.GetProperty("upper").GetDouble() <= upper + 1e-12);
                upper = step.GetProperty("upper").GetDouble();
            }

            at++;
        }

        if (at == 0 || row.Overlap) return;
        double margins = data.GetProperty("marginA").GetDouble() + data.GetProperty("marginB").GetDouble();
        Assert.Equal(row.Distance, lower - margins, 1e-5);
        Assert.Equal(row.Distance, upper - margins, 1e-5);
    }

    private static Vector3 Vector(JsonElement step, string name)
    {
        float[] v = [.. step.GetProperty(name).EnumerateArray().Select(x => x.GetSingle())];
        return new Vector3(v[0], v[1], v[2]);
    }
}
