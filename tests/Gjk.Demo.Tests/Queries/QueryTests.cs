using Gjk.Demo.Tests.Scenes;

namespace Gjk.Demo.Tests.Queries;

public sealed class QueryTests
{
    private const string TwoSpheresAndABox = """
        {"version":1,"objects":[
          {"shape":{"type":"sphere","radius":0.5},"position":[0,0,0]},
          {"shape":{"type":"sphere","radius":0.5},"position":[0,3,4]},
          {"shape":{"type":"box","halfExtents":[1,1,1]},"position":[1.25,0,0]}]}
        """;

    [Fact]
    public void RowsSayWhatWasFound()
    {
        using var directory = new TempDirectory();
        DemoRun run = DemoRun.Of("query", directory.Write("scene.json", TwoSpheresAndABox));
        run.AssertDone();
        List<CsvRow> rows = CsvRow.Parse(run.Out);
        Assert.Equal(3, rows.Count);

        Assert.Equal(("Separated", false, 4f), (rows[0].Status, rows[0].Overlap, rows[0].Distance));
        Assert.Equal(new(0, 0.6f, 0.8f), rows[0].Normal);
        Assert.Equal(new(0, 2.7f, 3.6f), rows[0].PointB);

        Assert.Equal(
            ("Overlapping", true, 0f, 0f), (rows[1].Status, rows[1].Overlap, rows[1].Distance, rows[1].LowerBound));
        Assert.Equal(rows[1].PointA, rows[1].PointB);
        Assert.Equal(default, rows[1].Normal);
    }

    [Fact]
    public void WithDepthOverlappingRowsSayHowDeep()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", TwoSpheresAndABox);
        DemoRun run = DemoRun.Of("query", scene, "--depth");
        run.AssertDone();
        List<CsvRow> rows = CsvRow.Parse(run.Out);
        Assert.Equal(("Separated", false, 4f), (rows[0].Status, rows[0].Overlap, rows[0].Distance));
        Assert.Equal(("Overlapping", true, -0.25f), (rows[1].Status, rows[1].Overlap, rows[1].Distance));
        Assert.Equal(new(1, 0, 0), rows[1].Normal);
        Assert.Equal((0.5f, 0.25f), (rows[1].PointA.X, rows[1].PointB.X));
        Assert.InRange(rows[1].LowerBound, -0.2500001f, -0.25f);

