namespace Gjk.Demo.Tests;

/// <summary>Arguments. Help ends successfully. Every wrong argument gives one line and exit code 2.</summary>
public sealed class UsageTests
{
    [Theory]
    [InlineData("--help", "replay", "query", "time")]
    [InlineData("replay --help", "--seconds", "--frames", "--json")]
    [InlineData("cast --help", "--check", "proved-at-most", "turns")]
    [InlineData("query --help", "SCENE.json", "--out", "--max-distance")]
    [InlineData("import --help", ".unity", "--project", "left-handed")]
    [InlineData("time --help", "SCENE.json", "--seconds", "")]
    [InlineData("view --help", "SCENE.json", "--out", "--svg")]
    [InlineData("trace --help", "SCENE.json", "--pair", "--out")]
    [InlineData("cast --help", "--builtin", "--mesh", "--names")]
    [InlineData("judge --help", "RESULTS.csv", "EXPECTED.csv", "SCENE.json")]
    [InlineData("time --help", "--builtin", "512 MiB", "386 distinct corners")]
    [InlineData("example --help", "--out", "every convex shape", "gjk-demo query")]
    public void HelpSaysWhatThereIs(string args, string one, string two, string three)
    {
        DemoRun run = DemoRun.Of(args.Split(' '));
        run.AssertDone();
        foreach (string word in new[] { one, two, three }) Assert.Contains(word, run.Out);
    }

    [Fact]
    public void VersionIsPrinted()
    {
        DemoRun run = DemoProcess.Run("--version");
        run.AssertDone();
        Assert.Matches(@"^\d+\.\d+\.\d+", run.Out);
    }

    [Theory]
    [InlineData("frobnicate", "frobnicate")]
    [InlineData("quary", "quary: there is no such command: did you mean query?")]
    [InlineData("cats a.json", "cats: there is no such command: did you mean cast?")]
    [InlineData("frobnicate a.json", "frobnicate: there is no such command\n")]
    [InlineData("query a.json --dept", "--dept: there is no such option: did you mean --depth?; a file")]
    [InlineData("query", "SCENE.json")]
    [InlineData("query one.json two.json", "two.json")]
    [InlineData("query --nope", "--nope: there is no such option")]
    [InlineData("query -n a.json", "-n: there is no such option")]
    [InlineData("query a.json --out --nope", "--nope: there is no such option")]
    [InlineData("query a.json --out --max-distance 1", "--out: its value is missing before --max-distance")]
    [InlineData("query -- --nope", "--nope: cannot be read")]
    [InlineData("query a.json --max-distance 1e400", "--max-distance 1e400")]
    [InlineData("query a.json --out", "--out")]
    [InlineData("query a.json --max-distance -1", "--max-distance -1")]
    [InlineData("query a.json --max-distance far", "--max-distance far")]
    [InlineData("query a.json --max-distance NaN", "--max-distance NaN")]
    [InlineData("query a.json --max-distance 1e39", "--max-distance 1e39")]
    [InlineData("query a.json --out a.json", "overwrite")]
    [InlineData("time", "SCENE.json")]
    [InlineData("time a.json --seconds 0", "--seconds 0")]
    [InlineData("--frames 0", "--frames 0")]
    [InlineData("--frames 1.5", "--frames 1.5")]
    [InlineData("replay --seconds soon", "--seconds soon")]
    [InlineData("replay --frames 2 --seconds 1", "exclude")]
    [InlineData("replay extra", "extra")]
    [InlineData("@file", "@file")]
    [InlineData("query a.json --builtin cubes", "--builtin and SCENE.json exclude")]
    [InlineData("query --builtin cubes --record x", "--record and --builtin exclude")]
    [InlineData("query --builtin teapots", "--builtin teapots: must be cubes or spheres")]
    [InlineData("cast", "SCENE.json, --builtin or --record is needed")]
    [InlineData("judge", "RESULTS.csv, SCENE.json and EXPECTED.csv are needed")]
    [InlineData("trace", "--pair is needed. --out is needed")]
    [InlineData("replay --json", "--json: its value is missing")]
    [InlineData("time a.json --builtin cubes", "--builtin and SCENE.json exclude")]
    [InlineData("time - -", "standard input can be read only once")]
    [InlineData("replay --mesh round", "--mesh round: must be even or unity")]
    [InlineData("query --builtin cubes --mesh unity", "--mesh is for --builtin spheres")]
    [InlineData("time a.json --mesh unity", "--mesh is for --builtin spheres")]
    public void WrongArgumentsAreOneLine(string args, string part) =>
        DemoRun.Of(args.Split(' ')).AssertRefused(part);

    [Fact]
    public void FilesThatCannotBeReadAreNamed()
    {
        using var directory = new TempDirectory();
        DemoRun.Of("query", directory.File("none.json"))
            .AssertRefused(directory.File("none.json"), "no such file");
        DemoRun.Of("query", directory.Path).AssertRefused(directory.Path, "cannot be read");
        DemoRun.Of("time", directory.File("none.json")).AssertRefused(directory.File("none.json"));
        DemoRun.Of("query", "").AssertRefused("cannot be read");
    }

    [Fact]
    public void FilesThatCannotBeWrittenAreRefusedBeforeTheWork()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", """{"version":1,"objects":[]}""");
        string nowhere = Path.Combine(directory.Path, "nowhere", "out");
        DemoRun.Of("query", scene, "--out", nowhere).AssertRefused(nowhere, "no such directory");
        DemoRun.Of("query", scene, "--out", directory.Path).AssertRefused(directory.Path, "directory");
        DemoRun.Of("--frames", "1", "--json", nowhere).AssertRefused(nowhere, "no such directory");
        Assert.Equal([scene], directory.Files);
    }
}
