using System;

namespace Gjk.Unity.Checks;

/// <summary>Both components allocate nothing per frame, objects that come near and leave included.</summary>
[Collection(nameof(OneScene))]
public class FrameAllocationTests
{
    private const int WarmUpFrames = 200, Frames = 200, Attempts = 3;

    [Fact]
    public void AFrameAllocatesNothing()
    {
        using var load = new FrameLoad();
        for (int i = 0; i < WarmUpFrames; i++) load.Frame();
        Assert.True(load.Near.Least < load.Near.Most && load.Near.Most > 2, $"near: {load.Near}");
        Assert.Null(load.Distance.Problem);
        long least = long.MaxValue;
        for (int attempt = 0; attempt < Attempts; attempt++)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int i = 0; i < Frames; i++) load.Frame();
            least = Math.Min(least, GC.GetAllocatedBytesForCurrentThread() - before);
        }

        Assert.Equal(0, least);
    }
}
