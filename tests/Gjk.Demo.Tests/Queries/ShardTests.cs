using Gjk.Demo.Scenes;
using Gjk.Demo.Tests.Scenes;

namespace Gjk.Demo.Tests.Queries;

/// <summary>Parts of a scene's pairs, which many machines answer.</summary>
public sealed class ShardTests
{
    [Theory]
    [InlineData("query", "", 1)]
    [InlineData("query", "", 16)]
    [InlineData("query", ",\"pairs\":[[0,1],[1,0],[2,5],[0,1],[3,4]]", 3)]
    [InlineData("query", ",\"pairs\":[[0,1]]", 4)]
    [InlineData("query", ",\"pairs\":[]", 2)]
    [InlineData("cast", "", 7)]
    public void PartsInOrderAreTheBytesOfOneRun(string command, string pairs, int parts)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", SceneTests.Points(12, pairs));
        string[] each = [.. Enumerable.Range(1, parts).Select(k => Out(command, scene, "--shard", $"{k}/{parts}"))];
        Assert.Equal(Out(command, scene), string.Concat(each));
        Assert.InRange(each.Max(Rows) - each.Min(Rows), 0, 1);
    }

    /// <summary>A list of all pairs is cut at any place, without a walk to it.</summary>
    [Theory]
    [InlineData(0, 5)]
    [InlineData(1, 3)]
    [InlineData(2, 1)]
    [InlineData(9, 36)]
    [InlineData(9, 7)]
    public void CutsOfAllPairsAreWhole(int objects, int parts)
    {
        List<(int, int)> expected = [], found = [];
        foreach ((int, int) pair in ScenePairs.All(objects)) expected.Add(pair);
        for (int k = 1; k <= parts; k++)
            foreach ((int, int) pair in ScenePairs.All(objects).Shard(k, parts)) found.Add(pair);
        Assert.Equal(expected, found);
    }

    [Fact]
    public void TheLastPairsOfAHugeSceneAreFoundAtOnce()
    {
        const int objects = 2_000_000_000;
        var last = new List<(int, int)>();
        foreach ((int, int) pair in ScenePairs.All(objects).Shard(1_000_000, 1_000_000))
        {
            last.Add(pair);
            if (last.Count == 3) break;
        }

        Assert.Equal(last[0].Item2 + 1, last[1].Item2);
        Assert.InRange(last[0].Item1, objects * 0.998, objects);
        Assert.True(last[0].Item2 > last[0].Item1);
    }

    [Theory]
    [InlineData("0/4")]
    [InlineData("5/4")]
    [InlineData("1")]
    [InlineData("1/1000001")]
    [InlineData("a/b")]
    public void OtherPartsAreRefused(string part) =>
        DemoRun.Of("query", "a.json", "--shard", part).AssertRefused($"--shard {part}: must be K/N");

    private static int Rows(string csv) => csv.Split('\n').Count(line => line.Length > 0 && line[0] != 'a');

    private static string Out(params string[] call)
    {
        DemoRun run = DemoRun.Of(call);
        run.AssertDone();
        return run.Out;
    }
}
