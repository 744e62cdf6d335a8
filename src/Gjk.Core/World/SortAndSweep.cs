using System.Collections.Generic;

namespace Gjk.Core;

/// <summary>The broad phase that sorts the boxes along one axis, the one of largest spread, each time it is asked. It keeps nothing between frames, so motion of any size costs the same.</summary>
/// <remarks>Mutable and not thread-safe. In a cube of constant density the time grows with n^(5/3), in a long row with n log n.</remarks>
public sealed class SortAndSweep : IBroadPhase
{
    private readonly BoundsTable _table = new();
    private readonly AxisSweep _sweep = new();
    private readonly PairKeys _found = new();

    /// <inheritdoc/>
    public int Count => _table.Count;

    /// <inheritdoc/>
    public void Add(int id, in Aabb bounds) => _table.Add(id, bounds);

    /// <inheritdoc/>
    public void Move(int id, in Aabb bounds) => _table.Move(id, bounds);

    /// <inheritdoc/>
    public void Remove(int id) => _table.Remove(id);

    /// <inheritdoc/>
    public void Clear() => _table.Clear();

    /// <inheritdoc/>
    public void CollectPairs(float margin, List<ObjectPair> pairs)
    {
        BoundsTable.CheckQuery(margin, pairs);
        _found.Count = 0;
        _sweep.Collect(_table, margin, _found);
        _found.Sort(_table.End);
        _found.CopyTo(pairs);
    }

    /// <inheritdoc/>
    public void CollectInBox(in Aabb box, List<int> ids) => _table.CollectInBox(box, ids);
}
