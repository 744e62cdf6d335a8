using System;
using System.Diagnostics;
using System.IO;
using System.Threading;
using Gjk.Demo.Tests.Scenes;
using Gjk.Demo.Tests.Support;
using Xunit;

namespace Gjk.Demo.Tests.Output;

/// <summary>
/// Standard streams and pipes that are full, closed, or without a reader or writer. The command ends at once with the
/// documented exit code and at most one line.
/// </summary>
public sealed class StreamTests
{
    private const string Scene = """{"version":1,"objects":[{"shape":{"type":"point"}},{"shape":{"type":"point"}}]}""";

    /// <summary>These points make 200 million pairs. No command finishes them.</summary>
    private const int ManyPoints = 20_000;

    [UnixTheory]
    [InlineData("query -")]
    [InlineData("time - --seconds 0.1")]
    [InlineData("view - --out \"$2\"")]
    [InlineData("trace - --pair 0,1 --out \"$2\"")]
    public void ADashIsStandardInput(string call)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene), target = directory.File("target");
        DemoRun run = DemoProcess.Shell($"demo {call} < \"$1\"", scene, target);
        run.AssertDone();
        Assert.True(File.Exists(target) || run.Out.Length > 0);
        DemoProcess.Shell($"echo oops | demo {call}", scene, target).AssertRefused("standard input: ");
    }

    [UnixTheory]
    [InlineData("query -")]
    [InlineData("view -")]
    [InlineData("trace - --pair 0,1")]
    public void StandardInputIsNotOverwritten(string call)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene);
        DemoRun run = DemoProcess.Shell($"demo {call} --out \"$1\" < \"$1\"", scene);
        run.AssertRefused(scene, "would overwrite the scene");
        Assert.Equal(Scene, File.ReadAllText(scene));
    }

    [LinuxTheory]
    [InlineData("--help")]
    [InlineData("--version")]
    [InlineData("replay --frames 1")]
    [InlineData("replay --frames 1 --motion 0.1")]
    [InlineData("query \"$1\"")]
    [InlineData("query \"$1\" --out /dev/stdout")]
    [InlineData("time \"$1\" --seconds 0.1")]
    [InlineData("fuzz --count 1 --seed 1")]
    public void AFullStandardOutputIsOneLine(string call)
    {
        using var directory = new TempDirectory();
        DemoRun run = DemoProcess.Shell($"demo {call} > /dev/full", directory.Write("scene.json", Scene));
        run.AssertRefused("cannot be written: No space left on device");
    }

    [UnixTheory]
    [InlineData("query none.json 2> /dev/full", 2)]
    [InlineData("query none.json 2>&-", 2)]
    [InlineData("frobnicate 2> /dev/full", 2)]
    [InlineData("--version 2>&-", 0)]
    public void AFullOrClosedStandardErrorLeavesTheExitCode(string call, int exitCode)
    {
        if (call.Contains("/dev/full") && !File.Exists("/dev/full")) call = call.Replace("/dev/full", "/dev/null");
        DemoRun run = DemoProcess.Shell("demo " + call);
        Assert.Equal((exitCode, ""), (run.ExitCode, run.Error));
    }

    [UnixTheory]
    [InlineData("query \"$1\"")]
    [InlineData("query \"$1\" --out /dev/stdout")]
    public void AReaderThatGoesEndsTheWork(string call)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", SceneTests.Points(ManyPoints, pairs: ""));
        DemoRun run = DemoProcess.Shell($"( demo {call}; echo \"exit $?\" >&2 ) | head -n 1", scene);
        Assert.Equal(CsvRow.Header + "\n", run.Out);
        string[] lines = run.Error.TrimEnd('\n').Split('\n');
        Assert.Equal(2, lines.Length);
        Assert.Contains("cannot be written: Broken pipe", lines[0]);
        Assert.Equal("exit 2", lines[1]);
    }

    /// <summary>The pipe's buffer is full, and nobody empties it.</summary>
    [UnixTheory]
    [InlineData("INT")]
    [InlineData("TERM")]
    [InlineData("HUP")]
    public void ASignalEndsTheWaitForAReader(string signal)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", SceneTests.Points(ManyPoints, pairs: ""));
        string pipe = MakePipe(directory);
        using DemoProcess demo = DemoProcess.Start("query", scene, "--out", pipe);
        using FileStream reader = new(pipe, FileMode.Open, FileAccess.Read, FileShare.ReadWrite, bufferSize: 0);
        reader.ReadByte();
        demo.Signal(signal);
        DemoRun run = demo.Wait();
        Assert.Equal((130, "", ""), (run.ExitCode, run.Out, run.Error));
    }

    [UnixTheory]
    [InlineData("query", "TERM")]
    [InlineData("query", "INT")]
    [InlineData("query", "HUP")]
    [InlineData("time", "TERM")]
    [InlineData("view", "TERM")]
    public void ASignalEndsTheWaitForInput(string command, string signal)
    {
        using var directory = new TempDirectory();
        string pipe = MakePipe(directory);
        string[] more = command == "view" ? ["--out", directory.File("page.html")] : [];
        using DemoProcess demo = DemoProcess.Start([command, pipe, .. more]);
        using FileStream writer = new(pipe, FileMode.Open, FileAccess.Write, FileShare.ReadWrite, bufferSize: 0);
        writer.WriteByte((byte)'{');
        demo.Signal(signal);
        DemoRun run = demo.Wait();
        Assert.Equal((130, "", ""), (run.ExitCode, run.Out, run.Error));
        Assert.Equal([pipe], directory.Files);
    }

    /// <summary>
    /// A signal that comes before the demo listens ends the process directly. The test then sends it later.
    /// </summary>
    [UnixTheory]
    [InlineData("query -")]
    [InlineData("query --record -")]
    public void ASignalEndsTheWaitForStandardInput(string call)
    {
        const int killed = 128 + 15;
        using var directory = new TempDirectory();
        string pipe = MakePipe(directory);
        DemoRun run;
        int seconds = 1;
        do
        {
            string script = $"exec 3<> \"$1\"; exec \"$GJK_HOST\" \"$GJK_DEMO\" {call} <&3";
            using DemoProcess demo = DemoProcess.StartShell(script, pipe);
            Thread.Sleep(TimeSpan.FromSeconds(seconds));
            demo.Signal("TERM");
            run = demo.Wait();
            seconds *= 2;
        }
        while (run.ExitCode == killed && seconds < 64);
        Assert.Equal((130, "", ""), (run.ExitCode, run.Out, run.Error));
    }

    /// <summary>Ignores the signal as nohup does.</summary>
    [UnixFact]
    public void AnIgnoredHangUpIsIgnored()
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", SceneTests.Points(ManyPoints, pairs: ""));
        string pipe = MakePipe(directory);
        const string script = "trap '' HUP; exec \"$GJK_HOST\" \"$GJK_DEMO\" query \"$1\" --out \"$2\"";
        using DemoProcess demo = DemoProcess.StartShell(script, scene, pipe);
        using FileStream reader = new(pipe, FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
        demo.Signal("HUP");
        var buffer = new byte[10_000_000];
        reader.ReadExactly(buffer);
        demo.Interrupt();
        Assert.Equal(130, demo.Wait().ExitCode);
    }

    private static string MakePipe(TempDirectory directory)
    {
        string pipe = directory.File("pipe");
        using var make = Process.Start("mkfifo", [pipe]);
        make.WaitForExit();
        return pipe;
    }
}
