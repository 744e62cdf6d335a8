using System.Globalization;
using System.Text.Json;

namespace Gjk.Demo.Tests.Replay;

/// <summary>One replay, with its printed and written output.</summary>
public sealed class ReplayFixture : IDisposable
{
    private readonly TempDirectory _directory = new();

    public ReplayFixture()
    {
        Run = DemoRun.Of("--frames", "2", "--json", _directory.File("replay.json"));
        Document = JsonDocument.Parse(File.ReadAllText(_directory.File("replay.json")));
        Files = _directory.Files.Length;
    }

    public DemoRun Run { get; }

    public JsonDocument Document { get; }

    public int Files { get; }

    public JsonElement Scene(string name) =>
        Document.RootElement.GetProperty("scenes").EnumerateArray()
            .Single(s => s.GetProperty("name").GetString() == name);

    public void Dispose()
    {
        Document.Dispose();
        _directory.Dispose();
    }
}

public sealed class ReplayTests : IClassFixture<ReplayFixture>
{
    private static readonly string[] Fields =
    [
        "name", "objects", "vertices_per_object", "hull_vertices", "calls_per_frame", "intersecting_pairs",
        "loops_per_call", "frames",
        "ms_per_frame_median", "ms_per_frame_p99", "support_share", "bytes_per_call", "iteration_limits", "hash",
        "pairs",
    ];

    private readonly ReplayFixture _replay;

    public ReplayTests(ReplayFixture replay) => _replay = replay;

    [Theory]
    [InlineData("cubes", 24, 8)]
    [InlineData("spheres", 515, 515)]
    public void TheFiguresAreThoseOfTheReportsScene(string name, int vertices, int hullVertices)
    {
        _replay.Run.AssertDone();
        JsonElement scene = _replay.Scene(name);
        Assert.Equal(Fields, scene.EnumerateObject().Select(p => p.Name));
        Assert.Equal(20, scene.GetProperty("objects").GetInt32());
        Assert.Equal(vertices, scene.GetProperty("vertices_per_object").GetInt32());
        Assert.Equal(hullVertices, scene.GetProperty("hull_vertices").GetInt32());
        Assert.Equal(190, scene.GetProperty("calls_per_frame").GetInt32());
        Assert.Equal(5, scene.GetProperty("intersecting_pairs").GetInt32());
        Assert.Equal(2, scene.GetProperty("frames").GetInt32());
        Assert.Equal(0, scene.GetProperty("bytes_per_call").GetDouble());
        Assert.Equal(0, scene.GetProperty("iteration_limits").GetInt32());
        Assert.True(scene.GetProperty("ms_per_frame_median").GetDouble() > 0);
        Assert.True(
            scene.GetProperty("ms_per_frame_p99").GetDouble() >= scene.GetProperty("ms_per_frame_median").GetDouble());

        // A difference of two times: of two frames, on a busy machine, it may be none.
        Assert.InRange(scene.GetProperty("support_share").GetDouble(), 0, 0.99);
    }

    [Theory]
    [InlineData("cubes")]
    [InlineData("spheres")]
    public void ThePairsCarryTheResults(string name)
    {
        JsonElement[] pairs = [.. _replay.Scene(name).GetProperty("pairs").EnumerateArray()];
        Assert.Equal(190, pairs.Length);
        Assert.All(pairs, p => Assert.Equal(CsvRow.Header.Split(','), p.EnumerateObject().Select(f => f.Name)));
        Assert.Equal(
            [(10, 11), (12, 13), (14, 15), (16, 17), (18, 19)],
            pairs.Where(Overlaps).Select(p => (Int(p, "a"), Int(p, "b"))));
        double loops = pairs.Average(p => Int(p, "iterations"));
        Assert.Equal(loops, _replay.Scene(name).GetProperty("loops_per_call").GetDouble(), 1e-12);
    }

