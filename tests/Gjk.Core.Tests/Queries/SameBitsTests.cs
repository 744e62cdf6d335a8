using System;
using System.Diagnostics;
using System.Runtime.Intrinsics;

namespace Gjk.Core.Tests.Queries;

/// <summary>
/// Contract 7 across processes: the hard cases have one hash whatever vectors the machine has and however the code was
/// compiled.
/// </summary>
public class SameBitsTests
{
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(3);

    [Fact]
    public void SerialAndParallelGiveTheSameBits() =>
        Assert.Equal(HashProgram.OfAllCases(parallel: false), HashProgram.OfAllCases(parallel: true));

    [Fact]
    public void AChildProcessGivesTheSameBits() =>
        Assert.Equal(
            $"{Vector256.IsHardwareAccelerated} {Vector128.IsHardwareAccelerated} {HashProgram.OfAllCases(false)}",
            Child("TieredPGO", "0"));

    [Fact]
    public void TheBitsAreTheSameWithoutWideVectors() =>
        Assert.Equal(
            $"False {Vector128.IsHardwareAccelerated} {HashProgram.OfAllCases(false)}", Child("EnableAVX2", "0"));

    [Fact]
    public void TheBitsAreTheSameWithoutAnyVectors() =>
        Assert.Equal($"False False {HashProgram.OfAllCases(false)}", Child("EnableHWIntrinsic", "0"));

    /// <summary>
    /// What the compiler makes of a debug build: every value through memory, nothing inlined or merged.
    /// </summary>
    [Fact]
    public void TheBitsAreTheSameWithoutOptimisation() =>
        Assert.EndsWith(" " + HashProgram.OfAllCases(false), Child("JITMinOpts", "1"));

    [Fact]
    public void TheBitsAreTheSameWhenOptimisedAtOnce() =>
        Assert.EndsWith(" " + HashProgram.OfAllCases(false), Child("TieredCompilation", "0"));

    /// <summary>
    /// The last line that this assembly prints when it is run as a program under a switch of the runtime.
    /// </summary>
    private static string Child(string option, string value)
    {
        var start = new ProcessStartInfo(Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") ?? "dotnet")
        {
            ArgumentList = { "exec", typeof(SameBitsTests).Assembly.Location, HashProgram.Command },
            RedirectStandardOutput = true,
            Environment = { ["DOTNET_" + option] = value },
        };
        using Process child = Process.Start(start)!;
        string text = child.StandardOutput.ReadToEnd().Trim();
        bool ended = child.WaitForExit(Patience);
        if (!ended) child.Kill(entireProcessTree: true);
        Assert.True(ended && child.ExitCode == 0, $"{option}={value}: the child failed.");
        return text;
    }
}
