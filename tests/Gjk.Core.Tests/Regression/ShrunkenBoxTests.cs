namespace Gjk.Core.Tests.Regression;

/// <summary>A box that became much smaller kept its leaf, so that it stayed the neighbour of all that it had been
/// near.</summary>
public class ShrunkenBoxTests
{
    private const int Side = 30;
    private const int Objects = Side * Side;

    [Theory]
    [InlineData(0.01f)]
    [InlineData(0)]
    public void ItHasTheNeighboursOfASmallBox(float size)
    {
        var phase = new DynamicAabbTree();
        List<ObjectPair> pairs = [];
        List<int> ids = [];
        for (int i = 0; i < Objects; i++) phase.Add(i, At(i, 100));
        phase.CollectPairs(0, pairs);
        Assert.Equal(Objects * (Objects - 1) / 2, pairs.Count);
        for (int i = 0; i < Objects; i++) phase.Move(i, At(i, size));
        long before = phase.Leaves.Tree.Visits;
        phase.CollectInBox(At(5, size), ids);
        Assert.Equal([5], ids);
        Assert.InRange(phase.Leaves.Tree.Visits - before, 1, 100);
        phase.CollectPairs(0, pairs);
        Assert.Empty(pairs);
        Assert.Equal(0, phase.Pairs.Count);
    }

    /// <summary>A little smaller than makes a new leaf: then too many pairs are found, and all leaves are built
    /// anew.</summary>
    [Fact]
    public void MoreThanAFewPairsForEachAreNeverKept()
    {
        var phase = new DynamicAabbTree();
        List<ObjectPair> pairs = [];
        for (int round = 0; round < 5; round++)
        {
            // Plates that all overlap, turned into rods that do not, each as long as its plate.
            for (int i = 0; i < Objects; i++)
            {
                var plate = new Aabb(new Vector3(0, 0, -5), new Vector3(100, 50, 5));
                if (round == 0) phase.Add(i, plate);
                else phase.Move(i, plate);
            }

            phase.CollectPairs(0, pairs);
            Assert.Equal(Objects * (Objects - 1) / 2, pairs.Count);
            for (int i = 0; i < Objects; i++)
            {
                float y = 0.05f * i;
                phase.Move(i, new Aabb(new Vector3(0, y, 0), new Vector3(100, y + 0.02f, 0)));
            }

            for (int question = 0; question < 3; question++)
            {
                phase.CollectPairs(0, pairs);
                Assert.Empty(pairs);
                if (question > 0) Assert.InRange(phase.Pairs.Count, 0, PairBudget.PairsPerPair * Objects);
            }
        }
    }

    private static Aabb At(int i, float size)
    {
        var center = new Vector3(i % Side, i / Side, 0);
        return new Aabb(center - new Vector3(size / 2), center + new Vector3(size / 2));
    }
}
