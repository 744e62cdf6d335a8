using System.Globalization;

namespace Gjk.Demo.Tests.View;

/// <summary>Tests the page that <c>view</c> writes, without a browser. Its answers are those of <c>query --depth</c>.
/// The tests in tests/Gjk.Viewer open the page in a browser.</summary>
public sealed class ViewTests
{
    private const string Moving = """
        {"version":1,"name":"moving","frames":5,"objects":[
          {"name":"box","shape":{"type":"box","halfExtents":[1,1,1]}},
          {"shape":{"type":"box","halfExtents":[1,0.5,0.5]},"position":[4,0,0],
            "velocity":[-0.5,0,0],"angularVelocity":[0,0,0.7853982]},
          {"name":"</script><b>&","shape":{"type":"capsule","radius":0.5,"halfHeight":1},"position":[0,3,0]}]}
        """;

    [Theory]
    [InlineData("cubes")]
    [InlineData("spheres")]
    public void BuiltInScenesHaveTheirCounts(string scene)
    {
        using var directory = new TempDirectory();
        DemoRun run = DemoRun.Of("view", "--builtin", scene, "--out", directory.File("a.html"));
        run.AssertDone();
        Assert.Equal("", run.Out);
        var page = new PageText(directory.File("a.html"));
        page.AssertSelfContained();
        Assert.Equal(
            (20, 190, 190, 1, 5),
            (page.Count("objects"), page.Count("pairs"), page.Count("listed"), page.Count("frames"),
            page.Count("overlapping")));
        Assert.Equal(5, page.Column<byte>("status").Count(s => s == 1));
        Assert.Single(page.Data.GetProperty("shapes").EnumerateArray());
    }

