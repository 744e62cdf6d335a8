using System.Text.Json;
using Gjk.Demo.Scenes;
using Gjk.Demo.Tests.Scenes;
using Gjk.Demo.Timing;

namespace Gjk.Demo.Tests.Timing;

public sealed class TimeTests
{
    private const string Boxes = """
        {"version":1,"objects":[
          {"shape":{"type":"box","halfExtents":[1,1,1]}},
          {"shape":{"type":"box","halfExtents":[1,1,1]},"position":[1,0.5,0.25],"rotation":[0.5,0.5,0.5,0.5]},
          {"shape":{"type":"mesh","mesh":"m"},"position":[9,0,0],"velocity":[1,0,0]}],
         "meshes":{"m":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]]}}
        """;

    private static readonly string[] Fields =
    [
        "scene", "pairs", "overlapping", "cold_ns", "cold_median_ns", "warm_ns", "moving_ns", "bool_ns", "iterations",
        "bytes_per_call", "batch_ns", "batch_warm_ns", "batch_bool_ns", "depth_ns", "cast_ns",
    ];

    [Fact]
    public void EachSceneIsALineOfJson()
    {
        using var directory = new TempDirectory();
        string boxes = directory.Write("boxes.v1.json", Boxes);
        string empty = directory.Write("empty.json", """{"version":1,"objects":[]}""");
        DemoRun run = DemoRun.Of("time", boxes, empty, "--seconds", "0.02");
        run.AssertDone();
        string[] lines = run.Out.TrimEnd('\n').Split('\n');
        Assert.Equal(2, lines.Length);

        using JsonDocument timed = JsonDocument.Parse(lines[0]);
        JsonElement figures = timed.RootElement;
        Assert.Equal(Fields, figures.EnumerateObject().Select(p => p.Name));
        Assert.Equal("boxes.v1", figures.GetProperty("scene").GetString());
        Assert.Equal(3, figures.GetProperty("pairs").GetInt32());
        Assert.Equal(1, figures.GetProperty("overlapping").GetInt32());
        Assert.Equal(0, figures.GetProperty("bytes_per_call").GetDouble());
        Assert.InRange(figures.GetProperty("iterations").GetDouble(), 1, 20);
        foreach (string time in Fields.Where(f => f.EndsWith("_ns", StringComparison.Ordinal)))
            Assert.InRange(figures.GetProperty(time).GetDouble(), 1, 1e6);
        Assert.True(figures.GetProperty("cold_median_ns").GetDouble() >= figures.GetProperty("cold_ns").GetDouble());

        using JsonDocument nothing = JsonDocument.Parse(lines[1]);
        Assert.Equal(Fields, nothing.RootElement.EnumerateObject().Select(p => p.Name));
        Assert.Equal(0, nothing.RootElement.GetProperty("pairs").GetInt32());
        Assert.Equal(JsonValueKind.Null, nothing.RootElement.GetProperty("cold_ns").ValueKind);
        Assert.Equal(JsonValueKind.Null, nothing.RootElement.GetProperty("cast_ns").ValueKind);
    }

    /// <summary>Casts are timed where an object has a velocity, and none turns.</summary>
    [Theory]
    [InlineData("", false)]
    [InlineData(",\"velocity\":[0,0,0]", false)]
    [InlineData(",\"velocity\":[-9,0,0]", true)]
    [InlineData(",\"velocity\":[-9,0,0],\"angularVelocity\":[0,1,0]", false)]
    public void CastsAreTimedWhereTheyApply(string motion, bool applies)
    {
        using var directory = new TempDirectory();
        string file = directory.Write("moving.json", Boxes.Replace(",\"velocity\":[1,0,0]", motion));
        Scene scene = SceneFile.Load(file, CancellationToken.None);
        Assert.Equal(applies, new SceneTimer(scene, TimeSpan.Zero, _ => { }, CancellationToken.None).AreCastsTimed);
    }

    /// <summary>Surfaces and compounds have distances, overlaps and casts, but no starts, batches or depths.</summary>
    [Fact]
    public void ConcaveScenesAreTimed()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write(
            "c.json",
            """
            {"version":1,"meshes":{"m":{"vertices":[[0,0,0],[1,0,0],[0,1,0]],"triangles":[[0,1,2]]}},"objects":[
              {"shape":{"type":"surface","mesh":"m"}},
              {"shape":{"type":"compound","parts":[{"shape":{"type":"point"},"position":[0,0,3]}]}},
              {"shape":{"type":"sphere","radius":1},"velocity":[0,0,9]}]}
            """);
        DemoRun run = DemoRun.Of("time", scene, "--seconds", "0.03");
        run.AssertDone();
        using JsonDocument timed = JsonDocument.Parse(run.Out);
        JsonElement figures = timed.RootElement;
        Assert.Equal(Fields, figures.EnumerateObject().Select(p => p.Name));
        Assert.Equal(1, figures.GetProperty("overlapping").GetInt32());
        Assert.Equal(0, figures.GetProperty("bytes_per_call").GetDouble());
        foreach (string time in new[] { "cold_ns", "cold_median_ns", "moving_ns", "bool_ns", "cast_ns" })
            Assert.InRange(figures.GetProperty(time).GetDouble(), 1, 1e6);
        foreach (string time in new[] { "warm_ns", "batch_ns", "batch_warm_ns", "batch_bool_ns", "depth_ns" })
            Assert.Equal(JsonValueKind.Null, figures.GetProperty(time).ValueKind);
    }

    [UnixFact]
    public void CtrlCKeepsTheScenesThatWereDone()
    {
        using var directory = new TempDirectory();
        string empty = directory.Write("empty.json", """{"version":1,"objects":[]}""");
        string points = directory.Write("points.json", SceneTests.Points(40, pairs: ""));
        using RunningDemo demo = RunningDemo.Start("time", empty, points, "--seconds", "60");
        demo.WaitUntil(text => text.EndsWith('\n'));
        demo.Interrupt();
        DemoRun run = demo.Wait();
        Assert.Equal((130, ""), (run.ExitCode, run.Error));
        Assert.Single(run.Out.TrimEnd('\n').Split('\n'));
        Assert.Contains("\"scene\":\"empty\"", run.Out);
    }
}
