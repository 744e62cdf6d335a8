using System.Collections.Generic;

namespace Gjk.Core;

/// <summary>
/// The broad phase that compares every pair of boxes: what the others are measured by, and the fastest for a few dozen
/// objects.
/// </summary>
/// <remarks>Mutable and not thread-safe. Time grows with n².</remarks>
public sealed class AllPairs : IBroadPhase
{
    private readonly BoundsTable _table = new();
    private Aabb[] _boxes = [];
    private int[] _ids = [];

    /// <summary>How many pairs may be found: less in tests.</summary>
    internal int PairLimit { get; set; } = PairKeys.MostPairs;

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
        int n = Gather();
        for (int i = 0; i < n; i++)
        {
            ref readonly Aabb box = ref _boxes[i];
            for (int j = i + 1; j < n; j++)
            {
                if (!BoundsTable.Near(box, _boxes[j], margin)) continue;
                if (pairs.Count == PairLimit) throw PairKeys.TooMany(PairLimit, pairs);
                pairs.Add(new ObjectPair(_ids[i], _ids[j]));
            }
        }
    }

    /// <inheritdoc/>
    public void CollectInBox(in Aabb box, List<int> ids) => _table.CollectInBox(box, ids);

    /// <inheritdoc/>
    public void Sweep<TVisitor>(in SweptBox path, ref TVisitor visitor)
        where TVisitor : struct, ISweepVisitor => _table.Sweep(path, ref visitor);

    /// <summary>The objects without the gaps between their numbers.</summary>
    private int Gather()
    {
        if (_ids.Length < _table.Count)
        {
            _ids = new int[_table.Boxes.Length];
            _boxes = new Aabb[_table.Boxes.Length];
        }

        int n = 0;
        for (int id = 0; id < _table.End; id++)
        {
            if (!_table.Present[id]) continue;
            _ids[n] = id;
            _boxes[n++] = _table.Boxes[id];
        }

        return n;
    }
}
