namespace Gjk.Core.Tests.World;

/// <summary>A frame allocates nothing once the buffers have their size.</summary>
public class WorldAllocationTests
{
    private const int FewObjects = 60;
    private const int WarmUpFrames = 30;
    private const int Frames = 30;

    public static TheoryData<BroadPhaseKind> Scenes => CollisionSceneTests.Scenes;

    [Theory]
    [MemberData(nameof(Scenes))]
    public void NothingIsAllocatedOnOneThread(BroadPhaseKind kind)
    {
        Action frame = EveryFrame.Of(kind, null);
        for (int i = 0; i < WarmUpFrames; i++) frame();
        Assert.Equal(0, Allocation.Least(() =>
        {
            for (int i = 0; i < Frames; i++) frame();
        }));
    }

    /// <summary>Counts every thread of the process, so other tests must rest meanwhile.</summary>
    [Collection(nameof(Alone))]
    public class OnManyThreads
    {
        [Fact]
        public void NothingIsAllocatedInTotal()
        {
            using var workers = new Workers(2);
            Action frame = EveryFrame.Of(BroadPhaseKind.DynamicTree, workers, FewObjects);
            for (int i = 0; i < WarmUpFrames; i++) frame();

            Assert.True(Least(() => GC.KeepAlive(new byte[64])) >= 64, "the measure does not see an allocation");
            Assert.Equal(Least(() => { }), Least(frame));
        }

        /// <summary>What two runs, there and back, allocate in all threads, the measure's own included. The runtime and
        /// the test host allocate now and then too, hence many short tries; what the work allocates, it allocates in
        /// every one.</summary>
        private static long Least(Action work)
        {
            long least = long.MaxValue;
            for (int attempt = 0; attempt < 100; attempt++)
            {
                long before = GC.GetTotalAllocatedBytes(true);
                for (int i = 0; i < 2; i++) work();
                least = Math.Min(least, GC.GetTotalAllocatedBytes(true) - before);
            }

            return least;
        }
    }
}

/// <summary>Tests that no other test may run beside.</summary>
[CollectionDefinition(nameof(Alone), DisableParallelization = true)]
public class Alone;