        run = DemoRun.Of("query", scene, "--depth", "--max-distance", "3.5");
        run.AssertDone();
        rows = CsvRow.Parse(run.Out);
        Assert.Equal(("BeyondMaxDistance", -0.25f), (rows[0].Status, rows[1].Distance));
    }

    [Fact]
    public void PairsBeyondTheMaximumSayOnlyThat()
    {
        using var directory = new TempDirectory();
        DemoRun run = DemoRun.Of(
            "query", directory.Write("scene.json", TwoSpheresAndABox), "--max-distance", "3.5");
        run.AssertDone();
        CsvRow row = CsvRow.Parse(run.Out)[0];
        Assert.Equal(("BeyondMaxDistance", false), (row.Status, row.Overlap));
        Assert.Equal(float.NaN, row.Distance);
        Assert.InRange(row.LowerBound, 3.5f, 4f);
        Assert.Matches("^0,1,BeyondMaxDistance,false,,[0-9.]+,,,,,,,[0-9.]", run.Out.Split('\n')[1]);
        Assert.DoesNotContain("Infinity", run.Out);
        Assert.DoesNotContain("NaN", run.Out);
    }

    /// <summary>The help shows this default, so it must be accepted as a value.</summary>
    [Fact]
    public void AnInfiniteMaximumIsNone()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", TwoSpheresAndABox);
        DemoRun run = DemoRun.Of("query", scene, "--max-distance", "Infinity");
        run.AssertDone();
        Assert.Equal(DemoRun.Of("query", scene).Out, run.Out);
        Assert.Contains("[default: Infinity]", DemoRun.Of("query", "--help").Out);
    }

    [Fact]
    public void AFileGetsTheSameAndReplacesWhatWasThere()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", TwoSpheresAndABox), target = directory.Write("out.csv", "old");
        string printed = DemoRun.Of("query", scene).Out;
        DemoRun run = DemoRun.Of("query", scene, "--out", target);
        run.AssertDone();
        Assert.Equal("", run.Out);
        Assert.Equal(printed, File.ReadAllText(target));
        Assert.Equal(2, directory.Files.Length);
    }

    [UnixFact]
    public void ALinkIsFollowedAndStays()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", TwoSpheresAndABox), link = directory.File("link.csv");
        File.CreateSymbolicLink(link, directory.File("target.csv"));
        DemoRun.Of("query", scene, "--out", link).AssertDone();
        Assert.NotNull(new FileInfo(link).LinkTarget);
        Assert.StartsWith(CsvRow.Header, File.ReadAllText(directory.File("target.csv")));
    }

    [UnixFact]
    public void ADeviceIsWrittenToAndNotReplaced()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", TwoSpheresAndABox);
        DemoRun.Of("query", scene, "--out", "/dev/null").AssertDone();
        Assert.Equal(0, new FileInfo("/dev/null").Length);
        if (File.Exists("/dev/full"))
            DemoRun.Of("query", scene, "--out", "/dev/full").AssertRefused("/dev/full", "cannot be written");
    }

    /// <summary>The rows are about 60 MB of text. They would not fit into the heap that the process is given.</summary>
    [Fact]
    public void AMillionPairsStreamThroughASmallHeap()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", SceneTests.Points(1415, pairs: ""));
        string target = directory.File("out.csv");
        var smallHeap = new Dictionary<string, string> { ["DOTNET_GCHeapHardLimit"] = "0x1400000" };
        DemoProcess.RunWith(smallHeap, "query", scene, "--out", target).AssertDone();
        Assert.True(new FileInfo(target).Length > 50_000_000);
        int lines = 0;
        foreach (string _ in File.ReadLines(target)) lines++;
        Assert.Equal(1 + 1415 * 1414 / 2, lines);
    }

    [Fact]
    public void ALongListOfPairsIsRead()
    {
        using var directory = new TempDirectory();
        var pairs = new System.Text.StringBuilder();
        for (int i = 0; i < 1_000_000; i++) pairs.Append(i == 0 ? "[0,1]" : i % 2 == 0 ? ",[0,1]" : ",[1,0]");
        string scene = directory.Write("scene.json", SceneTests.Points(2, $""","pairs":[{pairs}]"""));
        DemoRun run = DemoRun.Of("query", scene, "--out", directory.File("out.csv"));
        run.AssertDone();
        int lines = 0;
        foreach (string _ in File.ReadLines(directory.File("out.csv"))) lines++;
        Assert.Equal(1_000_001, lines);
    }

    [UnixFact]
    public void CtrlCLeavesNoFile()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", SceneTests.Points(20_000, pairs: ""));
        string target = directory.File("out.csv");
        using RunningDemo demo = RunningDemo.Start("query", scene, "--out", target);
        demo.WaitUntil(_ => Array.Exists(
            directory.Files, f => f.EndsWith(".tmp", StringComparison.Ordinal) && new FileInfo(f).Length > 1_000_000));
        demo.Interrupt();
        DemoRun run = demo.Wait();
        Assert.Equal((130, "", ""), (run.ExitCode, run.Out, run.Error));
        Assert.Equal([scene], directory.Files);
    }

    [UnixFact]
    public void CtrlCEndsTheStream()
    {
        using var directory = new TempDirectory();
        using RunningDemo demo = RunningDemo.Start(
            "query", directory.Write("scene.json", SceneTests.Points(20_000, pairs: "")));
        demo.WaitUntil(text => text.Length > 100_000);
        demo.Interrupt();
        DemoRun run = demo.Wait();
        Assert.Equal((130, ""), (run.ExitCode, run.Error));
    }
}
