using System.Collections.Generic;

namespace Gjk.Core;

/// <summary>
/// The broad phase that sorts the boxes along one axis each time it is asked: the one along which they are spread most
/// for their size. It keeps nothing between frames, so motion of any size costs the same.
/// </summary>
/// <remarks>
/// Mutable and not thread-safe. Every two boxes that overlap along that axis are compared. So the time grows with n log
/// n in a long row, with n^(5/3) in a cube of constant density, and with n² where no axis tells boxes apart: rods in
/// all three directions, or a few hundred boxes in one place along the axis and apart along the others.
/// </remarks>
public sealed class SortAndSweep : IBroadPhase
{
    private readonly BoundsTable _table = new();
    private readonly AxisSweep _sweep = new();
    private readonly PairKeys _found = new();

    /// <inheritdoc/>
    public int Count => _table.Count;

    /// <summary>How many pairs of boxes were compared, for the tests of cost.</summary>
    internal long Comparisons => _sweep.Comparisons;

    /// <summary>How many pairs may be found: less in tests.</summary>
    internal int PairLimit
    {
        set => _found.Limit = value;
    }

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

    /// <inheritdoc/>
    public void Sweep<TVisitor>(in SweptBox path, ref TVisitor visitor)
        where TVisitor : struct, ISweepVisitor => _table.Sweep(path, ref visitor);
}