    /// <summary>The hash is computed again from the numbers in the file. So these numbers are exactly the floats of the
    /// results.</summary>
    [Theory]
    [InlineData("cubes")]
    [InlineData("spheres")]
    public void TheHashIsThatOfThePairs(string name)
    {
        ulong hash = 14695981039346656037;
        foreach (JsonElement pair in _replay.Scene(name).GetProperty("pairs").EnumerateArray())
        {
            var bytes = new List<byte>();
            bytes.AddRange(BitConverter.GetBytes(Int(pair, "a")));
            bytes.AddRange(BitConverter.GetBytes(Int(pair, "b")));
            bytes.Add((byte)(Enum.Parse<GjkStatus>(pair.GetProperty("status").GetString()!) - GjkStatus.Separated));
            foreach (string field in "distance,ax,ay,az,bx,by,bz,nx,ny,nz".Split(','))
                bytes.AddRange(BitConverter.GetBytes(pair.GetProperty(field).GetSingle() + 0f));
            foreach (byte b in bytes) hash = unchecked((hash ^ b) * 1099511628211);
        }

        Assert.Equal(
            hash.ToString("x16", CultureInfo.InvariantCulture), _replay.Scene(name).GetProperty("hash").GetString());
    }

    [Fact]
    public void TheTableIsPlainAndComplete()
    {
        Assert.DoesNotContain('\u001b', _replay.Run.Out);
        Assert.All(_replay.Run.Out, c => Assert.True(c is '\n' or >= ' ' and <= '~'));
        Assert.DoesNotContain(" \n", _replay.Run.Out);
        string[] rows =
        [
            "objects", "vertices", "calls per frame", "intersecting pairs", "loops per call", "median", "99 %",
            "support", "factor", "hash",
            "\nloops: supports asked", "\ntime in support: what a second search", "\nfactor: the report's milliseconds",
            "\nhash: of the bits of all answers",
        ];
        foreach (string row in rows)
            Assert.Contains(row, _replay.Run.Out);
        string[] pairs =
        [
            "Cube (11) - Cube (12)", "Cube (19) - Cube (20)", "Sphere (11) - Sphere (12)", "Sphere (19) - Sphere (20)",
        ];
        foreach (string pair in pairs)
            Assert.Contains(pair, _replay.Run.Out);
        Assert.Contains(_replay.Scene("cubes").GetProperty("hash").GetString()!, _replay.Run.Out);
        Assert.Equal(1, _replay.Files);
    }

    [Theory]
    [InlineData("replay --frames 1")]
    [InlineData("replay --frames 1 --motion 0.01")]
    public void TheTableFitsATerminalOf80Columns(string call)
    {
        DemoRun run = DemoRun.Of(call.Split(' '));
        run.AssertDone();
        string[] lines = run.Out.Split('\n');
        Assert.Contains(lines, line => line.StartsWith('|'));
        Assert.All(lines, line => Assert.InRange(line.Length, 0, 80));
    }

    [Fact]
    public void AnotherRunGivesTheSameHashes()
    {
        DemoRun again = DemoRun.Of("replay", "--frames", "1");
        again.AssertDone();
        Assert.Contains(_replay.Scene("cubes").GetProperty("hash").GetString()!, again.Out);
        Assert.Contains(_replay.Scene("spheres").GetProperty("hash").GetString()!, again.Out);
    }

