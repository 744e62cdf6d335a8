namespace Gjk.Core.Tests.BroadPhase;

/// <summary>What boxes of any arrangement cost the tree, counted in nodes and kept pairs, so that no clock is needed.
/// The pairs are those of boxes that are compared one by one.</summary>
public class WorstCaseTests
{
    /// <summary>Objects: a quadratic cost is 600 times n log n then.</summary>
    private const int Many = 8000;

    /// <summary>Objects, where every two are a pair.</summary>
    private const int Few = 500;
    private const int Frames = 40;

    public static TheoryData<string> Kinds => [.. WorstBoxes.Sparse, .. WorstBoxes.Dense];

    /// <summary>Nodes for each n log n and each true pair: twice the most that was measured, 10 for rods in three
    /// directions, which grow with n^1.5; cubes need 1.5.</summary>
    private const double MostVisits = 20;

    [Theory]
    [MemberData(nameof(Kinds))]
    public void TheTreeStaysNearNLogN(string kind)
    {
        var boxes = new WorstBoxes(kind, CountOf(kind));
        var phase = new DynamicAabbTree();
        boxes.AddTo(phase);
        List<ObjectPair> pairs = [];
        for (int frame = 0; frame <= Frames; frame++)
        {
            long before = phase.Leaves.Tree.Visits;
            phase.CollectPairs(0, pairs);
            string message = $"{kind}, frame {frame}, {pairs.Count} pairs";
            double visits = (phase.Leaves.Tree.Visits - before) / (NLogN(boxes.Count) + pairs.Count);
            Assert.True(visits <= MostVisits, $"{message}: {visits:0.0} visits");
            int kept = phase.Pairs.Count, depth = TreeDepth.Of(phase.Leaves.Tree);
            Assert.True(kept <= PairBudget.LimitFor(boxes.Count, pairs.Count), $"{message}: {kept} kept");
            Assert.True(depth <= AabbTree.MaxDepth, $"{message}: depth {depth}");
            boxes.Step(frame);
            boxes.MoveIn(phase);
        }
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void PairsAreThoseOfAllPairs(string kind)
    {
        var boxes = new WorstBoxes(kind, Few, 7);
        IBroadPhase[] phases = [new SortAndSweep(), new DynamicAabbTree()];
        foreach (IBroadPhase phase in phases) boxes.AddTo(phase);
        List<ObjectPair> found = [];
        List<int> foundIds = [];
        for (int frame = 0; frame < Budget.Few(100); frame++)
        {
            float margin = frame % 5 == 4 ? frame % 3 : 0;
            Aabb place = boxes.Box(frame % Few);
            List<ObjectPair> expected = [.. boxes.Pairs(margin)];
            int[] expectedIds = [.. Enumerable.Range(0, Few).Where(i => boxes.Box(i).Overlaps(place))];
            foreach (IBroadPhase phase in phases)
            {
                phase.CollectPairs(margin, found);
                string message = $"{kind}, frame {frame}, {phase.GetType().Name}";
                Assert.True(expected.SequenceEqual(found), message);
                phase.CollectInBox(place, foundIds);
                Assert.True(expectedIds.SequenceEqual(foundIds), message + ", in a box");
            }

            boxes.Step(frame);
            foreach (IBroadPhase phase in phases) boxes.MoveIn(phase);
        }
    }

    private static int CountOf(string kind) => WorstBoxes.Dense.Contains(kind) ? Few : Many;

    private static double NLogN(int n) => n * Math.Log2(n);
}
