using Gjk.Core.Tests.BroadPhase;

namespace Gjk.Core.Tests.Regression;

/// <summary>More pairs than an array holds ended in an overflow, and left a broad phase that gave wrong
/// pairs.</summary>
public class TooManyPairsTests
{
    private const int Limit = 100;

    public static TheoryData<BroadPhaseKind> Kinds => BroadPhaseTests.Kinds;

    [Theory]
    [MemberData(nameof(Kinds))]
    public void TheyAreOneClearExceptionAndTheBroadPhaseStaysUsable(BroadPhaseKind kind)
    {
        IBroadPhase phase = Create(kind);
        List<ObjectPair> pairs = [];

        // By one question; by a margin; and by objects that come to those that are there.
        for (int i = 0; i < 15; i++) phase.Add(i, At(0));
        Refuses(phase, 0, pairs);
        for (int i = 0; i < 15; i++) phase.Move(i, At(i));
        Finds(phase, 14);
        Refuses(phase, 20, pairs);
        Finds(phase, 14);
        for (int i = 15; i < 28; i++)
        {
            phase.Add(i, At(i));
            Finds(phase, i);
        }

        for (int i = 20; i < 28; i++) phase.Move(i, At(7));
        Finds(phase, 20 + 28 + 8 * 2 - 1, 8 * 3 + 28 + 19);
        for (int i = 0; i < 6; i++) phase.Move(i, At(7));
        Refuses(phase, 0, pairs);
        Refuses(phase, 0, pairs);
        for (int i = 0; i < 28; i++) phase.Move(i, At(i));
        Finds(phase, 27);
    }

    [Fact]
    public void CapacitiesDoNotOverflow()
    {
        Assert.Equal(16, BoundsTable.Grown(0, 3));
        Assert.Equal(2_000_000_000, BoundsTable.Grown(1_000_000_000, 5));
        Assert.Equal(0x7FFFFFC7, BoundsTable.Grown(1 << 30, 1 << 30));
        Assert.Equal(0x7FFFFFC7, BoundsTable.Grown(0x7FFFFFC7, 0x7FFFFFC6));
    }

    private static IBroadPhase Create(BroadPhaseKind kind)
    {
        IBroadPhase phase = BroadPhaseTests.Create(kind);
        switch (phase)
        {
            case SortAndSweep sweep:
                sweep.PairLimit = Limit;
                break;
            case DynamicAabbTree tree:
                tree.Pairs.PairLimit = Limit;
                break;
        }

        return phase;
    }

    private static void Refuses(IBroadPhase phase, float margin, List<ObjectPair> pairs)
    {
        var e = Assert.Throws<InvalidOperationException>(() => phase.CollectPairs(margin, pairs));
        Assert.Contains("100 pairs", e.Message);
        Assert.Empty(pairs);
    }

    private static void Finds(IBroadPhase phase, params int[] counts)
    {
        List<ObjectPair> pairs = [];
        phase.CollectPairs(0, pairs);
        Assert.Contains(pairs.Count, counts);
    }

    private static Aabb At(float x) => new(new Vector3(x, 0, 0), new Vector3(x + 1, 1, 1));
}
