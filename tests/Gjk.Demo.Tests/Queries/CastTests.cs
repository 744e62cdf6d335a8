using System.Globalization;

namespace Gjk.Demo.Tests.Queries;

public sealed class CastTests
{
    private const string Moving = """
        {"version":1,"objects":[
          {"shape":{"type":"box","halfExtents":[1,1,1]}},
          {"shape":{"type":"sphere","radius":0.5},"position":[0,4,0],"velocity":[0,-5,0]},
          {"shape":{"type":"sphere","radius":0.5},"position":[4,0,0],"velocity":[0,-5,0]},
          {"shape":{"type":"box","halfExtents":[1,1,1]},"position":[1.5,0,0],"velocity":[9,0,0]}],
         "pairs":[[0,1],[0,2],[0,3],[1,0]]}
        """;

    [Fact]
    public void RowsSayWhenTheObjectsMeet()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Moving);
        DemoRun run = DemoRun.Of("cast", scene);
        run.AssertDone();
        string[][] rows = [.. run.Out.TrimEnd().Split('\n').Select(line => line.Split(','))];
        Assert.Equal("a,b,status,fraction,px,py,pz,nx,ny,nz,iterations", string.Join(',', rows[0]));
        Assert.All(rows, row => Assert.Equal(11, row.Length));
        Assert.Equal(["0", "1", "Hit", "0.5", "0", "1", "0", "0", "1", "0"], rows[1][..10]);
        Assert.Equal(["0", "2", "Miss", "1", "", "", "", "", "", ""], rows[2][..10]);
        Assert.Equal(["0", "3", "OverlappingAtStart", "0"], rows[3][..4]);
        Assert.Equal(["1", "0", "0"], rows[3][7..10]);
        Assert.Equal(["1", "0", "Hit", "0.5"], rows[4][..4]);

        // 0 where the bounding balls alone tell.
        Assert.All(rows.Skip(1), row => Assert.InRange(int.Parse(row[10], CultureInfo.InvariantCulture), 0, 50));

        string file = Path.Combine(directory.Path, "out.csv");
        DemoRun.Of("cast", scene, "--out", file).AssertDone();
        Assert.Equal(run.Out, File.ReadAllText(file));
    }

    /// <summary>What stands on a box may slide and rise, and is stopped when it sinks, with the normal; also while it
    /// turns.</summary>
    [Theory]
    [InlineData("[1,0,0]", "Miss", "1")]
    [InlineData("[0,2,0]", "Miss", "1")]
    [InlineData("[0,0,0]", "Miss", "1")]
    [InlineData("[3,-1,0]", "Hit", "0")]
    public void TouchingStartsFollowTheMotion(string velocity, string status, string fraction)
    {
        using var directory = new TempDirectory();
        foreach (string turn in new[] { "[0,0,0]", "[0,0.5,0]" })
        {
            string motion = $"""
                "position":[0,2,0],"velocity":{velocity},"angularVelocity":{turn}
                """;
            DemoRun run = DemoRun.Of("cast", directory.Write("touching.json", $$$"""
                {"version":1,"objects":[
                  {"shape":{"type":"box","halfExtents":[4,1,4]}},
                  {"shape":{"type":"box","halfExtents":[1,1,1]},{{{motion}}}},
                  {"shape":{"type":"sphere","radius":1},{{{motion}}}},
                  {"shape":{"type":"cylinder","radius":0.5,"halfHeight":1},{{{motion}}}},
                  {"shape":{"type":"ellipsoid","radii":[2,1,1]},{{{motion}}}}],
                 "pairs":[[0,1],[0,2],[0,3],[0,4]]}
                """));
            run.AssertDone();
            foreach (string line in run.Out.TrimEnd().Split('\n').Skip(1))
            {
                string[] row = line.Split(',');
                Assert.Equal([status, fraction], row[2..4]);
                if (status == "Miss") Assert.All(row[4..10], Assert.Empty);
                else Assert.Equal(1, double.Parse(row[8], CultureInfo.InvariantCulture), 1e-6);
            }
        }
    }

    /// <summary>A rod turns by half a turn until its side meets a ball: 2 cos(angle) = 0.1 + 0.5.</summary>
    [Fact]
    public void ObjectsThatTurnMeetToATolerance()
    {
        const string turning = """
            {"version":1,"objects":[
              {"shape":{"type":"box","halfExtents":[2,0.1,0.1]},"angularVelocity":[0,0,3.1415927]},
              {"shape":{"type":"sphere","radius":0.5},"position":[0,2,0]},
              {"shape":{"type":"sphere","radius":0.5},"position":[0,2.7,0],"angularVelocity":[1,0,0]},
              {"shape":{"type":"sphere","radius":0.5},"position":[0,2,0.9],"velocity":[0,0,-1]}],
             "pairs":[[0,1],[0,2],[1,3],[3,1]]}
            """;
        using var directory = new TempDirectory();
        DemoRun run = DemoRun.Of("cast", directory.Write("turning.json", turning));
        run.AssertDone();
        string[][] rows = [.. run.Out.TrimEnd().Split('\n').Select(line => line.Split(','))];
        Assert.Equal(["0", "1", "Hit"], rows[1][..3]);
        Assert.InRange(double.Parse(rows[1][3], CultureInfo.InvariantCulture), 0.40300, 0.40302);
        Assert.Equal(["0", "2", "Miss", "1", "", "", "", "", "", ""], rows[2][..10]);
        Assert.Equal(["1", "3", "OverlappingAtStart", "0"], rows[3][..4]);
        Assert.Equal(["3", "1", "OverlappingAtStart", "0"], rows[4][..4]);
    }

    /// <summary>The pair that <c>fuzz</c> reports, with its motion.</summary>
    [Fact]
    public void ARecordIsCastAsASceneIs()
    {
        const string Record =
            "gjk1 box 1 1 1 @ 0 0 0 1 0 0 0 ~ 0 1 0 0 0 0 point 0.5 @ 0 0 0 1 0 4 0 ~ 0 -4 0 0 0 0";
        DemoRun run = DemoRun.Of("cast", "--record", Record);
        run.AssertDone();
        Assert.StartsWith("0,1,Hit,0.5,0,1.5,0,0,1,0,", run.Out.Split('\n')[1]);
        DemoRun.Of("cast", "--record", Record + " 1").AssertRefused("--record: Word");
        DemoRun turning = DemoRun.Of("cast", "--record", Record[..^5] + "0 1 0");
        turning.AssertDone();
        Assert.StartsWith("0,1,Hit,0.49999", turning.Out.Split('\n')[1]);
        DemoRun.Of("cast", "scene.json", "--record", Record).AssertRefused("exclude each other");
    }

    [Fact]
    public void AMissingSceneIsRefused()
    {
        DemoRun.Of("cast").AssertRefused("SCENE.json, --builtin or --record");
        DemoRun.Of("cast", "no-such-file.json").AssertRefused("no-such-file.json");
    }
}
