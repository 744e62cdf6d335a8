namespace Gjk.Core.Tests.BroadPhase;

/// <summary>Boxes with sides from 1e-38 to the largest float, beside each other: every broad phase finds the pairs, the
/// boxes in a box and those on a path that comparing all of them finds.</summary>
public class ExtremeBoxTests
{
    private const int Frames = 12, Paths = 10;

    private const float Most = float.MaxValue;

    public static TheoryData<BroadPhaseKind> Kinds => BroadPhaseTests.Kinds;

    [Theory]
    [MemberData(nameof(Kinds))]
    public void WhatIsFoundIsWhatComparingAllFinds(BroadPhaseKind kind)
    {
        int hits = 0, asked = 0;
        for (int seed = 0; seed < Budget.Count(20); seed++)
        {
            var rng = new Rng((ulong)seed);
            IBroadPhase phase = BroadPhaseTests.Create(kind);
            var boxes = new Aabb[2 + rng.Below(60)];
            for (int i = 0; i < boxes.Length; i++) phase.Add(i, boxes[i] = Box(rng));
            for (int frame = 0; frame < Frames; frame++)
            {
                string message = $"{kind}, seed {seed}, frame {frame}";
                for (int i = 0; i < boxes.Length; i++)
                    if (rng.Below(4) == 0) phase.Move(i, boxes[i] = Box(rng));
                CheckPairs(phase, boxes, rng, message);
                CheckBox(phase, boxes, Box(rng), message);
                for (int k = 0; k < Paths; k++, asked += boxes.Length)
                    hits += CheckPath(phase, boxes, Path(rng), $"{message}, path {k}");
            }
        }

        Assert.InRange((double)hits / asked, 0.1, 0.7);
    }

    private static void CheckPairs(IBroadPhase phase, Aabb[] boxes, Rng rng, string message)
    {
        float margin = rng.Below(3) switch { 0 => 0, 1 => rng.LogFloat(1e-38, Most), _ => Most };
        List<ObjectPair> found = [];
        phase.CollectPairs(margin, found);
        IEnumerable<ObjectPair> expected =
            from a in Enumerable.Range(0, boxes.Length)
            from b in Enumerable.Range(a + 1, boxes.Length - a - 1)
            where BoundsTable.Near(boxes[a], boxes[b], margin)
            select new ObjectPair(a, b);
        Assert.True(expected.SequenceEqual(found), $"{message}, margin {margin:R}");
    }

    private static void CheckBox(IBroadPhase phase, Aabb[] boxes, Aabb place, string message)
    {
        List<int> found = [];
        phase.CollectInBox(place, found);
        Assert.True(Where(boxes, b => b.Overlaps(place)).SequenceEqual(found), $"{message}, in {place}");
    }

    private static int CheckPath(IBroadPhase phase, Aabb[] boxes, SweptBox path, string message)
    {
        int[] expected = [.. Where(boxes, b => path.Meets(b, path.Limit, out _))];
        Assert.Equal(expected, Where(boxes, b => path.MeetsScalar(b.Min, b.Max, path.Limit, out _)));
        var all = new Recorder([]);
        phase.Sweep(path, ref all);
        Assert.True(expected.SequenceEqual(all.Ids.Order()), message);
        return expected.Length;
    }

    private static IEnumerable<int> Where(Aabb[] boxes, Predicate<Aabb> isMeant) =>
        Enumerable.Range(0, boxes.Length).Where(i => isMeant(boxes[i]));

    private static SweptBox Path(Rng rng)
    {
        Vector3 motion = Vector(rng);
        return rng.Below(3) switch
        {
            0 => new SweptBox(Box(rng), motion),
            1 => new SweptBox(Vector(rng), motion),
            _ => new SweptBox(Vector(rng), motion, 1),
        };
    }

    /// <summary>Around the origin or beside it, with an exponent of its own along each axis.</summary>
    private static Aabb Box(Rng rng)
    {
        Vector3 half = Vector3.Abs(Vector(rng)), center = rng.Below(2) == 0 ? default : Vector(rng);
        var limit = new Vector3(Most);
        return new Aabb(Vector3.Max(center - half, -limit), Vector3.Min(center + half, limit));
    }

    private static Vector3 Vector(Rng rng) => new(Number(rng), Number(rng), Number(rng));

    private static float Number(Rng rng)
    {
        float size = rng.Below(4) switch
        {
            0 => Most,
            1 => 3e38f,
            2 => rng.Below(3),
            _ => (float)Math.Min(rng.Magnitude(1e-38, 1e39), Most),
        };
        return rng.Below(2) == 0 ? size : -size;
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
}
