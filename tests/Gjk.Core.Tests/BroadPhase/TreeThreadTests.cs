namespace Gjk.Core.Tests.BroadPhase;

/// <summary>The tree's pairs are those of the boxes, however many threads move its leaves and look them up.</summary>
public class TreeThreadTests
{
    private const int Frames = 30;

    public static TheoryData<string> Kinds => [.. WorstBoxes.Sparse, "room"];

    /// <summary>A part of the boxes moves in each frame, small steps and far ones, so that leaves stay in their
    /// subtrees and leave them.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void PairsAreThoseOfTheBoxes(string kind)
    {
        const int Count = 1200;
        using var workers = new Workers(3);
        var rng = new Rng(77);
        Aabb[] boxes = kind == "room" ? Room(rng, Count) : Boxes(kind, Count);
        DynamicAabbTree serial = new(), parallel = new();
        for (int i = 0; i < Count; i++)
        {
            serial.Add(i, boxes[i]);
            parallel.Add(i, boxes[i]);
        }

        List<ObjectPair> expected = [], found = [];
        List<int> inBox = [];
        for (int frame = 0; frame < Frames; frame++)
        {
            int[] ids = [.. Enumerable.Range(0, Count).Where(_ => rng.Below(frame % 4 == 0 ? 2 : 6) == 0)];
            Aabb[] moved = [.. ids.Select(id => Moved(rng, boxes[id]))];
            for (int i = 0; i < ids.Length; i++)
            {
                boxes[ids[i]] = moved[i];
                serial.Move(ids[i], moved[i]);
                if (i % 7 == 0) ids[i] = ~ids[i];
            }

            parallel.MoveAll(ids, moved, ids.Length, workers);
            for (int i = 0; i < ids.Length; i += 7) parallel.Move(~ids[i], moved[i]);
            float margin = frame % 3 == 0 ? 0.1f : 0;
            serial.CollectPairs(margin, expected);
            parallel.CollectPairs(margin, found, workers);
            AssertSame(expected, found);
            AssertSame(Near(boxes, margin), found);
            int one = rng.Below(Count);
            parallel.CollectInBox(boxes[one], inBox);
            Assert.Equal(Enumerable.Range(0, Count).Where(i => boxes[i].Overlaps(boxes[one])), inBox);
            Check(parallel.Leaves.Tree);
        }
    }

    /// <summary>The comparison of the test library, which tells the difference, is slow, so it is for what differs.
    /// </summary>
    private static void AssertSame(List<ObjectPair> expected, List<ObjectPair> found)
    {
        if (!expected.SequenceEqual(found)) Assert.Equal(expected, found);
    }

    /// <summary>Each inner box is that of its children, and the number of leaves is right.</summary>
    private static void Check(AabbTree tree)
    {
        var waiting = new Stack<int>();
        waiting.Push(tree.Root);
        HashSet<int> seen = [];
        while (waiting.TryPop(out int at))
        {
            if (!seen.Add(at)) Assert.Fail("a node is met twice");
            if (at < tree.Capacity) continue;
            AabbNode box = tree.Node(at), left = tree.Node(box.Left), right = tree.Node(box.Right);
            bool isJoined = Vector3.Min(left.Min, right.Min).Equals(box.Min)
                && Vector3.Max(left.Max, right.Max).Equals(box.Max);
            if (!isJoined) Assert.Fail($"{box.Min} to {box.Max} is not the box of its children");
            waiting.Push(box.Left);
            waiting.Push(box.Right);
        }

        Assert.Equal(1200, seen.Count(node => node < tree.Capacity));
    }

    private static Aabb Moved(Rng rng, Aabb box)
    {
        float size = (box.Max - box.Min).Length();
        if (size > 1e30f || box.Max.Length() > 1e30f) return box;
        Vector3 step = rng.Below(20) == 0 ? rng.Vector(-9, 9) : size * rng.Vector(-0.3, 0.3);
        return new Aabb(box.Min + step, box.Max + step);
    }

    private static List<ObjectPair> Near(Aabb[] boxes, float margin)
    {
        List<ObjectPair> pairs = [];
        for (int a = 0; a < boxes.Length; a++)
            for (int b = a + 1; b < boxes.Length; b++)
                if (BoundsTable.Near(boxes[a], boxes[b], margin)) pairs.Add(new ObjectPair(a, b));
        return pairs;
    }

    private static Aabb[] Boxes(string kind, int count)
    {
        var boxes = new WorstBoxes(kind, count);
        return [.. Enumerable.Range(0, count).Select(boxes.Box)];
    }

    private static Aabb[] Room(Rng rng, int count)
    {
        Vector3[] corners = [.. Enumerable.Range(0, count).Select(_ => rng.Vector(0, 15))];
        return [.. corners.Select(corner => new Aabb(corner, corner + Vector3.One))];
    }
}
