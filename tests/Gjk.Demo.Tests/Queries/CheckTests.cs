using Gjk.Demo.Queries;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.Tests.Queries;

/// <summary>The column that <c>--check</c> adds.</summary>
public sealed class CheckTests
{
    private const string Objects = """
        {"version":1,"objects":[
          {"name":"box","shape":{"type":"box","halfExtents":[1,1,1]}},
          {"name":"ball","shape":{"type":"sphere","radius":0.5},"position":[0,4,0],"velocity":[0,-5,0]},
          {"name":"cone","shape":{"type":"cone","radius":1,"halfHeight":1},"position":[0.5,1.5,0.2]},
          {"name":"wheel","shape":{"type":"cylinder","radius":1,"halfHeight":0.1},"position":[3,3,3],
           "angularVelocity":[0,0,1]}],
         "pairs":[[0,1],[0,2],[1,2],[0,3]]}
        """;

    [Fact]
    public void EveryDistanceHasAVerdict() =>
        Assert.Equal(["check", "proved", "proved", "proved", "proved"], Column("query", "--check"));

    [Fact]
    public void ADepthIsProvedAtMost() => Assert.Equal(
        ["check", "proved", "proved-at-most", "proved", "proved"], Column("query", "--depth", "--check"));

    [Fact]
    public void PairsBeyondALargestDistanceAreChecked() => Assert.Equal(
        ["check", "proved", "proved", "proved", "proved"], Column("query", "--max-distance", "0.5", "--check"));

    [Fact]
    public void APathThatTurnsIsOpen() =>
        Assert.Equal(["check", "proved", "proved-at-most", "proved", "open"], Column("cast", "--check"));

    [Fact]
    public void ItIsTheLastColumn()
    {
        string[] rows = Rows("query", "--names", "--check");
        Assert.EndsWith(",iterations,a_name,b_name,check", rows[0]);
        Assert.EndsWith(",box,ball,proved", rows[1]);
    }

    [Fact]
    public void ARecordIsCheckedAsASceneIs()
    {
        DemoRun run = DemoRun.Of(
            "query", "--check", "--record", "gjk1 box 1 1 1 @ 0 0 0 1 0 0 0 point 0.5 @ 0 0 0 1 0 4 0");
        run.AssertDone();
        Assert.EndsWith(",proved\n", run.Out);
    }

    /// <summary>No query gives a wrong answer to show it by, so the table is told one.</summary>
    [Fact]
    public void WhatIsRefutedEndsWithExitCodeOne()
    {
        using var directory = new TempDirectory();
        string file = Path.Combine(directory.Path, "out.csv");
        var cube = new SceneObject(null, ConvexShape.Point(), RigidPose.Identity, default, default);
        var table = new PairTable(
            new Scene("two", [cube, cube], ScenePairs.All(2), 1), file, hasNames: false, isChecked: true);
        int code = table.Write(
            CsvWriter.Distances, (rows, a, b) => rows.Write(a, b, AnyAnswer(), CheckStatus.Refuted), default);
        Assert.Equal(1, code);
        Assert.EndsWith(",refuted\n", File.ReadAllText(file));
    }

    private static DistanceResult AnyAnswer() => ConvexQuery.Distance(
        default(PointShape), RigidPose.Identity, default(PointShape), RigidPose.Identity);

    private static string[] Column(params string[] args) => [.. Rows(args).Select(r => r.Split(',')[^1])];

    private static string[] Rows(params string[] args)
    {
        using var directory = new TempDirectory();
        DemoRun run = DemoRun.Of([args[0], directory.Write("scene.json", Objects), .. args[1..]]);
        run.AssertDone();
        return run.Out.TrimEnd('\n').Split('\n');
    }
}
