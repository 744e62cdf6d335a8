namespace Gjk.Demo.Tests.Queries;

/// <summary>The names of objects in the CSV, and what is said about written files.</summary>
public sealed class NamesTests
{
    private const string Scene = """
        {"version":1,"objects":[
          {"name":"say \"hi\", crate","shape":{"type":"box","halfExtents":[1,1,1]}},
          {"name":"b\u001ball\nü","shape":{"type":"sphere","radius":1},"position":[0.5,0.5,4]},
          {"shape":{"type":"point"},"position":[9,0,0]}]}
        """;

    [Theory]
    [InlineData("query", 16)]
    [InlineData("cast", 11)]
    public void NamesFollowTheOtherColumns(string command, int columns)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("s.json", Scene);
        DemoRun plain = DemoRun.Of(command, scene), named = DemoRun.Of(command, scene, "--names");
        plain.AssertDone();
        named.AssertDone();
        Assert.Equal("", named.Error);
        string[] before = plain.Out.Split('\n'), rows = named.Out.Split('\n');
        Assert.Equal(columns, before[0].Split(',').Length);
        const string crate = "\"say \"\"hi\"\", crate\"", ball = """b\u001ball\u000aü""";
        string[] names = [",a_name,b_name", $",{crate},{ball}", $",{crate},", $",{ball},", ""];
        Assert.Equal(before.Zip(names, (row, name) => row + name), rows);
    }

    [Fact]
    public void ALongNameIsWrittenWhole()
    {
        using var directory = new TempDirectory();
        string name = string.Concat(Enumerable.Repeat("ü€x", 50_000));
        string scene = directory.Write("s.json", $$"""
            {"version":1,"objects":[{"name":"{{name}}","shape":{"type":"point"} },{"shape":{"type":"point"} }]}
            """);
        DemoRun run = DemoRun.Of("query", scene, "--names");
        run.AssertDone();
        Assert.EndsWith($",{name},\n", run.Out);
    }

    [Fact]
    public void RepeatedNamesAreWarnedOfWhereNamesAreUsed()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("s.json", """
            {"version":1,"objects":[{"name":"a","shape":{"type":"point"}},{"name":"b","shape":{"type":"point"}},
              {"name":"b","shape":{"type":"point"}},{"name":"a","shape":{"type":"point"}},{"shape":{"type":"point"}}]}
            """);
        DemoRun named = DemoRun.Of("query", scene, "--names");
        Assert.Equal(0, named.ExitCode);
        Assert.Equal($"gjk-demo: {scene}: warning: 2 names appear again: \"b\" for the objects 1 and 2\n", named.Error);
        Assert.Equal("", DemoRun.Of("query", scene).Error);
        Assert.Equal("", DemoRun.Of("query", "--builtin", "cubes", "--names").Error);
    }

    [Fact]
    public void NoNumberIsMinusZero()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("s.json", Scene), json = directory.File("r.json");
        string[] outputs =
        [
            DemoRun.Of("query", scene).Out, DemoRun.Of("query", scene, "--depth").Out,
            DemoRun.Of("query", "--builtin", "cubes", "--depth").Out, DemoRun.Of("cast", scene).Out,
        ];
        Assert.All(outputs, csv => Assert.DoesNotContain("-0", csv.Split(',', '\n')));
        DemoRun.Of("--frames", "1", "--json", json).AssertDone();
        Assert.DoesNotMatch(":-0[,}]", File.ReadAllText(json));
    }

    [Theory]
    [InlineData("query s.json --out", "3 pairs")]
    [InlineData("cast s.json --out", "3 pairs")]
    [InlineData("query --record - --out", "")]
    [InlineData("view s.json --out", "3 pairs")]
    [InlineData("view s.json --svg", "3 objects")]
    [InlineData("trace s.json --pair 1,2 --out", "1 step")]
    [InlineData("import one.obj --out", "1 object")]
    [InlineData("replay --frames 1 --json", "2 scenes")]
    public void WhatWasWrittenIsSaidOnStandardError(string call, string what)
    {
        using var directory = new TempDirectory();
        directory.Write("s.json", Scene);
        directory.Write("one.obj", "v 0 0 0\n");
        string target = directory.File("target");
        string[] args = [.. call.Split(' ').Select(a => a is "s.json" or "one.obj" ? directory.File(a) : a), target];
        DemoRun run = DemoRun.Of(args);
        if (what.Length == 0)
        {
            run.AssertRefused("--record");
            Assert.False(File.Exists(target));
            return;
        }

        run.AssertDone();
        Assert.Equal($"gjk-demo: wrote {what} to {target}\n", run.Error);
        Assert.True(File.Exists(target));
    }
}
