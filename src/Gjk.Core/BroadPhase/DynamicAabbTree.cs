namespace Gjk.Core;

/// <summary>The broad phase that keeps a tree of boxes a little larger than asked for. While an object stays in its
/// larger box nothing but that is checked; the pairs of the larger boxes are kept too, and each frame's answer is those
/// of them whose own boxes overlap.</summary>
/// <remarks>Mutable and not thread-safe. Time grows with n log n and the number of pairs, and by a factor of a few with
/// motion; long and thin, equal, nested and very unequal boxes included. Memory grows with the largest number, with n,
/// and with the number of pairs of the largest answer.</remarks>
public sealed class DynamicAabbTree : IBroadPhase
{
    /// <summary>Count of objects that one thread moves in turn. A matter of speed only.</summary>
    private const int MovesInPart = 512;

    private readonly BoundsTable _table = new();
    private readonly Selection<ObjectPair> _near = new();

    /// <summary>By move of many: whether the object leaves its leaf.</summary>
    private bool[] _areLeaving = [];

    /// <summary>Makes an empty broad phase.</summary>
    public DynamicAabbTree()
    {
        Leaves = new FatLeaves(_table);
        Pairs = new KeptPairs(_table, Leaves);
    }

    /// <inheritdoc/>
    public int Count => _table.Count;

    /// <summary>The parts, for the tests of cost.</summary>
    internal FatLeaves Leaves { get; }

    /// <inheritdoc cref="Leaves"/>
    internal KeptPairs Pairs { get; }

    /// <inheritdoc/>
    public void Add(int id, in Aabb bounds)
    {
        _table.Reserve(id);
        Leaves.Reserve(_table.Boxes.Length);
        Pairs.Reserve(_table.Boxes.Length);
        _table.Add(id, bounds);
        Leaves.Add(id);
        Pairs.Moved.Add(id);
    }

    /// <inheritdoc/>
    public void Move(int id, in Aabb bounds)
    {
        _table.Check(id);
        if (Leaves.Leaves(id, bounds)) Leaves.Unplaced.Add(id);
        _table.Boxes[id] = bounds;
        Pairs.Moved.Add(id);
    }

    /// <summary>Moves many objects on several threads; those with negative numbers are left out.</summary>
    internal void MoveAll(int[] ids, Aabb[] bounds, int count, Workers? workers)
    {
        if (_areLeaving.Length < count) _areLeaving = new bool[ids.Length];
        Workers.Run(workers, new MoveJob(this, ids, bounds), count, MovesInPart);
        for (int i = 0; i < count; i++)
        {
            if (ids[i] < 0) continue;
            Pairs.Moved.Add(ids[i]);
            if (_areLeaving[i]) Leaves.Unplaced.Add(ids[i]);
        }
    }

    /// <inheritdoc/>
    public void Remove(int id)
    {
        _table.Remove(id);
        Leaves.Remove(id);
        Pairs.Remove();
    }

    /// <inheritdoc/>
    public void Clear()
    {
        _table.Clear();
        Leaves.Clear();
        Pairs.Clear();
    }

    /// <inheritdoc/>
    public void CollectPairs(float margin, List<ObjectPair> pairs) => CollectPairs(margin, pairs, null);

    /// <summary>The same on several threads.</summary>
    /// <param name="margin">At least 0; may be infinite.</param>
    /// <param name="pairs">Emptied first; then the pairs, A less than B, sorted by (A, B).</param>
    /// <param name="workers">The threads to use; null for the caller's own.</param>
    /// <exception cref="ArgumentOutOfRangeException">The margin is negative or NaN.</exception>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    /// <exception cref="InvalidOperationException">There are more than 1,073,741,824 pairs. The list is left empty; the
    /// broad phase is as it was.</exception>
    /// <exception cref="ObjectDisposedException">The workers were disposed of.</exception>
    public void CollectPairs(float margin, List<ObjectPair> pairs, Workers? workers)
    {
        BoundsTable.CheckQuery(margin, pairs);
        Workers.Check(workers);
        PairKeys found = Pairs.Find(margin, workers);

        // Where most have moved, marks cost more than they spare.
        bool isMarking = Pairs.Moved.Count <= _table.Count / 2;
        bool areMarked = isMarking && Pairs.KeepMarks(found, margin);
        var near = new NearPairs(
            _table.Boxes, found.Keys, margin, isMarking, areMarked ? Pairs.Moved.Contains : null);
        _near.Collect(near, found.Count, pairs, workers);
        Pairs.RememberAnswer(found, isMarking ? margin : float.NaN, pairs.Count);
    }

    /// <inheritdoc/>
    public void CollectInBox(in Aabb box, List<int> ids)
    {
        Guard.NotNull(ids, nameof(ids)).Clear();
        UpdateLeaves();
        Leaves.Tree.Query(box.Min, box.Max, ids);
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
        Leaves.Tree.Sweep(path, _table.Boxes, ref visitor);
    }

    /// <summary>Makes the tree ready. Until the next change, sweeps change nothing, so several threads may make
    /// them.</summary>
    internal void UpdateLeaves() => Pairs.UpdateLeaves();

    private readonly struct MoveJob(DynamicAabbTree tree, int[] ids, Aabb[] bounds) : IShareJob
    {
        public void Run(int begin, int end)
        {
            for (int i = begin; i < end; i++)
            {
                if (ids[i] < 0) continue;
                tree._areLeaving[i] = tree.Leaves.Leaves(ids[i], bounds[i]);
                tree._table.Boxes[ids[i]] = bounds[i];
            }
        }
    }
}
