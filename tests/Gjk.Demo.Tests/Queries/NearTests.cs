using System.Globalization;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.Tests.Queries;

/// <summary><c>query --within</c> lists near pairs, and <c>query --contacts</c> where shapes touch.</summary>
public sealed class NearTests
{
    private const string Columns = "a,b,part_a,part_b,point,gap,ax,ay,az,bx,by,bz,nx,ny,nz,feature";

    /// <summary>A floor of two triangles, a crate on it, a ball 0.25 above the crate, two flush blocks as one object
    /// beside it, and a crate that hangs 0.125 above the blocks.</summary>
    private const string Room = """
        {"version":1,
         "meshes":{"floor":{"vertices":[[-9,0,-9],[9,0,-9],[9,0,9],[-9,0,9]],"triangles":[[0,2,1],[0,3,2]]}},
         "objects":[
          {"name":"floor","shape":{"type":"surface","mesh":"floor"}},
          {"name":"crate","shape":{"type":"box","halfExtents":[0.5,0.5,0.5]},"position":[-3,0.5,1]},
          {"name":"ball","shape":{"type":"sphere","radius":0.5},"position":[-3,1.75,1]},
          {"name":"blocks","shape":{"type":"compound","parts":[
            {"shape":{"type":"box","halfExtents":[1,0.5,1]},"position":[-1,0,0]},
            {"shape":{"type":"box","halfExtents":[1,0.5,1]},"position":[1,0,0]}]},"position":[4,0.4375,0]},
          {"name":"lid","shape":{"type":"box","halfExtents":[0.5,0.5,0.5]},"position":[3,1.5625,0.25]}]}
        """;

    [Fact]
    public void OnlyNearPairsAreListed()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("room.json", Room);
        DemoRun all = DemoRun.Of("query", scene), near = DemoRun.Of("query", scene, "--within", "0.25");
        near.AssertDone();
        List<CsvRow> expected = CsvRow.Parse(all.Out).FindAll(row => row.Distance <= 0.25f);
        Assert.Equal(expected, CsvRow.Parse(near.Out));
        Assert.Equal([(0, 1), (0, 3), (1, 2), (3, 4)], expected.Select(row => (row.A, row.B)));
        Assert.Equal(
            [(0, 1), (0, 3)], CsvRow.Parse(DemoRun.Of("query", scene, "--within", "0").Out).Select(r => (r.A, r.B)));
        Assert.Equal(all.Out, DemoRun.Of("query", scene, "--within", "Infinity").Out);

