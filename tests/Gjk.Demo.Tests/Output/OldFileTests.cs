using System.Text.Json;
using Gjk.Demo.Tests.Scenes;

namespace Gjk.Demo.Tests.Output;

/// <summary>A command that is interrupted, or fails while it writes, leaves the old file byte for byte, and no
/// temporary file.</summary>
public sealed class OldFileTests
{
    /// <summary>These points make 200 million pairs. No command finishes them before it is interrupted.</summary>
    private const int ManyPoints = 20_000;

    [UnixTheory]
    [InlineData("query SCENE --out TARGET")]
    [InlineData("view SCENE --out TARGET --svg SECOND")]
    public void AnInterruptLeavesTheOldFile(string command)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", SceneTests.Points(ManyPoints, pairs: ""));
        string target = directory.Write("target", "old"), second = directory.Write("second", "old too");
        Dictionary<string, string> before = directory.Contents();
        command = command.Replace("SCENE", scene).Replace("TARGET", target).Replace("SECOND", second);
        using RunningDemo demo = RunningDemo.Start(command.Split(' '));
        demo.WaitUntil(_ => Array.Exists(directory.Files, f => f.EndsWith(".tmp", StringComparison.Ordinal)));
        demo.Interrupt();
        DemoRun run = demo.Wait();
        Assert.Equal((130, "", ""), (run.ExitCode, run.Out, run.Error));
        Assert.Equal(before, directory.Contents());
    }

    /// <summary>The second signal ends the process wherever it is. The first one has already removed the temporary
    /// file.</summary>
    [UnixFact]
    public void TwoSignalsLeaveTheOldFile()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", SceneTests.Points(ManyPoints, pairs: ""));
        string target = directory.Write("target", "old");
        Dictionary<string, string> before = directory.Contents();
        using DemoProcess demo = DemoProcess.Start("query", scene, "--out", target);
        demo.WaitUntil(_ => Array.Exists(directory.Files, f => f.EndsWith(".tmp", StringComparison.Ordinal)));
        demo.Signal("TERM");
        demo.Signal("TERM");
        Assert.NotEqual(0, demo.Wait().ExitCode);
        Assert.Equal(before, directory.Contents());
    }

    [UnixTheory]
    [InlineData("")]
    [InlineData("--motion 0.1")]
    public void AReplayWithoutACompleteSceneLeavesTheOldFile(string more)
    {
        using var directory = new TempDirectory();
        string target = directory.Write("replay.json", "old"), unborn = directory.File("new.json");
        foreach (string json in new[] { target, unborn })
        {
            string[] options = more.Split(' ', StringSplitOptions.RemoveEmptyEntries);
            using var watch = new TemporaryFileWatch(directory);
            using RunningDemo demo = RunningDemo.Start(["replay", "--seconds", "60", "--json", json, .. options]);
            demo.WaitUntil(_ => watch.HasSeenOne);
            demo.Interrupt();
            DemoRun run = demo.Wait();
            Assert.Equal((130, "", ""), (run.ExitCode, run.Out, run.Error));
            Assert.Equal(new Dictionary<string, string> { ["replay.json"] = "old" }, directory.Contents());
        }
    }

    /// <summary>A result with only some of the scenes may create a new file, but must not replace a complete one. No
    /// machine completes the second scene. A busy one may need more time for the first.</summary>
    [UnixTheory]
    [InlineData(true)]
    [InlineData(false)]
    public void AReplayWithOneCompleteSceneReplacesNothing(bool hasOldFile)
    {
        using var directory = new TempDirectory();
        using var scenes = new TempDirectory();
        string small = scenes.Write("small.json", SceneTests.Points(2, pairs: ""));
        string large = scenes.Write("large.json", SceneTests.Points(1_000, pairs: ""));
        string target = hasOldFile ? directory.Write("replay.json", "old") : directory.File("replay.json");
        DemoRun run;
        double seconds = 2;
        do
        {
            using RunningDemo demo = RunningDemo.Start("replay", small, large, "--frames", "100000", "--json", target);
            Thread.Sleep(TimeSpan.FromSeconds(seconds));
            demo.Interrupt();
            run = demo.Wait();
            seconds *= 2;
        }
        while (run.Out.Length == 0 && seconds < 64);
        Assert.Equal(130, run.ExitCode);
        Assert.Equal(hasOldFile ? "" : $"gjk-demo: wrote 1 scene to {target}\n", run.Error);
        Assert.Contains("|  small |", run.Out);
        Assert.DoesNotContain("large", run.Out);
        Assert.Equal([target], directory.Files);
        if (hasOldFile)
        {
            Assert.Equal("old", File.ReadAllText(target));
            return;
        }

        using JsonDocument written = JsonDocument.Parse(File.ReadAllText(target));
        JsonElement scene = Assert.Single(written.RootElement.GetProperty("scenes").EnumerateArray());
        Assert.Equal("small", scene.GetProperty("name").GetString());
    }

    /// <summary>A limit on the size of files simulates a full disk. The runtime needs a larger file of its own unless
    /// it is told not to create it.</summary>
    [UnixTheory]
    [InlineData("query \"$1\" --out \"$2\"")]
    [InlineData("view \"$1\" --out \"$2\"")]
    [InlineData("view \"$1\" --out \"$2.html\" --svg \"$2\"")]
    [InlineData("trace \"$1\" --pair 0,1 --out \"$2\"")]
    [InlineData("replay \"$1\" --frames 1 --json \"$2\"")]
    public void AFullDiskLeavesTheOldFile(string call)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", SceneTests.Points(200, pairs: ""));
        string target = directory.Write("target", "old");
        Dictionary<string, string> before = directory.Contents();
        string script = $"trap '' XFSZ; ulimit -f 4; export DOTNET_EnableWriteXorExecute=0; demo {call}";
        DemoRun run = DemoProcess.Shell(script, scene, target);
        run.AssertRefused(target, "cannot be written");
        Assert.Equal(before, directory.Contents());
    }

    [UnixFact]
    public void ADirectoryThatVanishesIsOneLine()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", SceneTests.Points(1_000, pairs: ""));
        string inner = directory.File("inner"), moved = directory.File("moved");
        Directory.CreateDirectory(inner);
        string target = Path.Combine(inner, "target");
        File.WriteAllText(target, "old");
        using RunningDemo demo = RunningDemo.Start("query", scene, "--out", target);
        demo.WaitUntil(_ => Array.Exists(Directory.GetFiles(inner), f => f.EndsWith(".tmp", StringComparison.Ordinal)));
        Directory.Move(inner, moved);
        demo.Wait().AssertRefused(target, "cannot be written", "removed meanwhile");
        Assert.Equal("old", File.ReadAllText(Path.Combine(moved, "target")));
    }

    [UnixFact]
    public void ARefusedInputLeavesTheOldFile()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", "{"), target = directory.Write("target", "old");
        Dictionary<string, string> before = directory.Contents();
        DemoRun.Of("query", scene, "--out", target).AssertRefused(scene);
        DemoRun.Of("view", scene, "--out", target).AssertRefused(scene);
        DemoRun.Of("trace", scene, "--pair", "0,1", "--out", target).AssertRefused(scene);
        Assert.Equal(before, directory.Contents());
    }
}
