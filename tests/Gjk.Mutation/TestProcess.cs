using System.Collections.Concurrent;
using System.Diagnostics;
using System.Globalization;
using System.Text;

namespace Gjk.Mutation;

/// <summary>A <see cref="TestServer"/> in its own process, started again whenever a mutant has hung or killed
/// it.</summary>
internal sealed class TestProcess(string tests) : IDisposable
{
    /// <summary>Seconds of the processor: what a test may take beside ten times its usual time before it counts as
    /// hung.</summary>
    private const double Patience = 8;

    /// <summary>How many times longer a clock may run than the processor: other work on the machine is no fault of a
    /// test, a test that waits for ever is.</summary>
    private const double Sharing = 20;

    /// <summary>Seconds between two looks at how much of the processor a test has had.</summary>
    private const double Look = 0.5;

    private Process? _process;
    private BlockingCollection<string?> _lines = [];

    /// <summary>Asks for all tests but those that are known; each answer is a line.</summary>
    /// <exception cref="InvalidOperationException">A test ended the process, or took ten minutes.</exception>
    public IEnumerable<string> Record(IEnumerable<string> known)
    {
        Start();
        _process!.StandardInput.WriteLine("record " + string.Join(",", known));
        string last = "none";
        while (true)
        {
            string line = Next(600) ?? throw new InvalidOperationException($"no test was recorded after: {last}");
            if (line == "end") yield break;
            yield return last = line;
        }
    }

    /// <summary>Runs tests until one notices the mutant.</summary>
    /// <param name="mutant">Its number.</param>
    /// <param name="plan">The tests, with their usual seconds.</param>
    /// <returns>Null where none does, else what happened.</returns>
    public string? Run(int mutant, (string Test, double Seconds)[] plan)
    {
        for (int attempt = 0; ; attempt++)
        {
            Start();
            string list = string.Join(",", Array.ConvertAll(plan, p => p.Test));
            _process!.StandardInput.WriteLine(string.Create(CultureInfo.InvariantCulture, $"run {mutant} {list}"));
            int at = -1;
            while (true)
            {
                string? line = Next(Patience + (at >= 0 ? 10 * plan[at].Seconds : 0));
                if (line == "survived") return null;
                if (line is not null && line.StartsWith("start", StringComparison.Ordinal))
                {
                    at++;
                    continue;
                }

                if (line is not null && line.StartsWith("killed", StringComparison.Ordinal)) return line;
                bool isSpoiled = line is not null;
                bool isDead = _process.HasExited;
                Stop();
                if (isSpoiled && attempt == 0) break;
                return $"killed\t{plan[Math.Max(at, 0)].Test}\t{(isSpoiled ? "spoiled" : isDead ? "died" : "hung")}";
            }
        }
    }

    public void Dispose() => Stop();

    /// <summary>The next line; null where the process has ended, or has used so many seconds of the processor without
    /// one.</summary>
    private string? Next(double seconds)
    {
        double end = UsedSeconds() + seconds;
        for (double waited = 0; waited < seconds * Sharing && UsedSeconds() < end; waited += Look)
        {
            if (_lines.TryTake(out string? line, TimeSpan.FromSeconds(Look))) return line;
            if (_process!.HasExited) return _lines.TryTake(out line) ? line : null;
        }

        return null;
    }

    /// <summary>What the process has had of the processor; 0 once it has ended, which the caller sees.</summary>
    private double UsedSeconds()
    {
        try
        {
            _process!.Refresh();
            return _process.TotalProcessorTime.TotalSeconds;
        }
        catch (InvalidOperationException)
        {
            return 0;
        }
    }

    private void Start()
    {
        if (_process is { HasExited: false }) return;
        var start = new ProcessStartInfo(Environment.ProcessPath!, ["serve", tests])
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };

        // A mutant that allocates for ever is to die before the machine does.
        start.Environment["DOTNET_GCHeapHardLimit"] = "0xA0000000";
        start.Environment["DOTNET_DbgEnableMiniDump"] = "0";
        BlockingCollection<string?> lines = _lines = [];
        _process = new Process { StartInfo = start };
        _process.OutputDataReceived += (_, e) => lines.Add(e.Data);
        var errors = new StringBuilder();
        _process.ErrorDataReceived += (_, e) => errors.AppendLine(e.Data);
        _process.Start();
        _process.BeginOutputReadLine();
        _process.BeginErrorReadLine();
        if (Next(60) != "ready") throw new InvalidOperationException($"the tests cannot be loaded: {tests}\n{errors}");
    }

    private void Stop()
    {
        if (_process is null) return;
        if (!_process.HasExited) _process.Kill();
        _process.WaitForExit();
        _process.Dispose();
        _process = null;
    }
}
