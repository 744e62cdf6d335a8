using Gjk.Core.Tests.BroadPhase;

namespace Gjk.Core.Tests.Regression;

/// <summary>While nothing was asked, each object that was removed and added again was queued once more, for
/// ever.</summary>
public class UnaskedChangeTests
{
    private const int Objects = 100;
    private const int Rounds = 2000;

    public static TheoryData<BroadPhaseKind> Kinds => BroadPhaseTests.Kinds;

    [Theory]
    [MemberData(nameof(Kinds))]
    public void ChangesWithoutAQuestionNeedNoMemory(BroadPhaseKind kind)
    {
        IBroadPhase phase = BroadPhaseTests.Create(kind);
        List<ObjectPair> pairs = [];
        List<int> ids = [];
        for (int i = 0; i < Objects; i++) phase.Add(i, At(i));
        phase.CollectPairs(0, pairs);
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int round = 0; round < Rounds; round++)
        {
            for (int i = 0; i < Objects; i++)
            {
                phase.Move(i, At(i + round));
                phase.Remove(i);
                phase.Add(i, At(i - round));
            }

            // A question about a box alone leaves the pairs waiting.
            if (round % 100 == 0) phase.CollectInBox(At(0), ids);
        }

        // The lists of a few hundred ids may grow once.
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 10_000);
        phase.CollectPairs(0, pairs);
        Assert.Equal(Objects - 1, pairs.Count);
    }

    private static Aabb At(float x) => new(new Vector3(x, 0, 0), new Vector3(x + 1, 1, 1));
}
