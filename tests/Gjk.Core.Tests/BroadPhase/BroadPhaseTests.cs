namespace Gjk.Core.Tests.BroadPhase;

/// <summary>Every broad phase gives exactly the pairs whose boxes overlap, sorted, whatever was added, moved and
/// removed before.</summary>
public class BroadPhaseTests
{
    private const int Frames = 40;

    public static TheoryData<BroadPhaseKind> Kinds => [.. AllKinds];

    internal static BroadPhaseKind[] AllKinds => Enum.GetValues<BroadPhaseKind>();

    /// <summary>Few objects, so that most ties and empty cases happen; many, so that the radix sort, the bucket sort,
    /// the rebuilds and the growth do.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void PairsAreThoseOfTheBoxes(BroadPhaseKind kind)
    {
        int hits = 0, objects = 0;
        foreach ((int count, int seeds) in new[] { (0, 1), (1, 2), (2, 10), (12, 20), (150, 4), (700, 1) })
            for (int seed = 0; seed < Budget.Count(seeds); seed++)
                Run(kind, count, (ulong)(seed + 1000 * count), ref hits, ref objects);
        Assert.InRange((double)hits / objects, 0.3, 0.7);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void EqualAndTouchingBoxesArePairs(BroadPhaseKind kind)
    {
        IBroadPhase phase = Create(kind);
        var unit = new Aabb(Vector3.Zero, Vector3.One);
        for (int i = 0; i < 100; i++) phase.Add(i, unit);
        phase.Add(100, new Aabb(new Vector3(1, -5, -5), new Vector3(2, 5, 5)));
        phase.Add(101, new Aabb(new Vector3(-1, 0, 0), new Vector3(-0f, 1, 1)));
        List<ObjectPair> pairs = [];
        phase.CollectPairs(0, pairs);
        Assert.Equal(100 * 99 / 2 + 200, pairs.Count);
        phase.CollectPairs(1, pairs);
        Assert.Equal(102 * 101 / 2, pairs.Count);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void AnInfiniteMarginGivesAllPairsAndExtremeBoxesAreFine(BroadPhaseKind kind)
    {
        IBroadPhase phase = Create(kind);
        const float Max = float.MaxValue;
        phase.Add(0, new Aabb(new Vector3(-Max), new Vector3(Max)));
        phase.Add(3, new Aabb(new Vector3(Max), new Vector3(Max)));
        phase.Add(5, new Aabb(new Vector3(-Max), new Vector3(-Max)));
        phase.Add(7, default);
        phase.Add(2, new Aabb(Vector3.Zero, new Vector3(float.Epsilon)));
        List<ObjectPair> pairs = [];
        phase.CollectPairs(float.PositiveInfinity, pairs);
        Assert.Equal(10, pairs.Count);
        phase.CollectPairs(0, pairs);
        Assert.Equal([new(0, 2), new(0, 3), new(0, 5), new(0, 7), new(2, 7)], pairs);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void ADegenerateRowKeepsItsSpeed(BroadPhaseKind kind)
    {
        // Sorted input is the worst for a tree without balance, and one axis says nothing about the other two.
        IBroadPhase phase = Create(kind);
        List<ObjectPair> pairs = [];
        for (int i = 0; i < 2000; i++)
        {
            phase.Add(i, new Aabb(new Vector3(i, 0, 0), new Vector3(i + 1.5f, 1, 1)));
            if (i % 100 == 7) phase.CollectPairs(0, pairs);
        }

        phase.CollectPairs(0, pairs);
        Assert.Equal(1999, pairs.Count);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void BadCallsAreRefusedAndChangeNothing(BroadPhaseKind kind)
    {
        IBroadPhase phase = Create(kind);
        var unit = new Aabb(Vector3.Zero, Vector3.One);
        phase.Add(4, unit);
        phase.Add(2, unit);
        phase.Add(9, unit);
        phase.Remove(9);
        Assert.Equal("id", Assert.Throws<ArgumentOutOfRangeException>(() => phase.Add(-1, unit)).ParamName);
        Assert.Equal("id", Assert.Throws<ArgumentException>(() => phase.Add(4, unit)).ParamName);
        foreach (int id in new[] { -1, 0, 3, 9, 10, int.MaxValue, int.MinValue })
        {
            Assert.Equal("id", Assert.Throws<ArgumentOutOfRangeException>(() => phase.Move(id, unit)).ParamName);
            Assert.Equal("id", Assert.Throws<ArgumentOutOfRangeException>(() => phase.Remove(id)).ParamName);
        }

        List<ObjectPair> pairs = [new(7, 7)];
        foreach (float margin in new[] { -1, -float.Epsilon, float.NaN, float.NegativeInfinity })
            Assert.Equal(
                "margin",
                Assert.Throws<ArgumentOutOfRangeException>(() => phase.CollectPairs(margin, pairs)).ParamName);
        Assert.Equal([new(7, 7)], pairs);
        Assert.Equal("pairs", Assert.Throws<ArgumentNullException>(() => phase.CollectPairs(0, null!)).ParamName);
        Assert.Equal("ids", Assert.Throws<ArgumentNullException>(() => phase.CollectInBox(unit, null!)).ParamName);
        Assert.Equal(2, phase.Count);
        phase.CollectPairs(0, pairs);
        Assert.Equal([new(2, 4)], pairs);
    }

    internal static IBroadPhase Create(BroadPhaseKind kind) => kind switch
    {
        BroadPhaseKind.SortAndSweep => new SortAndSweep(),
        BroadPhaseKind.DynamicTree => new DynamicAabbTree(),
        _ => throw new ArgumentOutOfRangeException(nameof(kind), kind, "There is no class for this kind here."),
    };

    private static void Run(BroadPhaseKind kind, int count, ulong seed, ref int hits, ref int objects)
    {
        var rng = new Rng(seed);
        IBroadPhase phase = Create(kind);
        SortedDictionary<int, Aabb> boxes = [];
        float side = 1.9f * MathF.Cbrt(Math.Max(count, 1));
        List<ObjectPair> found = [];
        List<int> inBox = [];
        for (int frame = 0; frame < Frames; frame++)
        {
            Change(
                rng, phase, boxes, frame == 0 ? count : rng.Below(4) == 0 ? rng.Below(1 + count / 4) : rng.Below(2),
                side);
            // Margins come and go; then there are none for long enough that a kept one is given up.
            float margin = frame > 20 || rng.Below(3) > 0 ? 0
                : rng.Below(20) == 0 ? float.PositiveInfinity
                : rng.Float(0, 1);
            string message = $"{kind}, {count} objects, seed {seed}, frame {frame}, margin {margin:R}";
            phase.CollectPairs(margin, found);
            Assert.True(Expected(boxes, margin).SequenceEqual(found), message);
            Assert.True(boxes.Count == phase.Count, message);
            if (margin == 0)
            {
                hits += MovingWorld.Touched(found);
                objects += boxes.Count;
            }

            Aabb place = Box(rng, side);
            phase.CollectInBox(place, inBox);
            Assert.True(boxes.Where(b => b.Value.Overlaps(place)).Select(b => b.Key).SequenceEqual(inBox), message);
        }
    }

    /// <summary>Adds some, removes about as many (sometimes all, sometimes only to add them again), and moves the
    /// others a little; now and then everything jumps.</summary>
    private static void Change(Rng rng, IBroadPhase phase, SortedDictionary<int, Aabb> boxes, int changes, float side)
    {
        if (rng.Below(60) == 0)
        {
            phase.Clear();
            changes += boxes.Count;
            boxes.Clear();
        }

        bool jump = rng.Below(15) == 0, rest = rng.Below(4) == 0;
        foreach (int id in boxes.Keys.ToArray())
        {
            if (rest && rng.Below(10) > 0) continue;
            boxes[id] = jump ? Box(rng, side) : Shifted(boxes[id], rng.Vector(-0.02, 0.02), rng.Float(0, 0.02));
            phase.Move(id, boxes[id]);
        }

        for (int i = 0; i < changes; i++)
        {
            if (boxes.Count > 0 && rng.Below(2) == 0) Remove(rng, phase, boxes, side);
            int id = rng.Below(2 * boxes.Count + 3);
            if (boxes.ContainsKey(id)) continue;
            boxes[id] = Box(rng, side);
            phase.Add(id, boxes[id]);
        }
    }

    private static void Remove(Rng rng, IBroadPhase phase, SortedDictionary<int, Aabb> boxes, float side)
    {
        int id = boxes.Keys.ElementAt(rng.Below(boxes.Count));
        phase.Remove(id);
        boxes.Remove(id);
        if (rng.Below(2) != 0) return;
        boxes[id] = Box(rng, side);
        phase.Add(id, boxes[id]);
        if (rng.Below(2) == 0) phase.Move(id, boxes[id] = Box(rng, side));
    }

    private static List<ObjectPair> Expected(SortedDictionary<int, Aabb> boxes, float margin)
    {
        KeyValuePair<int, Aabb>[] all = [.. boxes];
        List<ObjectPair> pairs = [];
        for (int i = 0; i < all.Length; i++)
        {
            for (int j = i + 1; j < all.Length; j++)
            {
                (Aabb a, Aabb b) = (all[i].Value, all[j].Value);
                if (Meet(a.Min.X, a.Max.X, b.Min.X, b.Max.X, margin)
                    && Meet(a.Min.Y, a.Max.Y, b.Min.Y, b.Max.Y, margin)
                    && Meet(a.Min.Z, a.Max.Z, b.Min.Z, b.Max.Z, margin))
                    pairs.Add(new ObjectPair(all[i].Key, all[j].Key));
            }
        }

        return pairs;
    }

    private static bool Meet(float minA, float maxA, float minB, float maxB, float margin) =>
        minA <= maxB + margin && minB <= maxA + margin;

    /// <summary>Half of them on a coarse grid, where ends coincide.</summary>
    private static Aabb Box(Rng rng, float side)
    {
        bool grid = rng.Below(2) == 0;
        Vector3 min = rng.Vector(0, side), size = rng.Vector(0.3, 1.7);
        if (!grid) return new Aabb(min, min + size);
        min = new Vector3(MathF.Round(min.X), MathF.Round(min.Y), MathF.Round(min.Z));
        return new Aabb(min, min + new Vector3(rng.Below(2), rng.Below(3), rng.Below(2)));
    }

    private static Aabb Shifted(in Aabb box, Vector3 by, float growth)
    {
        Vector3 min = box.Min + by - new Vector3(growth);
        return new Aabb(min, Vector3.Max(min, box.Max + by));
    }
}
