namespace Gjk.Core;

/// <summary>The broad phase that keeps a tree of boxes a little larger than asked for. While an object stays in its
/// larger box nothing but that is checked; the pairs of the larger boxes are kept too, and each frame's answer is those
/// of them whose own boxes overlap.</summary>
/// <remarks>Mutable and not thread-safe. Time grows with n log n and the number of pairs, and by a factor of a few with
/// motion; long and thin, equal, nested and very unequal boxes included. Memory grows with the largest number, with n,
/// and with the number of pairs of the largest answer.</remarks>
public sealed class DynamicAabbTree : IBroadPhase
{
    private readonly BoundsTable _table = new();
    private readonly FatLeaves _leaves;
    private readonly KeptPairs _pairs;

    /// <summary>Makes an empty broad phase.</summary>
    public DynamicAabbTree()
    {
        _leaves = new FatLeaves(_table);
        _pairs = new KeptPairs(_table, _leaves);
    }

    /// <inheritdoc/>
    public int Count => _table.Count;

    /// <summary>The parts, for the tests of cost.</summary>
    internal FatLeaves Leaves => _leaves;

    /// <inheritdoc cref="Leaves"/>
    internal KeptPairs Pairs => _pairs;

    /// <inheritdoc/>
    public void Add(int id, in Aabb bounds)
    {
        _table.CheckNew(id);
        _table.Reserve(id);
        _leaves.Reserve(_table.Boxes.Length);
        _pairs.Reserve(_table.Boxes.Length);
        _table.Add(id, bounds);
        _leaves.Add(id);
        _pairs.Moved.Add(id);
    }

    /// <inheritdoc/>
    public void Move(int id, in Aabb bounds)
    {
        _table.Check(id);
        _leaves.Move(id, _table.Boxes[id], bounds);
        _table.Boxes[id] = bounds;
        _pairs.Moved.Add(id);
    }

    /// <inheritdoc/>
    public void Remove(int id)
    {
        _table.Remove(id);
        _leaves.Remove(id);
        _pairs.Remove();
    }

    /// <inheritdoc/>
    public void Clear()
    {
        _table.Clear();
        _leaves.Clear();
        _pairs.Clear();
    }

    /// <inheritdoc/>
    public void CollectPairs(float margin, List<ObjectPair> pairs)
    {
        BoundsTable.CheckQuery(margin, pairs);
        PairKeys found = _pairs.Find(margin);

        // Where most have moved, marks cost more than they spare.
        bool isMarking = _pairs.Moved.Count <= _table.Count / 2;
        if (isMarking) CollectMarked(found, margin, pairs);
        else CollectNear(found, margin, pairs);
        _pairs.Note(found, isMarking ? margin : float.NaN, pairs.Count);
    }

    private void CollectNear(PairKeys found, float margin, List<ObjectPair> pairs)
    {
        for (int i = 0; i < found.Count; i++)
        {
            int a = PairKeys.First(found.Keys[i]), b = PairKeys.Second(found.Keys[i]);
            if (BoundsTable.Near(_table.Boxes[a], _table.Boxes[b], margin)) pairs.Add(new ObjectPair(a, b));
        }
    }

    /// <summary>The same, with a look only at the pairs of what has moved, or that have no marks yet.</summary>
    private void CollectMarked(PairKeys found, float margin, List<ObjectPair> pairs)
    {
        bool areMarked = _pairs.KeepMarks(found, margin);
        bool[] moved = _pairs.Moved.Has;
        for (int i = 0; i < found.Count; i++)
        {
            ref ulong key = ref found.Keys[i];
            int a = PairKeys.First(key), b = PairKeys.Second(key);
            if (!areMarked || moved[a] || moved[b])
                key = PairKeys.Marked(key, BoundsTable.Near(_table.Boxes[a], _table.Boxes[b], margin));
            if (PairKeys.IsMarked(key)) pairs.Add(new ObjectPair(a, b));
        }
    }

    /// <inheritdoc/>
    public void CollectInBox(in Aabb box, List<int> ids)
    {
        Guard.NotNull(ids, nameof(ids)).Clear();
        UpdateLeaves();
        _leaves.Tree.Query(box.Min, box.Max, ids);
        int kept = 0;
        for (int i = 0; i < ids.Count; i++)
            if (_table.Boxes[ids[i]].Overlaps(box)) ids[kept++] = ids[i];
        ids.RemoveRange(kept, ids.Count - kept);
        InPlaceSort.Sort(ids);
    }

    /// <inheritdoc/>
    public void Sweep<TVisitor>(in SweptBox path, ref TVisitor visitor)
        where TVisitor : struct, ISweepVisitor
    {
        UpdateLeaves();
        _leaves.Tree.Sweep(path, _table.Boxes, ref visitor);
    }

    /// <summary>Makes the tree ready. Until the next change, sweeps change nothing, so several threads may make
    /// them.</summary>
    internal void UpdateLeaves() => _pairs.UpdateLeaves();
}
