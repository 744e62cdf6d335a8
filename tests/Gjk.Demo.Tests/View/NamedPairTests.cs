namespace Gjk.Demo.Tests.View;

/// <summary><c>trace</c> takes names and indices of objects, and refuses what could mean several.</summary>
public sealed class NamedPairTests
{
    private const string Scene = """
        {"version":1,"objects":[
          {"name":"crate","shape":{"type":"box","halfExtents":[1,1,1]}},
          {"name":"ball","shape":{"type":"sphere","radius":1},"position":[0.5,0.5,4]},
          {"name":"a,b","shape":{"type":"sphere","radius":1},"position":[9,0,4]},
          {"name":"twin","shape":{"type":"point"}},{"name":"twin","shape":{"type":"point"}},
          {"name":"a","shape":{"type":"point"}},{"name":"0","shape":{"type":"point"}},
          {"name":"b,ball","shape":{"type":"point"}},{"shape":{"type":"point"}}]}
        """;

    [Theory]
    [InlineData("crate,ball", 0, 1)]
    [InlineData("ball,crate", 1, 0)]
    [InlineData("0,1", 0, 1)]
    [InlineData("crate,1", 0, 1)]
    [InlineData("8,crate", 8, 0)]
    [InlineData("crate,0", 0, 6)]
    [InlineData("crate,a,b", 0, 2)]
    [InlineData("a,crate", 5, 0)]
    public void APairIsFound(string pair, int a, int b)
    {
        using var directory = new TempDirectory();
        string page = directory.File("t.html");
        DemoRun.Of("trace", directory.Write("s.json", Scene), "--pair", pair, "--out", page).AssertDone();
        var text = new PageText(page);
        Assert.Equal((a, b), ((int)text.Count("a"), (int)text.Count("b")));
    }

    [Theory]
    [InlineData("crate,bal", "there is no object \"bal\"")]
    [InlineData("cra\u001bte,ball", "there is no object \"cra\\u001bte\"")]
    [InlineData("crate,twin", "2 objects have the name \"twin\", such as 3 and 4; use their indices")]
    [InlineData("a,b,ball", "the names fit several pairs; use the indices")]
    [InlineData("crate,crate", "must be two different objects")]
    [InlineData("0,9", "the scene has 9 objects, counted from 0")]
    [InlineData("crate,9", "there is no object \"9\"")]
    [InlineData("0,1,2", "there is no object")]
    [InlineData("-1,2", "there is no object \"-1\"")]
    [InlineData("1.5,2", "there is no object \"1.5\"")]
    [InlineData("0,99999999999", "there is no object \"99999999999\"")]
    public void WhatFitsNoPairOrSeveralIsRefused(string pair, string part)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("s.json", Scene), page = directory.File("t.html");
        DemoRun.Of("trace", scene, "--pair=" + pair, "--out", page).AssertRefused(scene, "--pair", part);
        Assert.False(File.Exists(page));
    }

    [Fact]
    public void AShapeThatCannotBeDrawnIsRefused()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("s.json", """
            {"version":1,"objects":[{"shape":{"type":"point"}},
              {"shape":{"type":"sphere","radius":3e38},"scale":2},{"shape":{"type":"point"},"position":[3e38,0,0]}]}
            """);
        string page = directory.File("t.html");
        DemoRun.Of("trace", scene, "--pair", "0,1", "--out", page).AssertRefused(scene, "$.objects[1]");
        DemoRun.Of("trace", scene, "--pair", "0,2", "--out", page).AssertDone();
    }
}
