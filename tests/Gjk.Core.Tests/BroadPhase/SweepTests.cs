namespace Gjk.Core.Tests.BroadPhase;

/// <summary>Every broad phase shows exactly the boxes that a path meets, each once, and none that is out of the
/// limit.</summary>
public class SweepTests
{
    public static TheoryData<BroadPhaseKind> Kinds => BroadPhaseTests.Kinds;

    [Theory]
    [MemberData(nameof(Kinds))]
    public void TheBoxesAreThoseThatThePathMeets(BroadPhaseKind kind)
    {
        int hits = 0, paths = 0;
        foreach (int count in new[] { 0, 1, 2, 30, 300 })
        {
            var rng = new Rng((ulong)count);
            IBroadPhase phase = BroadPhaseTests.Create(kind);
            SortedDictionary<int, Aabb> boxes = [];
            float side = 2.2f * MathF.Cbrt(count + 1);
            for (int i = 0; i < count; i++) phase.Add(i, boxes[i] = Box(rng, side));
            for (int frame = 0; frame < 20; frame++)
            {
                Change(rng, phase, boxes, side);
                for (int k = 0; k < 10; k++)
                {
                    SweptBox path = Path(rng, side);
                    string message = $"{kind}, {count} boxes, frame {frame}, path {k}";
                    int[] expected =
                        [.. boxes.Where(b => path.Meets(b.Value, path.Limit, out _)).Select(b => b.Key)];
                    var all = new Recorder([]);
                    phase.Sweep(path, ref all);
                    Assert.True(expected.SequenceEqual(all.Ids.Order()), message);
                    if (count > 2) (hits, paths) = (hits + (expected.Length > 0 ? 1 : 0), paths + 1);
                    CheckFirst(phase, boxes, path, expected, message);
                }
            }
        }

        Assert.InRange((double)hits / paths, 0.3, 0.9);
    }

    /// <summary>Objects that came and went between two questions leave nothing behind.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void APhaseThatWasEmptiedCanBeAsked(BroadPhaseKind kind)
    {
        var unit = new Aabb(Vector3.Zero, Vector3.One);
        foreach (bool isSwept in new[] { true, false })
        {
            IBroadPhase phase = BroadPhaseTests.Create(kind);
            phase.Add(3, unit);
            phase.Remove(3);
            List<int> ids = [];
            var all = new Recorder(ids);
            if (isSwept) phase.Sweep(new SweptBox(unit, Vector3.One), ref all);
            else phase.CollectInBox(unit, ids);
            Assert.Empty(ids);
            phase.Add(4, unit);
            phase.Sweep(new SweptBox(unit, Vector3.One), ref all);
            Assert.Equal([4], ids);
        }
    }

    /// <summary>In a room of 20,000 boxes the tree looks at few of them: at fewer where the path ends at the
    /// first.</summary>
    [Fact]
    public void TheTreeLooksAtFewBoxes()
    {
        const int Boxes = 20_000;
        var rng = new Rng(3);
        var phase = new DynamicAabbTree();
        float side = 1.8f * MathF.Cbrt(Boxes);
        var boxes = new Aabb[Boxes];
        for (int i = 0; i < Boxes; i++)
        {
            Vector3 min = rng.Vector(0, side);
            phase.Add(i, boxes[i] = new Aabb(min, min + Vector3.One));
        }

        Dictionary<int, Aabb> byId = Enumerable.Range(0, Boxes).ToDictionary(i => i, i => boxes[i]);
        long first = 0, all = 0;
        phase.UpdateLeaves();
        for (int i = 0; i < 200; i++)
        {
            var path = new SweptBox(rng.Vector(0, side), rng.UnitVector());
            var nearest = new Nearest(byId, path);
            first += phase.Leaves.Tree.Sweep(path, boxes, ref nearest);
            var recorder = new Recorder([]);
            all += phase.Leaves.Tree.Sweep(path, boxes, ref recorder);
        }

        Assert.InRange(first / 200.0, 10, 120);
        Assert.InRange(all / 200.0, first / 200.0 * 1.5, 1000);
    }

    /// <summary>The first box, with the limit shortened to each that is met: ties at the same entry are all
    /// shown.</summary>
    private static void CheckFirst(
        IBroadPhase phase, SortedDictionary<int, Aabb> boxes, SweptBox path, int[] expected, string message)
    {
        var nearest = new Nearest(boxes, path);
        phase.Sweep(path, ref nearest);
        if (expected.Length == 0)
        {
            Assert.True(nearest.Id < 0, message);
            return;
        }

        (double Entry, int Id) first = expected.Select(
            id => (path.Meets(boxes[id], path.Limit, out double entry) ? entry : 0, id)).Min();
        Assert.True(first == (nearest.Entry, nearest.Id), $"{message}: {nearest.Id}, not {first}");
    }

    private static void Change(Rng rng, IBroadPhase phase, SortedDictionary<int, Aabb> boxes, float side)
    {
        foreach (int id in boxes.Keys.ToArray())
        {
            int what = rng.Below(20);
            if (what == 0) phase.Remove(id);
            if (what == 0) boxes.Remove(id);
            else if (what < 8) phase.Move(id, boxes[id] = Box(rng, side));
        }

        for (int i = rng.Below(4); i > 0; i--)
        {
            int id = rng.Below(boxes.Count + 10);
            if (!boxes.ContainsKey(id)) phase.Add(id, boxes[id] = Box(rng, side));
        }
    }

    private static SweptBox Path(Rng rng, float side)
    {
        Aabb start = Box(rng, side);
        Vector3 motion = rng.Below(3) == 0 ? Vector3.UnitY * side : rng.UnitVector() * side;
        return rng.Below(4) switch
        {
            0 => new SweptBox(start, motion, rng.Float(0, 1)),
            1 => new SweptBox(start, rng.Below(4) == 0 ? default : motion),
            2 => new SweptBox(start.Min, motion),
            _ => new SweptBox(start.Max, motion, 0.5f),
        };
    }

    private static Aabb Box(Rng rng, float side)
    {
        Vector3 min = rng.Vector(0, side), size = rng.Vector(0.1, 1.5);
        if (rng.Below(2) == 0) min = new Vector3(MathF.Round(min.X), MathF.Round(min.Y), MathF.Round(min.Z));
        return new Aabb(min, min + (rng.Below(2) == 0 ? Vector3.One : size));
    }

    private readonly struct Recorder(List<int> ids) : ISweepVisitor
    {
        public List<int> Ids => ids;

        public double Visit(int id)
        {
            ids.Add(id);
            return double.PositiveInfinity;
        }
    }

    /// <summary>The box with the first entry; of several the one with the least number.</summary>
    private struct Nearest(IReadOnlyDictionary<int, Aabb> boxes, SweptBox path) : ISweepVisitor
    {
        public int Id = -1;
        public double Entry = double.PositiveInfinity;

        public double Visit(int id)
        {
            Assert.True(path.Meets(boxes[id], path.Limit, out double entry));
            if (entry < Entry || (entry == Entry && id < Id)) (Entry, Id) = (entry, id);
            return Entry;
        }
    }
}
