using System.Diagnostics;

namespace Gjk.Demo.Tests.Output;

/// <summary>The kind of the target decides how an output is written: a file is replaced, a device or a pipe is written
/// to, and a directory is refused.</summary>
public sealed class TargetKindTests
{
    private const string Scene = """{"version":1,"objects":[{"shape":{"type":"point"}},{"shape":{"type":"point"}}]}""";

    [LinuxFact]
    public void AFileInSharedMemoryIsReplacedAndNotWrittenOver()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene), target = $"/dev/shm/gjk-demo-{Guid.NewGuid():N}.csv";
        try
        {
            File.WriteAllText(target, new string('x', 10_000));
            DemoRun.Of("query", scene, "--out", target).AssertDone();
            Assert.Single(CsvRow.Parse(File.ReadAllText(target)));
        }
        finally
        {
            File.Delete(target);
        }
    }

    [LinuxFact]
    public void AnInputInSharedMemoryIsNotOverwritten()
    {
        string scene = $"/dev/shm/gjk-demo-{Guid.NewGuid():N}.json";
        try
        {
            File.WriteAllText(scene, Scene);
            string spelling = "/dev/shm/./" + Path.GetFileName(scene);
            DemoRun.Of("query", scene, "--out", spelling).AssertRefused("overwrite");
            Assert.Equal(Scene, File.ReadAllText(scene));
        }
        finally
        {
            File.Delete(scene);
        }
    }

    [UnixTheory]
    [InlineData("query", "a,b,status", "1 pair")]
    [InlineData("view", "<!DOCTYPE html>", "1 pair")]
    [InlineData("replay", "{\"scenes\":", "1 scene")]
    public void APipeIsWrittenToAndStays(string command, string start, string what)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene), pipe = directory.File("pipe");
        string call = command == "replay"
            ? "demo replay \"$1\" --frames 1 --json \"$2\" > /dev/null"
            : $"demo {command} \"$1\" --out \"$2\"";
        string script = $"mkfifo \"$2\" && ( cat \"$2\" & {call}; echo \"exit $?\" >&2; wait )";
        DemoRun run = DemoProcess.Shell(script, scene, pipe);
        Assert.StartsWith(start, run.Out, StringComparison.OrdinalIgnoreCase);
        Assert.Equal((0, $"gjk-demo: wrote {what} to {pipe}\nexit 0\n"), (run.ExitCode, run.Error));
        Assert.Equal(0, Test("-p", pipe));
        Assert.Equal(2, directory.Files.Length);
    }

    [UnixFact]
    public void AnInterruptEndsTheWaitForAPipesReader()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene), pipe = directory.File("pipe");
        using (var make = Process.Start("mkfifo", [pipe])) make.WaitForExit();
        using RunningDemo demo = RunningDemo.Start("query", scene, "--out", pipe);
        System.Threading.Thread.Sleep(1000);
        demo.Interrupt();
        DemoRun run = demo.Wait();
        Assert.Equal((130, "", ""), (run.ExitCode, run.Out, run.Error));
        Assert.Equal(0, Test("-p", pipe));
    }

    [UnixTheory]
    [InlineData("demo query \"$1\" --out /dev/stdout >> \"$2\"")]
    [InlineData("demo query \"$1\" --out /dev/fd/1 | cat >> \"$2\"")]
    [InlineData("demo query \"$1\" --out /proc/self/fd/1 >> \"$2\"")]
    public void StandardOutputGoesOnWhereItIs(string script)
    {
        if (script.Contains("/proc") && !OperatingSystem.IsLinux()) script = script.Replace("/proc/self", "/dev");
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene), log = directory.Write("log", "first\n");
        DemoProcess.Shell(script, scene, log).AssertDone();
        Assert.StartsWith("first\n" + CsvRow.Header + "\n0,1,", File.ReadAllText(log));
        Assert.Equal(2, directory.Files.Length);
    }

    /// <summary>A disk is a device with a position, as /dev/zero is.</summary>
    [LinuxFact]
    public void ADeviceThatIsNoStreamIsRefused()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene);
        DemoRun.Of("query", scene, "--out", "/dev/zero").AssertRefused("/dev/zero", "neither a file nor a stream");
        DemoRun.Of("query", scene, "--out", "/dev/null").AssertDone();
    }

    [UnixFact]
    public void ALinkToNothingCreatesItsTarget()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene);
        string link = directory.File("link"), target = directory.File("target.csv");
        File.CreateSymbolicLink(link, "target.csv");
        DemoRun.Of("query", scene, "--out", link).AssertDone();
        Assert.Equal("target.csv", new FileInfo(link).LinkTarget);
        Assert.StartsWith(CsvRow.Header, File.ReadAllText(target));
        Assert.Equal(3, directory.Files.Length);
    }

    [UnixFact]
    public void LinksThatLeadNowhereAreRefused()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene);
        string circle = directory.File("circle"), lost = directory.File("lost");
        File.CreateSymbolicLink(circle, circle);
        File.CreateSymbolicLink(lost, directory.File("nowhere/out.csv"));
        DemoRun.Of("query", scene, "--out", circle).AssertRefused(circle, "too many symbolic links");
        DemoRun.Of("query", scene, "--out", lost).AssertRefused(lost, "no such directory");
        Assert.Equal(3, directory.Files.Length);
    }

    /// <summary>The link's ".." starts at the directory that really holds the link, not at the one through which it was
    /// reached.</summary>
    [UnixFact]
    public void ARelativeLinkIsFollowedFromWhereItLies()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene), bystander = directory.Write("out.csv", "not this one");
        Directory.CreateDirectory(directory.File("real/deep"));
        Directory.CreateSymbolicLink(directory.File("short"), directory.File("real/deep"));
        File.CreateSymbolicLink(directory.File("real/deep/link"), "../out.csv");
        DemoRun.Of("query", scene, "--out", directory.File("short/link")).AssertDone();
        Assert.StartsWith(CsvRow.Header, File.ReadAllText(directory.File("real/out.csv")));
        Assert.Equal("not this one", File.ReadAllText(bystander));
    }

    [Fact]
    public void DirectoriesAreRefused()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene);
        string missing = directory.File("missing") + Path.DirectorySeparatorChar;
        DemoRun.Of("query", scene, "--out", directory.Path).AssertRefused(directory.Path, "it is a directory");
        DemoRun.Of("query", scene, "--out", missing).AssertRefused(missing, "it is a directory");
        DemoRun replay = DemoRun.Of("replay", "--frames", "1", "--json", directory.Path);
        replay.AssertRefused(directory.Path, "it is a directory");
        Assert.Equal([scene], directory.Files);
    }

    /// <summary>The name of the temporary file is allowed wherever the target's name is.</summary>
    [Fact]
    public void TheLongestNameIsTaken()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene), target = directory.File(new string('n', 251) + ".csv");
        DemoRun.Of("query", scene, "--out", target).AssertDone();
        Assert.True(File.Exists(target));
    }

    private static int Test(string what, string file)
    {
        using var test = Process.Start("test", [what, file]);
        test.WaitForExit();
        return test.ExitCode;
    }
}
