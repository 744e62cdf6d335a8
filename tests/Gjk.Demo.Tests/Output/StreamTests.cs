using System.Diagnostics;
using Gjk.Demo.Tests.Scenes;

namespace Gjk.Demo.Tests.Output;

/// <summary>Standard streams and pipes that are full, closed, or without a reader or writer. The command ends at once
/// with the documented exit code and at most one line.</summary>
public sealed class StreamTests
{
    private const string Scene = """{"version":1,"objects":[{"shape":{"type":"point"}},{"shape":{"type":"point"}}]}""";

    /// <summary>These points make 200 million pairs. No command finishes them.</summary>
    private const int ManyPoints = 20_000;

    [Theory]
    [InlineData("query -")]
    [InlineData("time - --seconds 0.01")]
    [InlineData("view - --out TARGET")]
    [InlineData("trace - --pair 0,1 --out TARGET")]
    public void ADashIsStandardInput(string call)
    {
        using var directory = new TempDirectory();
        string target = directory.File("target");
        string[] args = [.. call.Split(' ').Select(a => a == "TARGET" ? target : a)];
        DemoRun run = DemoRun.Fed(Scene, args);
        run.AssertDone();
        Assert.True(File.Exists(target) || run.Out.Length > 0);
        DemoRun.Fed("oops\n", args).AssertRefused("standard input: ");
    }

    [UnixFact]
    public void ADashIsTheProcesssStandardInput()
    {
        using var directory = new TempDirectory();
        DemoRun run = DemoProcess.Shell("demo query - < \"$1\"", directory.Write("scene.json", Scene));
        run.AssertDone();
        Assert.StartsWith(CsvRow.Header, run.Out);
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

    [Theory]
    [InlineData("--help")]
    [InlineData("--version")]
    [InlineData("replay SCENE --frames 1")]
    [InlineData("replay --frames 1 --motion 0.1 --objects 2")]
    [InlineData("query SCENE")]
    [InlineData("time SCENE --seconds 0.01")]
    [InlineData("fuzz --count 1 --seed 1")]
    public void AFullStandardOutputIsOneLine(string call)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", Scene);
        string[] args = [.. call.Split(' ').Select(a => a == "SCENE" ? scene : a)];
        using RunningDemo demo = RunningDemo.Start(args, Stream.Null, output: new FullStream());
        demo.Wait().AssertRefused("cannot be written: No space left on device");
    }

    [LinuxTheory]
    [InlineData("query \"$1\"")]
    [InlineData("query \"$1\" --out /dev/stdout")]
    public void AProcesssFullStandardOutputIsOneLine(string call)
    {
        using var directory = new TempDirectory();
        DemoRun run = DemoProcess.Shell($"demo {call} > /dev/full", directory.Write("scene.json", Scene));
        run.AssertRefused("cannot be written: No space left on device");
    }

    [Theory]
    [InlineData("query none.json", 2)]
    [InlineData("frobnicate", 2)]
    [InlineData("--version", 0)]
    public void AFullStandardErrorLeavesTheExitCode(string call, int exitCode)
    {
        using RunningDemo demo = RunningDemo.Start(call.Split(' '), Stream.Null, error: new FullStream());
        Assert.Equal(exitCode, demo.Wait().ExitCode);
    }

    [UnixTheory]
    [InlineData("query none.json 2> /dev/full", 2)]
    [InlineData("query none.json 2>&-", 2)]
    public void AFullOrClosedStandardErrorLeavesTheExitCode(string call, int exitCode)
    {
        if (call.Contains("/dev/full") && !File.Exists("/dev/full")) call = call.Replace("/dev/full", "/dev/null");
        DemoRun run = DemoProcess.Shell("demo " + call);
        Assert.Equal((exitCode, ""), (run.ExitCode, run.Error));
    }

    [UnixTheory]
    [InlineData("query \"$1\"")]
    [InlineData("query \"$1\" --out /dev/stdout")]
    [InlineData("query \"$1\" --max-distance 1")]
    public void AReaderThatGoesEndsTheWorkInSilence(string call)
    {
        using var directory = new TempDirectory();
        string scene = directory.Write("scene.json", SceneTests.Points(ManyPoints, pairs: ""));
        DemoRun run = DemoProcess.Shell($"( demo {call}; echo \"exit $?\" >&2 ) | head -n 1", scene);
        Assert.Equal(CsvRow.Header + "\n", run.Out);
        Assert.Equal("exit 0\n", run.Error);
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
    [InlineData("query")]
    [InlineData("time")]
    [InlineData("view")]
    public void AnInterruptEndsTheWaitForInput(string command)
    {
        using var directory = new TempDirectory();
        string pipe = MakePipe(directory);
        string[] more = command == "view" ? ["--out", directory.File("page.html")] : [];
        using RunningDemo demo = RunningDemo.Start([command, pipe, .. more]);
        using FileStream writer = new(pipe, FileMode.Open, FileAccess.Write, FileShare.ReadWrite, bufferSize: 0);
        writer.WriteByte((byte)'{');
        demo.Interrupt();
        DemoRun run = demo.Wait();
        Assert.Equal((130, "", ""), (run.ExitCode, run.Out, run.Error));
        Assert.Equal([pipe], directory.Files);
    }

    /// <summary>A signal that comes before the demo listens ends the process directly. The test then sends it
    /// later.</summary>
    [UnixFact]
    public void ASignalEndsTheWaitForStandardInput()
    {
        const int killed = 128 + 15;
        using var directory = new TempDirectory();
        string pipe = MakePipe(directory);
        DemoRun run;
        int seconds = 1;
        do
        {
            const string script = "exec 3<> \"$1\"; exec \"$GJK_HOST\" \"$GJK_DEMO\" query - <&3";
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
