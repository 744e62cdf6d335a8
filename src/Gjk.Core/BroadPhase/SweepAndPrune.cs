using System;
using System.Collections.Generic;

namespace Gjk.Core;

/// <summary>
/// The broad phase that keeps the ends of all boxes sorted along the three axes, and the pairs with them (Baraff 1992;
/// Cohen et al., I-COLLIDE, 1995). From one frame to the next little changes places, and insertion sort visits just
/// that: a lower end that passes an upper one is where a pair can begin.
/// </summary>
/// <remarks>
/// Mutable and not thread-safe. Time grows with the number of ends that pass each other; where that is more than
/// sorting anew would cost, it does as <see cref="SortAndSweep"/> does for some frames. Many boxes with ends at the
/// same place along an axis pass each other whenever they move.
/// </remarks>
public sealed class SweepAndPrune : IBroadPhase
{
    /// <summary>
    /// Exchanges per object and frame above which sorting anew is likely to be cheaper: it costs as much as some
    /// hundred exchanges for each object. A matter of speed only.
    /// </summary>
    private const long SwapsPerObject = 512;

    /// <summary>
    /// Count: objects added in one frame that are inserted one by one, each passing the ends of all others; more of
    /// them sort anew. A matter of speed only.
    /// </summary>
    private const int MaxInsertions = 32;

    /// <summary>
    /// Count: after a frame with too many exchanges the next one is sorted anew without a try; after each try that
    /// fails, twice as many, up to so many. A matter of speed only.
    /// </summary>
    private const int MostFramesWithoutTry = 64;

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

    /// <summary>Whether the axes hold the ends of the listed objects in order, and the pairs with them.</summary>
    private bool _isSorted;

    /// <summary>Frames until the next try, and how many there were before the last one.</summary>
    private int _framesToTry;
    private int _lastWait;

    /// <inheritdoc/>
    public int Count => _table.Count;

    /// <summary>How many ends were exchanged, for the tests of cost.</summary>
    internal long Exchanges { get; private set; }

    /// <inheritdoc cref="SortAndSweep.Comparisons"/>
    internal long Comparisons => _sweep.Comparisons;

    /// <inheritdoc cref="SortAndSweep.PairLimit"/>
    internal int PairLimit
    {
        set => _pairs.Limit = _begun.Limit = value;
    }

    /// <inheritdoc/>
    public void Add(int id, in Aabb bounds)
    {
        _table.CheckNew(id);
        _table.Reserve(id);
        if (_listed.Length < _table.Boxes.Length) Array.Resize(ref _listed, _table.Boxes.Length);
        _table.Add(id, bounds);
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
        _isSorted = false;
        _framesToTry = _lastWait = 0;
        _table.Clear();
    }

    /// <inheritdoc/>
    public void CollectPairs(float margin, List<ObjectPair> pairs)
    {
        BoundsTable.CheckQuery(margin, pairs);
        FindChanges();
        bool wasSorted = _isSorted && _added.Count <= MaxInsertions;

        // Until it is done, for an exception leaves the axes and the pairs halfway.
        _isSorted = false;
        if (!wasSorted || !TryUpdate(margin)) FindAnew(margin, wasSorted);
        else (_isSorted, _lastWait) = (true, 0);
        foreach (int id in _added) _listed[id] = true;
        _pairs.CopyTo(pairs);
    }

    /// <inheritdoc/>
    public void CollectInBox(in Aabb box, List<int> ids) => _table.CollectInBox(box, ids);

    /// <inheritdoc/>
    public void Sweep<TVisitor>(in SweptBox path, ref TVisitor visitor)
        where TVisitor : struct, ISweepVisitor => _table.Sweep(path, ref visitor);

    /// <summary>
    /// What was added and removed since the last frame; an object that was removed and added again has only moved.
    /// </summary>
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

    /// <summary>
    /// Puts the moved ends in order and the pairs with them; false, with nothing promised, when too much has changed.
    /// </summary>
    private bool TryUpdate(float margin)
    {
        _begun.Count = 0;
        long swaps = SwapsPerObject * _table.Count;
        foreach (EndpointAxis axis in _axes)
        {
            axis.Refresh(_table, margin);
            foreach (int id in _added) axis.Append(_table, margin, id);
            long before = swaps;
            bool isSorted = axis.InsertionSort(_table, margin, _begun, ref swaps);
            Exchanges += before - swaps;
            if (!isSorted) return false;
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
            if (_listed[a] && _listed[b] && BoundsTable.Near(_table.Boxes[a], _table.Boxes[b], margin))
                _pairs.Keys[kept++] = key;
        }

        _pairs.Count = kept;
    }

    /// <summary>Finds the pairs without the axes, and sorts these for the next frame if that is to try them.</summary>
    private void FindAnew(float margin, bool hasFailed)
    {
        if (hasFailed) _framesToTry = _lastWait = Math.Min(Math.Max(2 * _lastWait, 1), MostFramesWithoutTry);
        _sweep.Collect(_table, margin, _pairs);
        _pairs.Sort(_table.End);
        if (_framesToTry-- > 0) return;
        _framesToTry = 0;
        if (_scratch.Length < 2 * _table.Boxes.Length) _scratch = new ulong[2 * _table.Boxes.Length];
        foreach (EndpointAxis axis in _axes) axis.Fill(_table, margin, ref _scratch, _histograms);
        _isSorted = true;
    }
}
