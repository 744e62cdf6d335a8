using System.Diagnostics;

namespace Gjk.Demo.Tests.Output;

/// <summary>No output may replace the input or another output, whatever name leads to it.</summary>
public sealed class SameFileTests
{
    private const string Scene = """{"version":1,"objects":[{"shape":{"type":"point"}},{"shape":{"type":"point"}}]}""";

    public static TheoryData<string, string> CommandsAndNames()
    {
        var data = new TheoryData<string, string>();
        string[] commands =
            ["query SCENE --out", "view SCENE --out", "view SCENE --svg", "trace SCENE --pair 0,1 --out"];
        string[] names = ["symbolic", "chain", "spelling", "directory", "input"];
        foreach (string command in commands)
        {
            foreach (string name in names) data.Add(command, name);
        }

        return data;
    }

    [UnixTheory]
    [MemberData(nameof(CommandsAndNames))]
    public void TheInputCannotBeNamedAsAnOutput(string command, string way)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene), other = OtherName(directory, scene, way);
        (string input, string output) = way == "input" ? (other, scene) : (scene, other);
        Dictionary<string, string> before = directory.Contents();

        DemoRun run = DemoRun.Of([.. command.Replace("SCENE", input).Split(' '), output]);
        run.AssertRefused(output, "would overwrite the scene");
        Assert.Equal(before, directory.Contents());
        Assert.Equal(way is "symbolic" or "chain" or "input", new FileInfo(other).LinkTarget is not null);
    }

    [UnixTheory]
    [InlineData("symbolic")]
    [InlineData("chain")]
    [InlineData("spelling")]
    [InlineData("directory")]
    public void TwoOutputsCannotBeOneFile(string way)
    {
        using var directory = new TempDirectory();
        string old = directory.Write("old.html", "old"), other = OtherName(directory, old, way);
        Dictionary<string, string> before = directory.Contents();
        AssertTwoRefused(old, other);
        AssertTwoRefused(other, old);
        Assert.Equal(before, directory.Contents());
    }

    [UnixTheory]
    [InlineData("symbolic")]
    [InlineData("spelling")]
    [InlineData("directory")]
    public void TwoOutputsCannotBeOneNewFile(string way)
    {
        using var directory = new TempDirectory();
        string missing = directory.File("new.html"), other = OtherName(directory, missing, way);
        string[] before = directory.Files;
        AssertTwoRefused(missing, other);
        Assert.Equal(before.Order(), directory.Files.Order());
    }

    [UnixFact]
    public void TheRecordOnStandardInputIsNotOverwritten()
    {
        const string text = "gjk1 point 1 @ 0 0 0 1 0 0 0 point 0.5 @ 0 0 0 1 3 0 0";
        using var directory = new TempDirectory();
        string record = directory.Write("record.txt", text);
        DemoRun run = DemoProcess.Shell("demo query --record - --out \"$1\" < \"$1\"", record);
        run.AssertRefused(record, "would overwrite");
        Assert.Equal(text, File.ReadAllText(record));
    }

    [UnixFact]
    public void TheTableOnStandardOutputIsNotReplaced()
    {
        using var directory = new TempDirectory();
        string table = directory.Write("table.txt", "old\n");
        DemoRun run = DemoProcess.Shell("demo replay --frames 1 --json \"$1\" >> \"$1\"", table);
        run.AssertRefused(table, "standard output");
        Assert.Equal("old\n", File.ReadAllText(table));
    }

    /// <summary>The new file takes the place of one name. The other name keeps the scene.</summary>
    [UnixFact]
    public void AHardLinkToTheInputLeavesTheInput()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene), other = directory.File("other");
        using (var link = Process.Start("ln", [scene, other])) link.WaitForExit();
        DemoRun.Of("query", scene, "--out", other).AssertDone();
        Assert.StartsWith(CsvRow.Header, File.ReadAllText(other));
        Assert.Equal(Scene, File.ReadAllText(scene));
    }

    /// <summary>A copy is a different file. A terminal and /dev/null are not files, so they may be read and written at
    /// the same time.</summary>
    [UnixFact]
    public void OtherFilesAreAllowed()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene), copy = directory.File("copy.json");
        File.Copy(scene, copy);
        File.SetLastWriteTimeUtc(copy, File.GetLastWriteTimeUtc(scene));
        DemoRun.Of("query", scene, "--out", copy).AssertDone();
        Assert.StartsWith(CsvRow.Header, File.ReadAllText(copy));
        Assert.Equal(Scene, File.ReadAllText(scene));
        DemoRun nothing = DemoProcess.Shell("demo query --record - --out /dev/null < /dev/null");
        nothing.AssertRefused("--record: The record ends");
    }

    private static void AssertTwoRefused(string page, string picture)
    {
        DemoRun run = DemoRun.Of("view", "--builtin", "cubes", "--out", page, "--svg", picture);
        run.AssertRefused(picture, "would overwrite what --out writes");
    }

    /// <summary>Another name for a file. The file need not exist.</summary>
    private static string OtherName(TempDirectory directory, string file, string way)
    {
        string other = directory.File("other");
        switch (way)
        {
            case "symbolic" or "input":
                File.CreateSymbolicLink(other, Path.GetFileName(file));
                return other;
            case "chain":
                File.CreateSymbolicLink(directory.File("middle"), file);
                File.CreateSymbolicLink(other, "middle");
                return other;
            case "spelling":
                string name = Path.GetFileName(directory.Path);
                return Path.Combine(directory.Path, ".", "..", name, Path.GetFileName(file));
            default:
                Directory.CreateSymbolicLink(other, directory.Path);
                return Path.Combine(other, Path.GetFileName(file));
        }
    }
}
