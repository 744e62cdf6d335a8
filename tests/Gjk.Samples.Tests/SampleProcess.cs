using System;
using System.Diagnostics;
using System.Linq;
using System.Reflection;
using System.Threading.Tasks;
using Xunit;

namespace Gjk.Samples.Tests;

/// <summary>The result of a finished run of a sample.</summary>
internal sealed record SampleRun(int ExitCode, string Out, string Error)
{
    public string[] Lines => Out.TrimEnd('\n').Split('\n');

    public void AssertDone() => Assert.True(ExitCode == 0, $"exit code {ExitCode}, error: {Error}");

    /// <summary>Asserts exit code 2, nothing on standard output, and one line that contains the part.</summary>
    public void AssertRefused(string part)
    {
        Assert.True(ExitCode == 2, $"exit code {ExitCode}, error: {Error}");
        Assert.Equal("", Out);
        Assert.Single(Error.TrimEnd('\n').Split('\n'));
        Assert.Contains(part, Error);
    }
}

/// <summary>Runs a built sample as a process, as its user does.</summary>
internal static class SampleProcess
{
    public static readonly TimeSpan Patience = TimeSpan.FromSeconds(120);

    public static SampleRun Run(string sample, params string[] args)
    {
        using Process process = Start(sample, args);
        return Finish(process);
    }

    public static Process Start(string sample, params string[] args)
    {
        string assembly = typeof(SampleProcess).Assembly.GetCustomAttributes<AssemblyMetadataAttribute>()
            .Single(a => a.Key == sample).Value!;

        // A job that a shell started in the background ignores SIGINT, and its children do too. The program env
        // restores what the signal does.
        string host = Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") ?? "dotnet";
        string[] command = OperatingSystem.IsLinux() ? ["env", "--default-signal=INT", host] : [host];
        return Process.Start(new ProcessStartInfo(command[0], [.. command[1..], assembly, .. args])
        {
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        })!;
    }

    public static SampleRun Finish(Process process)
    {
        Task<string> output = process.StandardOutput.ReadToEndAsync(), error = process.StandardError.ReadToEndAsync();
        bool isEnded = process.WaitForExit(Patience);
        if (!isEnded) process.Kill(entireProcessTree: true);
        Assert.True(isEnded, "The sample did not end.");
        return new SampleRun(process.ExitCode, output.Result, error.Result);
    }
}
