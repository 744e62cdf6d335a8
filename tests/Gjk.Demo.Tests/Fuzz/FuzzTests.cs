using System.Text.RegularExpressions;

namespace Gjk.Demo.Tests.Fuzz;

/// <summary><c>fuzz</c> as its user runs it: length, seed, words and exit codes. FuzzSearchTests covers the search
/// itself.</summary>
public sealed class FuzzTests
{
    [Fact]
    public void ACountIsTriedAndNothingBreaks()
    {
        DemoRun run = DemoRun.Of("fuzz", "--count", "300", "--seed", "5");
        run.AssertDone();
        Assert.Matches(@"^300 pairs tried in \d+\.\d s, \d+ pairs per second, seed 5: no promise broken\n$", run.Out);
    }

    [Fact]
    public void SecondsEndIt()
    {
        DemoRun run = DemoRun.Of("fuzz", "--seconds", "1.5", "--seed", "6");
        run.AssertDone();
        Assert.Matches(@"^\d+ pairs tried in [1-9]\.\d s, \d+ pairs per second, seed 6: no promise broken\n$", run.Out);
        Assert.NotEqual("0", run.Out.Split(' ')[0]);
    }

    [Fact]
    public void TheFirstOfBothEndsIt()
    {
        DemoRun run = DemoRun.Of("fuzz", "--seconds", "600", "--count", "10");
        run.AssertDone();
        Assert.StartsWith("10 pairs tried", run.Out);
    }

    [Fact]
    public void WithoutASeedEachRunHasItsOwnAndSaysWhich()
    {
        DemoRun run = DemoRun.Of("fuzz", "--count", "1");
        run.AssertDone();
        Assert.Matches("seed [0-9]+:", run.Out);
    }

    [Fact]
    public void CtrlCPrintsWhatWasDone()
    {
        if (OperatingSystem.IsWindows()) return;
        using RunningDemo demo = RunningDemo.Start("fuzz", "--seconds", "600", "--seed", "7");
        System.Threading.Thread.Sleep(TimeSpan.FromSeconds(1));
        demo.Interrupt();
        DemoRun run = demo.Wait();
        Assert.Equal((130, ""), (run.ExitCode, run.Error));
        Assert.Matches(
            @"^\d+ pairs tried in \d+\.\d s, \d+ pairs per second, seed 7: no promise broken until cancelled\n$",
            run.Out);
    }

    [Theory]
    [InlineData("--seconds 0")]
    [InlineData("--seconds -1")]
    [InlineData("--seconds long")]
    [InlineData("--seconds NaN")]
    [InlineData("--count 0")]
    [InlineData("--count 1.5")]
    [InlineData("--count many")]
    [InlineData("--seed -1")]
    [InlineData("--seed x")]
    [InlineData("--seed 99999999999999999999")]
    public void WrongNumbersAreOneLine(string args) =>
        DemoRun.Of(["fuzz", .. args.Split(' ')]).AssertRefused(
            "fuzz: " + Regex.Replace(args, " .*", ""), args.Split(' ')[1]);

    [Theory]
    [InlineData("fuzz scene.json", "scene.json")]
    [InlineData("fuzz --nope", "--nope")]
    [InlineData("fuzz --count", "--count")]
    public void WrongArgumentsAreOneLine(string args, string part) =>
        DemoRun.Of(args.Split(' ')).AssertRefused(part);
}
