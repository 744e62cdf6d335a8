using System.Diagnostics;

namespace Gjk.Core.Tests.Support;

/// <summary>Runs this assembly as a program of its own, under a switch of the runtime.</summary>
internal static class ChildProcess
{
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(3);

    /// <summary>What it prints; fails when it does not end well.</summary>
    public static string Run(string option, string value, params string[] arguments)
    {
        var start = new ProcessStartInfo(Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") ?? "dotnet")
        {
            ArgumentList = { "exec", typeof(ChildProcess).Assembly.Location },
            RedirectStandardOutput = true,
            Environment = { ["DOTNET_" + option] = value },
        };
        foreach (string argument in arguments) start.ArgumentList.Add(argument);
        using Process child = Process.Start(start)!;
        string text = child.StandardOutput.ReadToEnd().Trim();
        bool ended = child.WaitForExit(Patience);
        if (!ended) child.Kill(entireProcessTree: true);
        Assert.True(ended && child.ExitCode == 0, $"{option}={value}: the child failed after:\n{text}");
        return text;
    }
}
