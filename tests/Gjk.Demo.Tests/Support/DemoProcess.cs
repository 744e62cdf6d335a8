using System.Diagnostics;
using System.Reflection;
using System.Text;
using System.Threading.Tasks;

namespace Gjk.Demo.Tests.Support;

/// <summary>The result of a finished run of the demo.</summary>
public sealed record DemoRun(int ExitCode, string Out, string Error)
{
    /// <summary>Runs the demo in this process, to its end, with an empty standard input.</summary>
    public static DemoRun Of(params string[] args) => Fed("", args);

    /// <summary>As the other one, with a text as standard input.</summary>
    public static DemoRun Fed(string input, params string[] args)
    {
        using RunningDemo demo = RunningDemo.Start(args, new MemoryStream(Encoding.UTF8.GetBytes(input)));
        return demo.Wait();
    }

    /// <summary>Asserts exit code 2, nothing on standard output, and one line on standard error that contains all the
    /// parts.</summary>
    public void AssertRefused(params string[] parts)
    {
        Assert.True(ExitCode == 2, $"exit code {ExitCode}, error: {Error}");
        Assert.Equal("", Out);
        Assert.EndsWith("\n", Error);
        Assert.Single(Error.TrimEnd('\n').Split('\n'));
        foreach (string part in parts) Assert.Contains(part, Error);
    }

    /// <summary>Asserts exit code 0, and nothing on standard error but what was written to which file.</summary>
    public void AssertDone()
    {
        Assert.True(ExitCode == 0, $"exit code {ExitCode}, error: {Error}");
        Assert.All(Error.Split('\n')[..^1], line => Assert.StartsWith("gjk-demo: wrote ", line));
        Assert.DoesNotContain('\r', Out);
    }
}

/// <summary>Runs the built demo as a process, as its user does: for signals, shells, terminals and the process's own
/// streams.</summary>
public sealed class DemoProcess : IDisposable
{
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(90);

    private static readonly string Assembly = typeof(DemoProcess).Assembly
        .GetCustomAttributes<AssemblyMetadataAttribute>().Single(a => a.Key == "DemoAssembly").Value!;

    private readonly Process _process;
    private readonly StringBuilder _out = new();
    private readonly StringBuilder _error = new();
    private readonly Task _readers;

    private DemoProcess(IReadOnlyDictionary<string, string> environment, string[] command)
    {
        // A job that a shell started in the background ignores SIGINT and passes that on to its children. The program
        // env restores the default action of the signals.
        bool restoreSignal = OperatingSystem.IsLinux();
        var start = new ProcessStartInfo(restoreSignal ? "env" : command[0])
        {
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            RedirectStandardInput = true,
            StandardOutputEncoding = new UTF8Encoding(false),
            StandardErrorEncoding = new UTF8Encoding(false),
        };
        if (restoreSignal)
        {
            start.ArgumentList.Add("--default-signal=INT,HUP");
            start.ArgumentList.Add(command[0]);
        }

        foreach (string arg in command[1..]) start.ArgumentList.Add(arg);
        foreach ((string key, string value) in environment) start.Environment[key] = value;
        _process = Process.Start(start)!;
        _process.StandardInput.Close();
        _readers = Task.WhenAll(Collect(_process.StandardOutput, _out), Collect(_process.StandardError, _error));
    }

    private static string Host => Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") ?? "dotnet";

    /// <summary>Runs the demo to its end.</summary>
    public static DemoRun Run(params string[] args) => RunWith(new Dictionary<string, string>(), args);

    public static DemoRun RunWith(IReadOnlyDictionary<string, string> environment, params string[] args)
    {
        using var demo = new DemoProcess(environment, [Host, Assembly, .. args]);
        return demo.Wait();
    }

    /// <summary>Runs a shell script in which <c>demo</c> is the demo and <c>$1</c> is the first argument.</summary>
    public static DemoRun Shell(string script, params string[] args)
    {
        using DemoProcess shell = StartShell(script, args);
        return shell.Wait();
    }

    /// <summary>As <see cref="Shell"/>. If the tests run as root, the demo runs as nobody.</summary>
    public static DemoRun ShellAsUser(string script, params string[] args)
    {
        const string drop = "setpriv --reuid=65534 --regid=65534 --clear-groups";
        const string asNobody = $$"""demo() { {{drop}} "$GJK_HOST" "$GJK_DEMO" "$@"; };""";
        return Shell((Environment.IsPrivilegedProcess ? asNobody : "") + script, args);
    }

    /// <summary>As <see cref="Shell"/>, but does not wait.</summary>
    public static DemoProcess StartShell(string script, params string[] args)
    {
        var names = new Dictionary<string, string> { ["GJK_HOST"] = Host, ["GJK_DEMO"] = Assembly };
        const string demo = """demo() { "$GJK_HOST" "$GJK_DEMO" "$@"; };""";
        return new DemoProcess(names, ["sh", "-c", demo + script, "sh", .. args]);
    }

    /// <summary>Starts the demo and returns at once.</summary>
    public static DemoProcess Start(params string[] args) =>
        new(new Dictionary<string, string>(), [Host, Assembly, .. args]);

    /// <summary>Sends the signal of Ctrl-C.</summary>
    public void Interrupt() => Signal("INT");

    /// <summary>Sends a signal by its name without SIG.</summary>
    public void Signal(string name)
    {
        string id = _process.Id.ToString(System.Globalization.CultureInfo.InvariantCulture);
        using Process kill = Process.Start("kill", ["-" + name, id]);
        kill.WaitForExit();
    }

    /// <summary>Waits until a condition holds while the process is running.</summary>
    public void WaitUntil(Func<string, bool> outputSoFar)
    {
        long start = Stopwatch.GetTimestamp();
        while (true)
        {
            string text;
            lock (_out) text = _out.ToString();
            if (outputSoFar(text)) return;
            Assert.False(_process.HasExited, $"The demo ended early: {_error}");
            Assert.True(Stopwatch.GetElapsedTime(start) < Patience, "The demo did not get there in time.");
            Thread.Sleep(20);
        }
    }

    public DemoRun Wait()
    {
        bool ended = _process.WaitForExit(Patience);
        if (!ended) _process.Kill(entireProcessTree: true);
        Assert.True(ended, "The demo did not end.");
        _readers.Wait();
        return new DemoRun(_process.ExitCode, _out.ToString(), _error.ToString());
    }

    public void Dispose()
    {
        if (!_process.HasExited) _process.Kill(entireProcessTree: true);
        _process.Dispose();
    }

    private static async Task Collect(TextReader reader, StringBuilder into)
    {
        var buffer = new char[4096];
        while (await reader.ReadAsync(buffer) is int count and > 0)
        {
            lock (into) into.Append(buffer, 0, count);
        }
    }
}
