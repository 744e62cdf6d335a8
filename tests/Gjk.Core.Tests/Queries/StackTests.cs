namespace Gjk.Core.Tests.Queries;

/// <summary>Contract 15: no call takes more than 64 kilobytes of stack, and all that the library does can be done on a
/// thread that has 128. The child says what it does, so the last line of a failure names the work.</summary>
public class StackTests
{
    /// <summary>What the compiler makes of a debug build: every value has a place of its own on the stack.</summary>
    [Fact]
    public void NoCallTakesMoreBeforeOptimisation() => ChildProcess.Run("JITMinOpts", "1", StackProgram.Command);

    /// <summary>Everything is inlined that will be, so frames are fewer and larger.</summary>
    [Fact]
    public void NoCallTakesMoreWhenOptimisedAtOnce() =>
        ChildProcess.Run("TieredCompilation", "0", StackProgram.Command);

    [Fact]
    public void TheMeasureSeesWhatIsTaken() =>
        Assert.InRange(StackUse.Least(() => Take()), 40_000, 44_000);

    private static unsafe void Take()
    {
        byte* memory = stackalloc byte[40_000];
        for (int i = 0; i < 40_000; i++) memory[i] = 1;
    }
}
