using Gjk.Core.Tests.BroadPhase;

namespace Gjk.Core.Tests.Regression;

/// <summary>A number that no array can hold was refused by the runtime, after part of it was done.</summary>
public class ObjectNumberTests
{
    private static readonly Aabb Unit = new(Vector3.Zero, Vector3.One);

    public static TheoryData<BroadPhaseKind> Kinds => BroadPhaseTests.Kinds;

    [Theory]
    [MemberData(nameof(Kinds))]
    public void ANumberThatIsTooLargeIsRefusedAndChangesNothing(BroadPhaseKind kind)
    {
        IBroadPhase phase = BroadPhaseTests.Create(kind);
        phase.Add(0, Unit);
        long before = GC.GetAllocatedBytesForCurrentThread();
        foreach (int id in new[] { int.MaxValue, int.MaxValue - 1, 1 << 30, 1 << 24 })
            Assert.Equal("id", Assert.Throws<ArgumentOutOfRangeException>(() => phase.Add(id, Unit)).ParamName);
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 1 << 20);
        Assert.Equal(1, phase.Count);
        phase.Add(1, Unit);
        List<ObjectPair> pairs = [];
        phase.CollectPairs(0, pairs);
        Assert.Equal([new(0, 1)], pairs);
    }

    /// <summary>The largest number takes 2 GB, so with GJK_LONG alone.</summary>
    [Fact]
    public void TheLargestNumberCanBeUsed()
    {
        int id = Support.Budget.Count(1) > 1 ? (1 << 24) - 1 : 1 << 18;
        foreach (BroadPhaseKind kind in new[] { BroadPhaseKind.DynamicTree, BroadPhaseKind.SortAndSweep })
        {
            IBroadPhase phase = BroadPhaseTests.Create(kind);
            phase.Add(0, Unit);
            phase.Add(id, Unit);
            List<ObjectPair> pairs = [];
            phase.CollectPairs(0, pairs);
            Assert.Equal([new(0, id)], pairs);
        }
    }
}
