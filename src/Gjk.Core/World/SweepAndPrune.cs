using System;
using System.Collections.Generic;

namespace Gjk.Core;

/// <summary>
/// The broad phase that keeps the ends of all boxes sorted along the three axes, and the pairs with them (Baraff 1992; Cohen et al., I-COLLIDE, 1995). From one frame to the next little
/// changes places, and insertion sort visits just that: a lower end that passes an upper one is where a pair can begin.
/// </summary>
/// <remarks>
/// Mutable and not thread-safe. Time grows with the number of ends that pass each other; where that is more than sorting anew would cost, it sorts anew.
/// </remarks>
public sealed class SweepAndPrune : IBroadPhase
{
    /// <summary>Exchanges per object and frame above which sorting anew is likely to be cheaper: it costs as much as some hundred exchanges for each object. A matter of speed only.</summary>
    private const long SwapsPerObject = 512;

    /// <summary>Count: objects added in one frame that are inserted one by one, each passing the ends of all others; more of them sort anew. A matter of speed only.</summary>
    private const int MaxInsertions = 32;

    private readonly BoundsTable _table = new();
    private readonly AxisSweep _sweep = new();
    private readonly EndpointAxis[] _axes = [new(0), new(1), new(2)];
    private readonly int[] _histograms = new int[SortKeys.HistogramLength];
    private readonly PairKeys _begun = new();
    private readonly List<int> _added = [];
    private readonly PairKeys _pairs = new();

    /// <summary>Which objects' ends are in the axes; as long as the table.</summary>
    private bool[] _listed = [];
    private ulong[] _scratch = [];

    /// <inheritdoc/>
    public int Count => _table.Count;

    /// <inheritdoc/>
    public void Add(int id, in Aabb bounds)
    {
        _table.Add(id, bounds);
        if (_listed.Length < _table.Boxes.Length) Array.Resize(ref _listed, _table.Boxes.Length);
    }

    /// <inheritdoc/>
    public void Move(int id, in Aabb bounds) => _table.Move(id, bounds);

    /// <inheritdoc/>
    public void Remove(int id) => _table.Remove(id);

    /// <inheritdoc/>
    public void Clear()
    {
        Array.Clear(_listed, 0, _listed.Length);
        _pairs.Count = 0;
        foreach (EndpointAxis axis in _axes) axis.Count = 0;
        _table.Clear();
    }

    /// <inheritdoc/>
    public void CollectPairs(float margin, List<ObjectPair> pairs)
    {
        BoundsTable.CheckQuery(margin, pairs);
        FindChanges();
        if (_added.Count > MaxInsertions || !TryUpdate(margin)) SortAnew(margin);
        foreach (int id in _added) _listed[id] = true;
        _pairs.CopyTo(pairs);
    }

    /// <inheritdoc/>
    public void CollectInBox(in Aabb box, List<int> ids) => _table.CollectInBox(box, ids);

    /// <summary>What was added and removed since the last frame; an object that was removed and added again has only moved.</summary>
    private void FindChanges()
    {
        bool anyGone = false;
        _added.Clear();
        for (int id = 0; id < _listed.Length; id++)
        {
            if (_listed[id] == _table.Present[id]) continue;
            if (!_listed[id])
            {
                _added.Add(id);
                continue;
            }

            _listed[id] = false;
            anyGone = true;
        }

        if (!anyGone) return;
        foreach (EndpointAxis axis in _axes) axis.DropUnlisted(_listed);
    }

    /// <summary>Puts the moved ends in order and the pairs with them; false, with nothing promised, when too much has changed.</summary>
    private bool TryUpdate(float margin)
    {
        _begun.Count = 0;
        long swaps = SwapsPerObject * _table.Count;
        foreach (EndpointAxis axis in _axes)
        {
            axis.Refresh(_table, margin);
            foreach (int id in _added) axis.Append(_table, margin, id);
            if (!axis.InsertionSort(_table, margin, _begun, ref swaps)) return false;
        }

        DropEnded(margin);
        _begun.Sort(_table.End);
        _begun.DropRepeats();
        _pairs.Merge(_begun);
        return true;
    }

    /// <summary>A pair can only begin on an axis where it was apart: what is in both lists did not exist.</summary>
    private void DropEnded(float margin)
    {
        int kept = 0;
        for (int i = 0; i < _pairs.Count; i++)
        {
            ulong key = _pairs.Keys[i];
            int a = PairKeys.First(key), b = PairKeys.Second(key);
            if (_listed[a] && _listed[b] && BoundsTable.Near(_table.Boxes[a], _table.Boxes[b], margin)) _pairs.Keys[kept++] = key;
        }

        _pairs.Count = kept;
    }

    private void SortAnew(float margin)
    {
        if (_scratch.Length < 2 * _table.Boxes.Length) _scratch = new ulong[2 * _table.Boxes.Length];
        foreach (EndpointAxis axis in _axes) axis.Fill(_table, margin, ref _scratch, _histograms);
        _pairs.Count = 0;
        _sweep.Collect(_table, margin, _pairs);
        _pairs.Sort(_table.End);
    }
}