        string target = directory.File("near.csv");
        DemoRun file = DemoRun.Of("query", scene, "--within", "0.25", "--names", "--parts", "--out", target);
        file.AssertDone();
        Assert.Equal($"gjk-demo: wrote 4 pairs to {target}\n", file.Error);
    }

    /// <summary>Two half-spaces have no distance: the full list says so, that of near pairs leaves them out.</summary>
    [Fact]
    public void TwoHalfSpacesAreNotNear()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("corner.json", """
            {"version":1,"objects":[
              {"shape":{"type":"halfspace","normal":[0,1,0],"offset":0}},
              {"shape":{"type":"halfspace","normal":[1,0,0],"offset":0}},
              {"shape":{"type":"sphere","radius":0.5},"position":[0.625,3,0]}]}
            """);
        Assert.Contains("InvalidShape", DemoRun.Of("query", scene).Out, StringComparison.Ordinal);
        DemoRun near = DemoRun.Of("query", scene, "--within", "0.25");
        near.AssertDone();
        Assert.Equal([(1, 2)], CsvRow.Parse(near.Out).Select(row => (row.A, row.B)));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(0.25f)]
    public void ContactPointsAreThoseOfTheLibrary(float gap)
    {
        using var directory = new TempDirectory();
        string file = directory.Write("room.json", Room);
        string[] within = gap > 0 ? ["--within", gap.ToString(CultureInfo.InvariantCulture)] : [];
        DemoRun run = DemoRun.Of(["query", file, "--contacts", .. within]);
        run.AssertDone();
        Scene scene = SceneFile.Load(file, CancellationToken.None);
        var expected = new List<string> { Columns };
        var contacts = new List<PairContacts>();
        var scratch = new ConcaveScratch();
        foreach ((int a, int b) in scene.Pairs)
        {
            SceneObject one = scene.Objects[a], other = scene.Objects[b];
            if (one.IsConvex && other.IsConvex)
            {
                DistanceResult result = ConvexQuery.Contacts(
                    one.Shape, one.Pose, other.Shape, other.Pose, gap, out ContactManifold manifold);
                for (int i = 0; i < manifold.Count; i++) expected.Add(Row(a, b, -1, -1, manifold, i));
                continue;
            }

            ConcaveQuery.FindContacts(one.Any, one.Pose, other.Any, other.Pose, gap, scratch, contacts);
            foreach (PairContacts found in contacts)
            {
                for (int i = 0; i < found.Manifold.Count; i++)
                    expected.Add(Row(a, b, found.PartA, found.PartB, found.Manifold, i));
            }
        }

        string[] rows = run.Out.TrimEnd('\n').Split('\n');
        Assert.Equal(expected, rows);
        Assert.Contains(rows, row => row.StartsWith("0,1,", StringComparison.Ordinal));
        Assert.Contains(rows, row => row.StartsWith("0,3,", StringComparison.Ordinal));
        Assert.Equal(gap > 0, rows.Any(row => row.StartsWith("1,2,,,0,0.25,", StringComparison.Ordinal)));
        Assert.Equal(gap > 0, rows.Any(row => row.StartsWith("3,4,0,,", StringComparison.Ordinal)));
    }

    [Fact]
    public void ARecordHasContactsToo()
    {
        string record = new QueryRecord(
            ConvexShape.Box(new Vector3(1)), RigidPose.Identity, ConvexShape.Sphere(1),
            new RigidPose(Quaternion.Identity, new Vector3(0, 1.5f, 0))).ToString();
        DemoRun run = DemoRun.Of("query", "--contacts", "--record", record);
        run.AssertDone();
        string row = Assert.Single(run.Out.TrimEnd('\n').Split('\n')[1..]);
        Assert.StartsWith("0,1,,,0,-0.5,0,1,0,0,0.5,0,0,1,0,", row);
    }

    [Theory]
    [InlineData("--within -1", "--within -1: must be a number, at least 0, or Infinity")]
    [InlineData("--within near", "--within near: must be a number, at least 0")]
    [InlineData("--within 1 --max-distance 2", "--max-distance and --within exclude each other")]
    [InlineData("--contacts --max-distance 2", "--contacts and --max-distance exclude each other")]
    [InlineData("--contacts --depth", "--contacts and --depth exclude each other")]
    [InlineData("--contacts --parts", "--contacts and --parts exclude each other")]
    [InlineData("--contacts --check", "--contacts and --check exclude each other")]
    public void WhatDoesNotGoTogetherIsRefused(string options, string reason)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("room.json", Room), target = directory.File("out.csv");
        DemoRun.Of(["query", scene, "--out", target, .. options.Split(' ')]).AssertRefused("query: ", reason);
        Assert.False(File.Exists(target));
    }

    private static string Row(int a, int b, int partA, int partB, in ContactManifold manifold, int i)
    {
        ManifoldPoint point = manifold[i];
        string[] parts = [partA < 0 ? "" : $"{partA}", partB < 0 ? "" : $"{partB}"];
        Vector3[] vectors = [point.PointA, point.PointB, manifold.Normal];
        IEnumerable<string> numbers = vectors.SelectMany(v => new[] { v.X, v.Y, v.Z }).Prepend(point.Gap)
            .Select(x => (x + 0f).ToString("R", CultureInfo.InvariantCulture));
        return $"{a},{b},{parts[0]},{parts[1]},{i},{string.Join(',', numbers)},{point.FeatureId}";
    }
}