    /// <summary>The experiment's own scene as a file gives the same answers, without the report's column.</summary>
    [Fact]
    public void ASceneFileIsReplayedAsTheExperiment()
    {
        using var directory = new TempDirectory();
        BuiltInScene cubes = BuiltInScenes.Cubes();
        string Text(params float[] numbers) => $"[{string.Join(", ", numbers.Select(x => x.ToString("R")))}]";
        IEnumerable<string> objects = cubes.Poses.Select((pose, i) => $$"""
            { "name": "{{cubes.ObjectNames[i]}}", "shape": { "type": "mesh", "mesh": "cube" },
              "position": {{Text(pose.Position.X, pose.Position.Y, pose.Position.Z)}},
              "rotation": {{Text(pose.Rotation.X, pose.Rotation.Y, pose.Rotation.Z, pose.Rotation.W)}} }
            """);
        string mesh = string.Join(", ", cubes.Vertices.Select(v => Text(v.X, v.Y, v.Z)));
        string scene = directory.Write(
            "cubes.json",
            $$"""{ "version": 1, "name": "cubes", "meshes": { "cube": [{{mesh}}] }, "objects": [ """
            + string.Join(",\n", objects) + " ] }\n");
        DemoRun run = DemoRun.Of("replay", scene, "--frames", "2", "--json", directory.File("replay.json"));
        run.AssertDone();
        Assert.Contains($"hash:   cubes {_replay.Scene("cubes").GetProperty("hash").GetString()}", run.Out);
        Assert.Contains("Cube (11) - Cube (12)", run.Out);
        Assert.DoesNotContain("report", run.Out);
        using var json = JsonDocument.Parse(File.ReadAllText(directory.File("replay.json")));
        JsonElement figures = Assert.Single(json.RootElement.GetProperty("scenes").EnumerateArray());
        Assert.Equal(Fields, figures.EnumerateObject().Select(p => p.Name));
        Assert.Equal(JsonValueKind.Null, figures.GetProperty("vertices_per_object").ValueKind);
        Assert.Equal(8, figures.GetProperty("hull_vertices").GetInt32());
        Assert.Equal(0, figures.GetProperty("bytes_per_call").GetDouble());
        Assert.InRange(figures.GetProperty("support_share").GetDouble(), 0, 1);
    }

    /// <summary>Shapes of all kinds, surfaces among them; the answers are those of query.</summary>
    [Fact]
    public void AnySceneFileCanBeReplayed()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("mixed.json", """
            { "version": 1, "name": "mixed", "meshes": { "tent":
                { "vertices": [[0,0,0],[2,0,0],[2,1,1],[0,1,1]], "triangles": [[0,1,2],[0,2,3]] } },
              "objects": [ { "shape": { "type": "surface", "mesh": "tent" } },
                { "name": "ball", "shape": { "type": "sphere", "radius": 0.5 }, "position": [1, 3, 0.5] },
                { "shape": { "type": "box", "halfExtents": [1, 1, 1] }, "position": [1, 3, 1] } ] }
            """);
        string file = directory.File("replay.json");
        DemoRun.Of("replay", scene, "--frames", "2", "--json", file).AssertDone();
        using var json = JsonDocument.Parse(File.ReadAllText(file));
        JsonElement figures = json.RootElement.GetProperty("scenes")[0];
        foreach (string field in new[] { "vertices_per_object", "hull_vertices", "support_share" })
            Assert.Equal(JsonValueKind.Null, figures.GetProperty(field).ValueKind);
        Assert.Equal(0, figures.GetProperty("bytes_per_call").GetDouble());
        Assert.Equal(1, figures.GetProperty("intersecting_pairs").GetInt32());
        string[] rows = DemoRun.Of("query", scene).Out.TrimEnd('\n').Split('\n')[1..];
        Assert.Equal(
            rows.Select(r => float.Parse(r.Split(',')[4], CultureInfo.InvariantCulture)),
            figures.GetProperty("pairs").EnumerateArray().Select(p => p.GetProperty("distance").GetSingle()));
    }

    [Theory]
    [InlineData("replay none.json", "none.json: cannot be read")]
    [InlineData("replay - -", "standard input can be read only once")]
    [InlineData("replay a.json --objects 9", "--objects is for the report's scenes")]
    [InlineData("replay a.json --mesh unity", "--mesh is for the report's scenes")]
    [InlineData("replay a.json --json a.json", "would overwrite the scene")]
    public void WrongArgumentsAreOneLine(string args, string part) =>
        DemoRun.Of(args.Split(' ')).AssertRefused(part);

    [Fact]
    public void ASceneWithoutPairsIsRefused()
    {
        using var directory = new TempDirectory();
        string file = directory.Write(
            "one.json", """{ "version": 1, "name": "one", "objects": [ { "shape": { "type": "point" } } ] }""");
        DemoRun.Of("replay", file).AssertRefused($"{file}: $.pairs: 0 pairs, but 1 to 1000000 can be replayed");
    }

    private static bool Overlaps(JsonElement pair) => pair.GetProperty("overlap").GetBoolean();

    private static int Int(JsonElement pair, string field) => pair.GetProperty(field).GetInt32();
}
