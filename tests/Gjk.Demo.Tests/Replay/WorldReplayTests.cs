using System.Globalization;
using System.Text.Json;

namespace Gjk.Demo.Tests.Replay;

/// <summary>Replay with a broad phase, motion, another number of objects, or threads. A frame finds the intersecting
/// pairs.</summary>
public sealed class WorldReplayTests
{
    private const int Objects = 150, Frames = 8;
    private const double Speed = 0.05;

    private static readonly string[] Fields =
    [
        "name", "objects", "vertices_per_object", "hull_vertices", "broad", "motion", "threads", "pairs_per_frame",
        "calls_per_frame", "calls_saved_per_frame",
        "intersecting_pairs", "frames", "ms_broad_median", "ms_narrow_median", "ms_per_frame_median",
        "ms_per_frame_p99", "bytes_per_frame", "hashed_frames", "hash", "pairs",
    ];

    private static readonly Lazy<(string Cubes, string Spheres)> Expected = new(() =>
        (HashOf(BuiltInScenes.Cubes(Objects), Speed, Frames), HashOf(BuiltInScenes.Spheres(Objects), Speed, Frames)));

    /// <summary>The test computes the hashes from every pair, without a broad phase or a scene.</summary>
    [Theory]
    [InlineData("--broad", "sort", "--threads", "1")]
    [InlineData("--broad", "sort", "--threads", "2")]
    [InlineData("--broad", "tree", "--threads", "1")]
    [InlineData("--broad", "tree", "--threads", "2")]
    [InlineData]
    public void TheHashIsThatOfEveryIntersectingPairOfEveryFrame(params string[] options)
    {
        using JsonDocument written = Replay(
            [.. options, "--objects", $"{Objects}", "--motion", "0.05", "--frames", $"{Frames}"]);
        JsonElement cubes = Scene(written, "cubes"), spheres = Scene(written, "spheres");
        Assert.Equal(Expected.Value, (Text(cubes, "hash"), Text(spheres, "hash")));
        Assert.NotEqual(Text(cubes, "hash"), Text(spheres, "hash"));
        Assert.Equal(Frames, cubes.GetProperty("hashed_frames").GetInt32());
    }

    [Fact]
    public void AMeasuredTimeDoesNotChangeTheHash()
    {
        string[] options = ["--objects", "40", "--motion", "0.1", "--seconds"];
        using JsonDocument shorter = Replay([.. options, "0.02"]);
        using JsonDocument longer = Replay([.. options, "0.2", "--broad", "sort"]);
        Assert.Equal(Text(Scene(shorter, "cubes"), "hash"), Text(Scene(longer, "cubes"), "hash"));
        JsonElement cubes = Scene(longer, "cubes");
        Assert.True(cubes.GetProperty("frames").GetInt32() > cubes.GetProperty("hashed_frames").GetInt32());
    }

    [Theory]
    [InlineData("cubes", 24, 8)]
    [InlineData("spheres", 515, 515)]
    public void TheReportsSceneSavesMostCalls(string name, int vertices, int hullVertices)
    {
        using JsonDocument written = Replay(["--broad", "sort", "--frames", "3"]);
        JsonElement scene = Scene(written, name);
        Assert.Equal(Fields, scene.EnumerateObject().Select(p => p.Name));
        Assert.Equal(
            (20, vertices, hullVertices, "sort", 0.0, 1, 190),
            (Number(scene, "objects"), Number(scene, "vertices_per_object"), Number(scene, "hull_vertices"),
                Text(scene, "broad"), scene.GetProperty("motion").GetDouble(),
                Number(scene, "threads"), Number(scene, "pairs_per_frame")));
        Assert.Equal(
            (3, 3, 5), (Number(scene, "frames"), Number(scene, "hashed_frames"), Number(scene, "intersecting_pairs")));
        Assert.InRange(Number(scene, "calls_per_frame"), 5, 20);
        Assert.Equal(190, Number(scene, "calls_per_frame") + Number(scene, "calls_saved_per_frame"));
        Assert.Equal(0, scene.GetProperty("bytes_per_frame").GetDouble());
        foreach (string time in new[] { "ms_broad_median", "ms_narrow_median", "ms_per_frame_median" })
            Assert.True(scene.GetProperty(time).GetDouble() > 0);
        Assert.True(
            scene.GetProperty("ms_per_frame_p99").GetDouble() >= scene.GetProperty("ms_per_frame_median").GetDouble());
        Assert.Equal(
            [(10, 11), (12, 13), (14, 15), (16, 17), (18, 19)],
            scene.GetProperty("pairs").EnumerateArray().Select(p => (Number(p, "a"), Number(p, "b"))));
    }

    [Fact]
    public void TheTableIsPlainAndComplete()
    {
        DemoRun run = DemoRun.Of("replay", "--motion", "0.01", "--threads", "2", "--frames", "2");
        run.AssertDone();
        Assert.All(run.Out, c => Assert.True(c is '\n' or >= ' ' and <= '~'));
        string[] rows =
        [
            "objects", "broad phase", "threads", "calls made", "calls saved", "intersecting pairs",
            "broad phase, median", "narrow phase, median", "bytes", "hash",
        ];
        foreach (string row in rows)
            Assert.Contains(row, run.Out);
        Assert.Contains("| threads                        |                2 |                2 |", run.Out);
        Assert.DoesNotContain("report", run.Out);
    }

