using Gjk.Core.Tests.BroadPhase;

namespace Gjk.Core.Tests.Regression;

/// <summary>The tree enlarged the box of a rod by a part of its length along all axes, so that rods that lie side by
/// side had all others as neighbours: 10,000 of them took seconds and gigabytes, 100,000 ended in an
/// overflow.</summary>
public class ThinBoxTests
{
    private const int Objects = 3000;

    /// <summary>Bytes: a rod needs some 300 in tables and nodes; each of the pairs that were kept was 8 to 32
    /// more.</summary>
    private const int MostBytesPerObject = 2000;

    [Theory]
    [InlineData("rods")]
    [InlineData("sliding rods")]
    [InlineData("flying rods")]
    [InlineData("rods in three directions")]
    [InlineData("plates")]
    [InlineData("plates and rods")]
    public void ThinBoxesThatDoNotTouchNeedLittleMemory(string kind)
    {
        foreach (BroadPhaseKind phaseKind in BroadPhaseTests.AllKinds)
        {
            var boxes = new WorstBoxes(kind, Objects);
            IBroadPhase phase = BroadPhaseTests.Create(phaseKind);
            List<ObjectPair> pairs = [];
            long before = GC.GetAllocatedBytesForCurrentThread();
            boxes.AddTo(phase);
            phase.CollectPairs(0, pairs);
            Assert.Empty(pairs);
            for (int frame = 0; frame < 8; frame++)
            {
                boxes.Step(frame);
                boxes.MoveIn(phase);
                phase.CollectPairs(0, pairs);
            }

            long bytes = (GC.GetAllocatedBytesForCurrentThread() - before) / Objects;
            Assert.True(bytes < MostBytesPerObject, $"{phaseKind}, {kind}: {bytes} bytes per object");
        }
    }

    /// <summary>A rod that falls keeps its leaf for some frames, though each step is longer than it is thick.</summary>
    [Fact]
    public void AThinBoxThatMovesKeepsItsLeafForSomeFrames()
    {
        var phase = new DynamicAabbTree();
        List<ObjectPair> pairs = [];
        int placed = 0;
        for (int i = 0; i < 100; i++) phase.Add(i, Plate(10 * i));
        for (int frame = 0; frame < 64; frame++)
        {
            phase.Move(0, Plate(-0.1f * frame));
            if (phase.Leaves.Unplaced.Count > 0) placed++;
            phase.CollectPairs(0, pairs);
        }

        Assert.InRange(placed, 64 / 9, 64 / 6);
    }

    private static Aabb Plate(float z) => new(new Vector3(-5, -5, z), new Vector3(5, 5, z + 0.01f));
}