    [Fact]
    public void AnswersAreThoseOfQueryBitForBit()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Moving);
        DemoRun.Of("view", scene, "--out", directory.File("a.html")).AssertDone();
        var page = new PageText(directory.File("a.html"));
        page.AssertSelfContained();
        AssertFrame(page, 0, CsvRow.Parse(DemoRun.Of("query", scene, "--depth").Out));
        Assert.Equal(
            ["box", null, "</script><b>&"], page.Data.GetProperty("names").EnumerateArray().Select(n => n.GetString()));
    }

    /// <summary>Two boxes reach 0.5 into each other, two only touch, and those that are apart keep their
    /// distance.</summary>
    [Fact]
    public void AnIntersectingPairHasItsWayOut()
    {
        using var directory = new TempDirectory();
        const string Box = "\"shape\":{\"type\":\"box\",\"halfExtents\":[1,1,1]}";
        string scene = directory.Write(
            "scene.json",
            $"{{\"version\":1,\"objects\":[{{{Box}}},{{{Box},\"position\":[1.5,0.25,0]}},"
            + $"{{{Box},\"position\":[-2,0,0]}}]}}");
        DemoRun.Of("view", scene, "--out", directory.File("a.html")).AssertDone();
        var page = new PageText(directory.File("a.html"));
        Assert.Equal(2, page.Count("overlapping"));
        Assert.Equal([1, 1, 0], page.Column<byte>("status"));
        Assert.Equal([-0.5f, 0, 1.5f], page.Column<float>("distance"));
        Assert.Equal([1, 0, 0], page.Column<float>("normal")[..3]);
        Assert.Equal(1, page.Column<float>("pointA")[0]);
        Assert.Equal(0.5f, page.Column<float>("pointB")[0]);
    }

    /// <summary>The search for the depth outgrows its room for ellipsoids about one centre. They intersect all the
    /// same, but have no deepest points, and so no arrow.</summary>
    [Fact]
    public void APairWithoutRoomForItsDepthIntersects()
    {
        using var directory = new TempDirectory();
        const string Round = "{\"shape\":{\"type\":\"ellipsoid\",\"radii\":[1,0.999,0.998]}}";
        string scene = directory.Write("scene.json", $"{{\"version\":1,\"objects\":[{Round},{Round}]}}");
        string html = directory.File("a.html"), picture = directory.File("a.svg");
        DemoRun.Of("view", scene, "--out", html, "--svg", picture).AssertDone();
        var page = new PageText(html);
        Assert.Equal(1, page.Count("overlapping"));
        Assert.Equal(GjkStatus.IterationLimit, (GjkStatus)(page.Column<byte>("status")[0] + 1));
        Assert.InRange(page.Column<float>("distance")[0], -2, -1.9f);
        Assert.Equal([0], page.Column<byte>("contactCounts"));
        string svg = File.ReadAllText(picture);
        Assert.Contains("1 intersecting", svg);
        Assert.DoesNotContain("depth", svg);
        Assert.DoesNotContain("contact", svg);
    }

    [Fact]
    public void FramesMoveAndTurnFromTheFirst()
    {
        using var directory = new TempDirectory();
        DemoRun.Of("view", directory.Write("scene.json", Moving), "--out", directory.File("a.html")).AssertDone();
        var page = new PageText(directory.File("a.html"));
        Assert.Equal((3, 3, 5), (page.Count("objects"), page.Count("pairs"), page.Count("frames")));
        float[] poses = page.Column<float>("poses");
        for (int frame = 0; frame < 5; frame++)
        {
            float[] pose = poses[(7 * (3 * frame + 1))..(7 * (3 * frame + 2))];
            (float sine, float cosine) = MathF.SinCos(frame * MathF.PI / 8);
            Assert.Equal(4 - 0.5f * frame, pose[4]);
            Assert.Equal(
                0, (new Vector4(0, 0, sine, cosine) - new Vector4(pose[0], pose[1], pose[2], pose[3])).Length(), 1e-6f);

            // The frame as a separate scene with exactly these poses. The other command answers it.
            string still = FormattableString.Invariant($$$"""
                {"version":1,"objects":[{"shape":{"type":"box","halfExtents":[1,1,1]}},
                  {"shape":{"type":"box","halfExtents":[1,0.5,0.5]},
                    "position":[{{{pose[4]}}},{{{pose[5]}}},{{{pose[6]}}}],
                    "rotation":[{{{pose[0]:R}}},{{{pose[1]:R}}},{{{pose[2]:R}}},{{{pose[3]:R}}}]},
                  {"shape":{"type":"capsule","radius":0.5,"halfHeight":1},"position":[0,3,0]}]}
                """);
            string file = directory.Write("still.json", still);
            AssertFrame(page, frame, CsvRow.Parse(DemoRun.Of("query", file, "--depth").Out));
        }

        Assert.Equal([0, 0, 0, 0, 1], page.Column<int>("overlapping"));
    }

    [Fact]
    public void LargeScenesKeepWhatIntersectsAndTheNearest()
    {
        using var directory = new TempDirectory();
        var random = new Rng(7);
        IEnumerable<string> balls = Enumerable.Range(0, 720).Select(_ => string.Create(
            CultureInfo.InvariantCulture,
            $"{{\"shape\":{{\"type\":\"sphere\",\"radius\":0.3}},"
            + $"\"position\":[{random.Float(0, 10)},{random.Float(0, 10)},{random.Float(0, 10)}]}}"));
        string scene = directory.Write("scene.json", $"{{\"version\":1,\"objects\":[{string.Join(',', balls)}]}}");
        DemoRun run = DemoRun.Of("view", scene, "--out", directory.File("a.html"));
        run.AssertDone();
        Assert.EndsWith(": all that intersect, and the 6 nearest of each object, of 258840 pairs\n", run.Error);
        var page = new PageText(directory.File("a.html"));
        List<CsvRow> rows = CsvRow.Parse(DemoRun.Of("query", scene).Out);
        Assert.Equal(rows.Count, page.Count("pairs"));
        Assert.InRange(page.Count("listed"), 720, 720 * 6);
        Assert.InRange(page.Count("overlapping"), 50, 720);
        Assert.Equal(rows.Count(r => r.Overlap), page.Count("overlapping"));

        HashSet<(int, int)> listed = [.. page.Column<int>("a").Zip(page.Column<int>("b"))];
        Assert.Equal(page.Count("listed"), listed.Count);
        var nearest = new CsvRow?[720];
        foreach (CsvRow row in rows.Where(r => !r.Overlap))
        {
            if (row.Distance < (nearest[row.A]?.Distance ?? float.PositiveInfinity)) nearest[row.A] = row;
            if (row.Distance < (nearest[row.B]?.Distance ?? float.PositiveInfinity)) nearest[row.B] = row;
        }

        Assert.All(nearest, row => Assert.Contains((row!.A, row.B), listed));
    }

    [Theory]
    [InlineData("""{"version":1,"objects":[]}""", 0)]
    [InlineData("""{"version":1,"objects":[{"shape":{"type":"point"}}]}""", 1)]
    [InlineData(
        """
        {"version":1,"objects":[{"shape":{"type":"segment","a":[0,0,0],"b":[1,0,0]}},
          {"shape":{"type":"triangle","a":[0,0,0],"b":[1,0,0],"c":[0,1,0]}}]}
        """,
        2)]
    [InlineData(
        """
        {"version":1,"meshes":{"m":[[1,1,1]]},"objects":[{"shape":{"type":"mesh","mesh":"m"}},
          {"shape":{"type":"sphere","radius":1e30},"position":[0,1e31,0]}]}
        """,
        2)]
    [InlineData(
        """
        {"version":1,"objects":[{"shape":{"type":"cone","radius":1e-20,"halfHeight":1e-20}},
          {"shape":{"type":"ellipsoid","radii":[1e-20,0,0]}}]}
        """,
        2)]
    public void ScenesOfAnySizeAndDimensionAreShown(string scene, int objects)
    {
        using var directory = new TempDirectory();
        DemoRun run = DemoRun.Of(
            "view", directory.Write("scene.json", scene),
            "--out", directory.File("a.html"), "--svg", directory.File("a.svg"));
        run.AssertDone();
        Assert.Equal(objects, new PageText(directory.File("a.html")).Count("objects"));
        PictureTests.AssertSound(File.ReadAllText(directory.File("a.svg")));
    }

    private static void AssertFrame(PageText page, int frame, List<CsvRow> rows)
    {
        int at = frame * rows.Count;
        byte[] status = page.Column<byte>("status");
        ushort[] iterations = page.Column<ushort>("iterations");
        float[] distance = page.Column<float>("distance");
        float[] points = page.Column<float>("pointA"), normals = page.Column<float>("normal");
        int[] a = page.Column<int>("a"), b = page.Column<int>("b");
        for (int i = 0; i < rows.Count; i++)
        {
            int k = at + i;
            Assert.Equal((rows[i].A, rows[i].B), (a[i], b[i]));
            Assert.Equal(rows[i].Status, ((GjkStatus)(status[k] + 1)).ToString());
            Assert.Equal((rows[i].Distance, rows[i].Iterations), (distance[k], iterations[k]));
            Assert.Equal(
                (rows[i].PointA, rows[i].Normal),
                (new Vector3(points.AsSpan(3 * k)), new Vector3(normals.AsSpan(3 * k))));
        }

        Assert.Equal(rows.Count(r => r.Overlap), page.Column<int>("overlapping")[frame]);
    }
}