    [Theory]
    [InlineData("--broad", "quadtree", "--broad quadtree: must be one of sort, tree")]
    [InlineData("--broad", "All", "--broad All")]
    [InlineData("--motion", "-0.01", "--motion -0.01: must be a number, at least 0")]
    [InlineData("--motion", "NaN", "--motion NaN: must be a number")]
    [InlineData("--motion", "Infinity", "--motion Infinity")]
    [InlineData("--motion", "1e4", "at most 1000")]
    [InlineData("--motion", "fast", "--motion fast")]
    [InlineData("--objects", "1", "--objects 1: must be a whole number, at least 2, at most 1000000")]
    [InlineData("--objects", "-5", "--objects -5")]
    [InlineData("--objects", "1000001", "--objects 1000001")]
    [InlineData("--objects", "99999999999", "--objects 99999999999")]
    [InlineData("--objects", "2.5", "--objects 2.5")]
    [InlineData("--threads", "0", "--threads 0: must be a whole number, at least 1")]
    [InlineData("--threads", "-1", "--threads -1")]
    [InlineData("--threads", "1000", "at most 256")]
    [InlineData("--threads", "two", "--threads two")]
    public void ASettingThatMakesNoSenseIsOneLine(string option, string value, string reason)
    {
        using var directory = new TempDirectory();
        DemoRun.Of("replay", option, value, "--json", directory.File("out.json"))
            .AssertRefused("replay: ", reason);
        Assert.Empty(directory.Files);
    }

    [Theory]
    [InlineData("--broad")]
    [InlineData("--motion")]
    [InlineData("--objects --frames 1")]
    [InlineData("--broad tree --broad sort")]
    [InlineData("--threads 1 --threads 2")]
    public void AnOptionWithoutOneValueIsOneLine(string options) =>
        DemoRun.Of([.. options.Split(' ')]).AssertRefused(options.Split(' ')[0]);

    [Fact]
    public void HelpNamesTheOptions()
    {
        DemoRun run = DemoRun.Of("replay", "--help");
        run.AssertDone();
        string[] words = ["--broad <sort|tree>", "--motion <SPEED>", "--objects <N>", "--threads <N>"];
        foreach (string word in words) Assert.Contains(word, run.Out);
    }

    [UnixTheory]
    [InlineData("1")]
    [InlineData("2")]
    public void CtrlCBeforeTheFirstSceneIsCompleteWritesNothing(string threads)
    {
        using var directory = new TempDirectory();
        using var watch = new TemporaryFileWatch(directory);
        using RunningDemo demo = RunningDemo.Start(
            "--objects", "500", "--motion", "0.01", "--threads", threads, "--seconds", "60",
            "--json", directory.File("replay.json"));
        demo.WaitUntil(_ => watch.HasSeenOne);
        demo.Interrupt();
        DemoRun run = demo.Wait();
        Assert.Equal((130, "", ""), (run.ExitCode, run.Out, run.Error));
        Assert.Empty(directory.Files);
    }

    private static JsonDocument Replay(string[] options)
    {
        using var directory = new TempDirectory();
        DemoRun.Of(["replay", .. options, "--json", directory.File("replay.json")]).AssertDone();
        return JsonDocument.Parse(File.ReadAllText(directory.File("replay.json")));
    }

    private static JsonElement Scene(JsonDocument written, string name) =>
        written.RootElement.GetProperty("scenes").EnumerateArray()
            .Single(s => s.GetProperty("name").GetString() == name);

    private static string Text(JsonElement element, string field) => element.GetProperty(field).GetString()!;

    private static int Number(JsonElement element, string field) => element.GetProperty(field).GetInt32();

    /// <summary>FNV-1a over each frame. It takes the number of intersecting pairs and then both indices of each, as
    /// 32-bit little-endian numbers.</summary>
    private static string HashOf(BuiltInScene scene, double speed, int frames)
    {
        ulong hash = 14695981039346656037;
        var shape = ConvexShape.Mesh(scene.Vertices);
        var objects = new MovingObjects(scene, speed);
        for (int frame = 0; frame < frames; frame++)
        {
            List<int> words = [0];
            for (int a = 0; a < objects.Poses.Length; a++)
            {
                for (int b = a + 1; b < objects.Poses.Length; b++)
                    if (ConvexQuery.Overlaps(shape, objects.Poses[a], shape, objects.Poses[b])) words.AddRange([a, b]);
            }

            words[0] = words.Count / 2;
            Assert.InRange(words[0], Objects / 10, Objects);
            foreach (byte b in words.SelectMany(BitConverter.GetBytes)) hash = unchecked((hash ^ b) * 1099511628211);
            objects.Advance();
        }

        return hash.ToString("x16", CultureInfo.InvariantCulture);
    }
}
