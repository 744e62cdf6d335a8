using Gjk.Core.Tests.BroadPhase;

namespace Gjk.Core.Tests.Regression;

/// <summary>The tree kept all pairs of one question about an infinite distance, and kept them up to date in every later
/// question, even in those about a box.</summary>
public class UnusualMarginTests
{
    private const int Objects = 1000;

    private readonly WorstBoxes _boxes = new("cubes", Objects);
    private readonly DynamicAabbTree _phase = new();
    private readonly List<ObjectPair> _pairs = [];
    private readonly List<int> _ids = [];

    public UnusualMarginTests() => _boxes.AddTo(_phase);

    private long Visits => _phase.Leaves.Tree.Visits;

    [Theory]
    [InlineData(float.PositiveInfinity)]
    [InlineData(1e30f)]
    public void ItIsNotKept(float margin)
    {
        Ask(margin, Objects * (Objects - 1) / 2);
        Assert.Equal(0, _phase.Pairs.Count);
        Ask(0);
        Assert.InRange(_phase.Pairs.Count, 1, 4 * Objects);
    }

    [Fact]
    public void TheKeptPairsOutliveIt()
    {
        Ask(0);
        int kept = _phase.Pairs.Count;
        Ask(float.PositiveInfinity, Objects * (Objects - 1) / 2);
        Assert.Equal(kept, _phase.Pairs.Count);
        long before = Visits;
        Ask(0);
        Assert.Equal(before, Visits);
    }

    [Fact]
    public void ItIsKeptWhereItIsUsual()
    {
        for (int i = 0; i < 3; i++) Ask(float.PositiveInfinity, Objects * (Objects - 1) / 2);
        Assert.Equal(Objects * (Objects - 1) / 2, _phase.Pairs.Count);
        long before = Visits;
        Ask(float.PositiveInfinity, Objects * (Objects - 1) / 2);
        Assert.Equal(before, Visits);

        // One question about touching boxes is enough to show that all pairs are too many.
        Ask(0);
        Ask(0);
        Assert.InRange(_phase.Pairs.Count, 1, 4 * Objects);
    }

    [Fact]
    public void TwoUsualMarginsShareTheKeptPairs()
    {
        Ask(0.2f);
        Ask(0);
        long before = Visits;
        for (int i = 0; i < 30; i++) Ask(i % 2 * 0.2f);
        Assert.Equal(before, Visits);
    }

    [Fact]
    public void AQuestionAboutABoxFindsNoPairs()
    {
        Ask(float.PositiveInfinity, Objects * (Objects - 1) / 2);
        Ask(0);
        for (int frame = 0; frame < 100; frame++)
        {
            _boxes.Step(0);
            _boxes.MoveIn(_phase);
            long before = Visits;
            _phase.CollectInBox(_boxes.Box(frame), _ids);
            Assert.Contains(frame, _ids);
            Assert.InRange(Visits - before, 1, Objects / 2);
        }

        Assert.InRange(_phase.Pairs.Unpaired.Count, 1, Objects);
        Ask(0);
        Assert.Equal(0, _phase.Pairs.Unpaired.Count);
    }

    private void Ask(float margin, int? expected = null)
    {
        _phase.CollectPairs(margin, _pairs);
        if (expected is not null) Assert.Equal(expected, _pairs.Count);
        Assert.True(_pairs.SequenceEqual(_pairs.Order()));
    }
}
