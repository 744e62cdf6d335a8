using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.Text;

namespace Gjk.Mutation;

/// <summary>A <see cref="TestServer"/> in its own process, started again whenever a mutant has hung or killed
/// it.</summary>
internal sealed class TestProcess(string tests) : IDisposable
{
    /// <summary>Seconds: what a test may take beside ten times its usual time before it counts as hung.</summary>
    private const double Patience = 8;

    private Process? _process;
    private BlockingCollection<string?> _lines = [];

    /// <summary>Asks for all tests but those that are known; each answer is a line.</summary>
    public IEnumerable<string> Record(IEnumerable<string> known)
    {
        Start();
        _process!.StandardInput.WriteLine("record " + string.Join(",", known));
        while (Next(600) is { } line && line != "end") yield return line;
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

    private string? Next(double seconds) =>
        _lines.TryTake(out string? line, TimeSpan.FromSeconds(seconds)) ? line : null;

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
