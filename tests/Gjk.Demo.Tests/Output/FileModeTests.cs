using System.Runtime.Versioning;

namespace Gjk.Demo.Tests.Output;

/// <summary>Permissions of the written files.</summary>
[UnsupportedOSPlatform("windows")]
public sealed class FileModeTests
{
    private const string Scene = """{"version":1,"objects":[{"shape":{"type":"point"}},{"shape":{"type":"point"}}]}""";

    [UnixTheory]
    [InlineData("600")]
    [InlineData("640")]
    [InlineData("666")]
    [InlineData("755")]
    public void AReplacedFileKeepsItsPermissions(string octal)
    {
        using var directory = new TempDirectory();
        var mode = (UnixFileMode)Convert.ToInt32(octal, 8);
        string scene = directory.Write("scene.json", Scene), target = directory.Write("target", "old");
        string link = directory.File("link");
        File.CreateSymbolicLink(link, target);
        File.SetUnixFileMode(target, mode);
        string[][] calls =
        [
            ["query", scene, "--out", link],
            ["view", scene, "--out", target],
            ["view", scene, "--svg", target],
            ["trace", scene, "--pair", "0,1", "--out", target],
            ["replay", scene, "--frames", "1", "--json", target],
        ];
        foreach (string[] call in calls)
        {
            File.WriteAllText(target, "old");
            DemoRun.Of(call).AssertDone();
            Assert.NotEqual("old", File.ReadAllText(target));
            Assert.Equal(mode, File.GetUnixFileMode(target));
        }
    }

    /// <summary>The new file belongs to the user who runs the command, so a program's right to act as its owner
    /// ends.</summary>
    [UnixFact]
    public void AReplacedFileLosesItsSpecialBits()
    {
        const UnixFileMode mode = UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute;
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene), target = directory.Write("target", "old");
        File.SetUnixFileMode(target, mode | UnixFileMode.SetUser | UnixFileMode.SetGroup);
        DemoRun.Of("query", scene, "--out", target).AssertDone();
        Assert.Equal(mode, File.GetUnixFileMode(target));
    }

    [UnixTheory]
    [InlineData("022", "644")]
    [InlineData("027", "640")]
    [InlineData("077", "600")]
    public void ANewFileGetsTheUsualPermissions(string mask, string octal)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene), target = directory.File("target");
        DemoProcess.Shell($"umask {mask}; demo query \"$1\" --out \"$2\"", scene, target).AssertDone();
        Assert.Equal((UnixFileMode)Convert.ToInt32(octal, 8), File.GetUnixFileMode(target));
    }

    /// <summary>Root, too, is refused a file that nobody may write.</summary>
    [UnixFact]
    public void AReadOnlyFileIsRefused()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene), target = directory.Write("target", "old");
        File.SetUnixFileMode(target, UnixFileMode.UserRead | UnixFileMode.GroupRead);
        Dictionary<string, string> before = directory.Contents();
        DemoRun.Of("query", scene, "--out", target).AssertRefused(target, "it is read-only");
        DemoRun.Of("view", scene, "--svg", target).AssertRefused(target, "it is read-only");
        DemoRun.Of("replay", "--seconds", "60", "--json", target).AssertRefused(target, "it is read-only");
        Assert.Equal(before, directory.Contents());
    }

    [UserFact]
    public void AReadOnlyDirectoryIsRefused()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene), inner = directory.File("inner");
        string target = Path.Combine(inner, "target");
        Directory.CreateDirectory(inner);
        DemoRun Run(string call) => DemoProcess.ShellAsUser(
            $"chmod 755 \"$1\"; chmod 555 \"$2\"; demo {call} \"$2/target\"", directory.Path, inner);
        Run("query \"$1/scene.json\" --out").AssertRefused(target, "access is denied");
        Run("replay --seconds 60 --json").AssertRefused(target, "access is denied");
        Assert.Empty(Directory.GetFileSystemEntries(inner));
        Assert.Equal([inner, scene], directory.Files.Order());
    }

    /// <summary>A user who may write to a directory may rename over any file in it. But a file that the user may not
    /// write stays.</summary>
    [RootFact]
    public void SomebodyElsesFileIsRefused()
    {
        using var directory = new TempDirectory();
        string target = directory.Write("target", "old");
        directory.Write("scene.json", Scene);
        const string script = """chmod 644 "$1"/*; chmod 777 "$1"; demo query "$1/scene.json" --out "$1/target" """;
        DemoRun run = DemoProcess.ShellAsUser(script, directory.Path);
        run.AssertRefused(target, "access is denied");
        Assert.Equal("old", File.ReadAllText(target));
        Assert.Equal(2, directory.Files.Length);
    }
}
