using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Gjk.Core;
using Gjk.Demo.Tests.Support;
using Xunit;

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
        Assert.InRange(scene.GetProperty("support_share").GetDouble(), 0, 1);
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

    /// <summary>
    /// The hash is computed again from the numbers in the file. So these numbers are exactly the floats of the results.
    /// </summary>
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

    private static bool Overlaps(JsonElement pair) => pair.GetProperty("overlap").GetBoolean();

    private static int Int(JsonElement pair, string field) => pair.GetProperty(field).GetInt32();
}
