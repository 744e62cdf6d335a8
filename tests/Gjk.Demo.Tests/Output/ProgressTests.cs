namespace Gjk.Demo.Tests.Output;

/// <summary>Progress is shown on a terminal, on standard error alone, and nowhere else.</summary>
public sealed class ProgressTests
{
    private const string Scene = """
        {"version":1,"name":"the scene","objects":[{"shape":{"type":"point"}},{"shape":{"type":"point"}}]}
        """;

    /// <summary>The program script runs a command on a terminal, and prints what that shows.</summary>
    [LinuxTheory]
    [InlineData("time s.json --seconds 0.02 > out", "the scene")]
    [InlineData("view s.json --svg out", "the scene")]
    [InlineData("view s.json --svg out", "choice of pairs")]
    [InlineData("replay s.json --frames 2 > out", "the scene")]
    [InlineData("query big.json > out", "big.json: hulls")]
    public void ATerminalShowsABar(string call, string title)
    {
        if (!File.Exists("/usr/bin/script")) return;
        using var directory = new TempDirectory();
        directory.Write("s.json", Scene);
        WriteLargeMesh(directory);
        DemoRun run = DemoProcess.Shell(
            """export GJK_CALL="$2" TERM=xterm; cd "$1"; """
            + """script -qec 'stty cols 80; eval "\"$GJK_HOST\" \"$GJK_DEMO\" $GJK_CALL"' /dev/null""",
            directory.Path, call);
        Assert.Equal(0, run.ExitCode);
        Assert.Contains(title, run.Out);
        Assert.Contains("100%", run.Out);
        Assert.DoesNotContain('\u001b', File.ReadAllText(directory.File("out")));
    }

    [Theory]
    [InlineData("time s.json --seconds 0.02")]
    [InlineData("view s.json --svg out")]
    [InlineData("query big.json")]
    public void APipeShowsNone(string call)
    {
        using var directory = new TempDirectory();
        directory.Write("s.json", Scene);
        WriteLargeMesh(directory);
        string[] files = ["s.json", "big.json", "out"];
        DemoRun run = DemoProcess.Run([.. call.Split(' ').Select(a => files.Contains(a) ? directory.File(a) : a)]);
        run.AssertDone();
        Assert.DoesNotContain("%", run.Error);
    }

    /// <summary>Who reads from a terminal is told that it waits, and how to end.</summary>
    [LinuxFact]
    public void ATerminalIsToldThatItIsRead()
    {
        if (!File.Exists("/usr/bin/script")) return;
        using var directory = new TempDirectory();
        directory.Write("s.json", Scene.ReplaceLineEndings("") + "\n");
        const string Hint = "reads what is typed here, until Ctrl-D";
        DemoRun typed = DemoProcess.Shell(
            """cd "$1"; script -qec '"$GJK_HOST" "$GJK_DEMO" query - --out out' /dev/null < s.json""", directory.Path);
        Assert.Equal(0, typed.ExitCode);
        Assert.Contains(Hint, typed.Out);
        Assert.True(File.Exists(directory.File("out")));
        DemoRun piped = DemoProcess.Shell("""cd "$1"; "$GJK_HOST" "$GJK_DEMO" query - < s.json""", directory.Path);
        piped.AssertDone();
        Assert.DoesNotContain(Hint, piped.Error);
    }

    private static void WriteLargeMesh(TempDirectory directory)
    {
        string vertices = string.Join(
            ',', Enumerable.Range(0, 120_000).Select(i => $"[{i % 50},{i / 50 % 50},{i / 2500}]"));
        directory.Write("big.json", $$"""
            {"version":1,"meshes":{"m":[{{vertices}}]},"objects":[{"shape":{"type":"mesh","mesh":"m"} },
              {"shape":{"type":"point"},"position":[-3,0,0]}]}
            """);
    }
}
