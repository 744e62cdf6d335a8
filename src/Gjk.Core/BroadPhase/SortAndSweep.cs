namespace Gjk.Core;

/// <summary>The broad phase that sorts the boxes along one axis each time it is asked, the one along which their
/// centres are spread most, and compares each with those that begin before it ends (Baraff 1992; Ericson 2004, section
/// 7.5.2). It keeps nothing between frames, so motion of any size costs the same.</summary>
/// <remarks>Mutable and not thread-safe. Every two boxes that overlap along that axis are compared. So the time grows
/// with n log n in a long row, with n^(5/3) in a cube of constant density, and with n² where the axis tells few boxes
/// apart. <see cref="DynamicAabbTree"/> has no such case.</remarks>
public sealed class SortAndSweep : IBroadPhase
{
    private readonly BoundsTable _table = new();
    private readonly PairKeys _found = new();

    /// <summary>The lower ends, as numbers that order as they do, in the upper halves; the objects in the
    /// lower.</summary>
    private ulong[] _order = [];

    /// <summary>The boxes in that order.</summary>
    private Aabb[] _boxes = [];

    /// <inheritdoc/>
    public int Count => _table.Count;

    /// <summary>How many pairs may be found: less in tests.</summary>
    internal int PairLimit
    {
        set => _found.Limit = value;
    }

    /// <inheritdoc/>
    public void Add(int id, in Aabb bounds) => _table.Add(id, bounds);

    /// <inheritdoc/>
    public void Move(int id, in Aabb bounds)
    {
        _table.Check(id);
        _table.Boxes[id] = bounds;
    }

    /// <inheritdoc/>
    public void Remove(int id) => _table.Remove(id);

    /// <inheritdoc/>
    public void Clear() => _table.Clear();

    /// <inheritdoc/>
    public void CollectPairs(float margin, List<ObjectPair> pairs)
    {
        BoundsTable.CheckQuery(margin, pairs);
        _found.Count = 0;
        Reserve();
        int axis = WidestAxis(), n = 0;
        for (int id = 0; id < _table.End; id++)
        {
            if (_table.Present[id])
                _order[n++] = (ulong)SortKeys.Ordered(Component(_table.Boxes[id].Min, axis)) << 32 | (uint)id;
        }

        InPlaceSort.Sort(_order, 0, n);
        for (int i = 0; i < n; i++) _boxes[i] = _table.Boxes[(int)_order[i]];
        for (int i = 0; i < n; i++)
        {
            ref readonly Aabb box = ref _boxes[i];
            uint end = SortKeys.Ordered((float)(Component(box.Max, axis) + margin));
            for (int j = i + 1; j < n && (uint)(_order[j] >> 32) <= end; j++)
            {
                if (BoundsTable.Near(box, _boxes[j], margin))
                    _found.Add(PairKeys.Key((int)_order[i], (int)_order[j]));
            }
        }

        _found.Sort(_table.End);
        _found.CopyTo(pairs);
    }

    /// <inheritdoc/>
    public void CollectInBox(in Aabb box, List<int> ids)
    {
        Guard.NotNull(ids, nameof(ids)).Clear();
        for (int i = 0; i < _table.End; i++)
            if (_table.Present[i] && _table.Boxes[i].Overlaps(box)) ids.Add(i);
    }

    /// <inheritdoc/>
    public void Sweep<TVisitor>(in SweptBox path, ref TVisitor visitor)
        where TVisitor : struct, ISweepVisitor
    {
        double limit = path.Limit;
        for (int i = 0; i < _table.End; i++)
        {
            if (_table.Present[i] && path.Meets(_table.Boxes[i], limit, out _))
                limit = Math.Min(limit, visitor.Visit(i));
        }
    }

    private void Reserve()
    {
        if (_boxes.Length >= _table.Count) return;
        _order = new ulong[_table.Boxes.Length];
        _boxes = new Aabb[_table.Boxes.Length];
    }

    /// <summary>The axis along which the centres have the largest variance.</summary>
    private int WidestAxis()
    {
        Double3 sum = default, squares = default;
        for (int id = 0; id < _table.End; id++)
        {
            if (!_table.Present[id]) continue;
            Double3 centre = (Double3)_table.Boxes[id].Min + _table.Boxes[id].Max;
            sum += centre;
            squares += Double3.Multiply(centre, centre);
        }

        Double3 spread = squares * _table.Count - Double3.Multiply(sum, sum);
        if (spread.X >= spread.Y) return spread.X >= spread.Z ? 0 : 2;
        return spread.Y >= spread.Z ? 1 : 2;
    }

    private static float Component(in Vector3 v, int axis) => axis == 0 ? v.X : axis == 1 ? v.Y : v.Z;
}
