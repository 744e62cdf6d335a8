using System;
using System.Collections.Generic;
using System.Numerics;

namespace Gjk.Core;

/// <summary>
/// The broad phase that keeps a tree of boxes a little larger than asked for. While an object stays in its larger box nothing but that is checked; the pairs of the
/// larger boxes are kept too, and each frame's answer is those of them whose own boxes overlap.
/// </summary>
/// <remarks>Mutable and not thread-safe. Time grows with n log n, and by a factor of a few with motion.</remarks>
public sealed class DynamicAabbTree : IBroadPhase
{
    /// <summary>
    /// Ratio to the box's longest side: how much larger a leaf is on each side. More makes leaves last longer and pairs more. A matter of speed only.
    /// </summary>
    private const float Fatness = 0.14f;

    /// <summary>Ratio: when more of the leaves have left their boxes, building anew is faster than moving each. A matter of speed only.</summary>
    private const int MovedPartForBuild = 3;

    /// <summary>Count: frames in a row that asked for less than half the margin of the kept pairs, until pairs are found anew with the lesser one. A matter of speed only.</summary>
    private const int PatienceFrames = 16;

    /// <summary>Count: from here on it pays to bring the objects that get new leaves into an order. A matter of speed only.</summary>
    private const int LeastToOrder = 64;

    private readonly BoundsTable _table = new();
    private readonly AabbTree _tree = new();
    private readonly PairKeys _pairs = new();
    private readonly PairKeys _begun = new();
    private readonly List<int> _pendingList = [];
    private readonly int[] _histograms = new int[SortKeys.HistogramLength];
    private ulong[] _curve = [];
    private ulong[] _scratch = [];

    /// <summary>Objects in the tree: all that are present but for those added since the last frame.</summary>
    private bool[] _inTree = [];

    /// <summary>Objects that were added or have left their leaf, and so have no kept pairs; the list has them all, and perhaps others.</summary>
    private bool[] _pending = [];

    /// <summary>Where boxes were removed, kept pairs may name objects that are not there.</summary>
    private bool _anyRemoved;

    /// <summary>The kept pairs are all that this margin asks for.</summary>
    private float _margin;

    private int _framesBelowMargin;

    /// <inheritdoc/>
    public int Count => _table.Count;

    /// <inheritdoc/>
    public void Add(int id, in Aabb bounds)
    {
        _table.Add(id, bounds);
        if (_inTree.Length < _table.Boxes.Length)
        {
            Array.Resize(ref _inTree, _table.Boxes.Length);
            Array.Resize(ref _pending, _table.Boxes.Length);
        }

        SetPending(id);
    }

    /// <inheritdoc/>
    public void Move(int id, in Aabb bounds)
    {
        _table.Move(id, bounds);
        if (!_pending[id] && !IsInside(bounds, _tree.Leaf(id))) SetPending(id);
    }

    /// <inheritdoc/>
    public void Remove(int id)
    {
        _table.Remove(id);
        if (_inTree[id]) _tree.Remove(id);
        _inTree[id] = false;
        _pending[id] = false;
        _anyRemoved = true;
    }

    /// <inheritdoc/>
    public void Clear()
    {
        _table.Clear();
        _tree.Reset(_tree.Capacity);
        Array.Clear(_inTree, 0, _inTree.Length);
        Array.Clear(_pending, 0, _pending.Length);
        _pendingList.Clear();
        _pairs.Count = 0;
        _margin = 0;
        _framesBelowMargin = 0;
        _anyRemoved = false;
    }

    /// <inheritdoc/>
    public void CollectPairs(float margin, List<ObjectPair> pairs)
    {
        BoundsTable.CheckQuery(margin, pairs);
        if (IsMarginUnfit(margin)) FindAllPairs(margin);
        else UpdatePairs();
        for (int i = 0; i < _pairs.Count; i++)
        {
            int a = PairKeys.First(_pairs.Keys[i]), b = PairKeys.Second(_pairs.Keys[i]);
            if (BoundsTable.Near(_table.Boxes[a], _table.Boxes[b], margin)) pairs.Add(new ObjectPair(a, b));
        }
    }

    /// <inheritdoc/>
    public void CollectInBox(in Aabb box, List<int> ids)
    {
        Guard.NotNull(ids, nameof(ids)).Clear();
        UpdatePairs();
        _tree.Query(box.Min, box.Max, ids);
        int kept = 0;
        for (int i = 0; i < ids.Count; i++)
            if (_table.Boxes[ids[i]].Overlaps(box)) ids[kept++] = ids[i];
        ids.RemoveRange(kept, ids.Count - kept);
        ids.Sort();
    }

    private static bool IsInside(in Aabb box, in AabbNode leaf) =>
        box.Min.X >= leaf.Min.X && box.Min.Y >= leaf.Min.Y && box.Min.Z >= leaf.Min.Z &&
        box.Max.X <= leaf.Max.X && box.Max.Y <= leaf.Max.Y && box.Max.Z <= leaf.Max.Z;

    private void SetPending(int id)
    {
        if (_pending[id]) return;
        _pending[id] = true;
        _pendingList.Add(id);
    }

    /// <summary>The kept pairs serve a margin up to their own; one that is far smaller for long would be served better by fewer pairs.</summary>
    private bool IsMarginUnfit(float margin)
    {
        _framesBelowMargin = margin < 0.5f * _margin ? _framesBelowMargin + 1 : 0;
        return margin > _margin || _framesBelowMargin >= PatienceFrames;
    }

    /// <summary>Every object's pairs, with another margin.</summary>
    private void FindAllPairs(float margin)
    {
        _margin = margin;
        _framesBelowMargin = 0;
        UpdateTree();
        for (int id = 0; id < _table.End; id++)
            if (_table.Present[id] && !_pending[id]) SetPending(id);
        _pairs.Count = 0;
        FindPendingPairs();
    }

    /// <summary>Drops the pairs of what has left its leaf or is gone, and finds the new ones.</summary>
    private void UpdatePairs()
    {
        UpdateTree();
        if (_pendingList.Count == 0 && !_anyRemoved) return;
        int kept = 0;
        for (int i = 0; i < _pairs.Count; i++)
        {
            ulong key = _pairs.Keys[i];
            int a = PairKeys.First(key), b = PairKeys.Second(key);
            if (_inTree[a] && _inTree[b] && !_pending[a] && !_pending[b]) _pairs.Keys[kept++] = key;
        }

        _pairs.Count = kept;
        FindPendingPairs();
    }

    private void FindPendingPairs()
    {
        _begun.Count = 0;
        foreach (int id in _pendingList)
            if (_pending[id]) _tree.QueryPairs(id, _margin, _pending, _begun);
        foreach (int id in _pendingList) _pending[id] = false;
        _pendingList.Clear();
        _anyRemoved = false;
        _begun.Sort(_table.End);
        _pairs.Merge(_begun);
    }

    /// <summary>Gives the pending objects new leaves.</summary>
    private void UpdateTree()
    {
        DropStale();
        if (_pendingList.Count == 0) return;
        if (_pendingList.Count > _table.Count / MovedPartForBuild)
        {
            Build();
            return;
        }

        if (_tree.Capacity < _table.Boxes.Length) _tree.Grow(_table.Boxes.Length);
        if (_pendingList.Count >= LeastToOrder) OrderPending();
        foreach (int id in _pendingList)
        {
            if (_inTree[id]) _tree.Remove(id);
            Fatten(_table.Boxes[id], out Vector3 min, out Vector3 max);
            _tree.Insert(id, min, max);
            _inTree[id] = true;
        }
    }

    /// <summary>Leaves each pending object in the list once: one that was removed and added again is in it twice, one that was only removed should not be.</summary>
    private void DropStale()
    {
        if (!_anyRemoved) return;
        int kept = 0;
        foreach (int id in _pendingList) _pending[id] = false;
        for (int i = 0; i < _pendingList.Count; i++)
        {
            int id = _pendingList[i];
            if (!_table.Present[id] || _pending[id]) continue;
            _pending[id] = true;
            _pendingList[kept++] = id;
        }

        _pendingList.RemoveRange(kept, _pendingList.Count - kept);
    }

    /// <summary>The whole tree from the objects' order along a curve; all of them get new leaves.</summary>
    private void Build()
    {
        if (_tree.Capacity < _table.Boxes.Length) _tree.Reset(_table.Boxes.Length);
        _pendingList.Clear();
        for (int id = 0; id < _table.End; id++)
            if (_table.Present[id]) _pendingList.Add(id);
        OrderPending();
        foreach (int id in _pendingList)
        {
            Fatten(_table.Boxes[id], out Vector3 min, out Vector3 max);
            _tree.SetLeaf(id, min, max);
            _inTree[id] = true;
            _pending[id] = true;
        }

        _tree.Build(_curve, _pendingList.Count);
    }

    /// <summary>Brings the pending objects into their order along a curve: what one needs of the tree is in the cache from the one before.</summary>
    private void OrderPending()
    {
        if (_curve.Length < _table.Boxes.Length)
        {
            _curve = new ulong[_table.Boxes.Length];
            _scratch = new ulong[_table.Boxes.Length];
        }

        var low = new Vector3(float.MaxValue);
        Vector3 high = -low;
        foreach (int id in _pendingList)
        {
            low = Vector3.Min(low, _table.Boxes[id].Min);
            high = Vector3.Max(high, _table.Boxes[id].Max);
        }

        Vector3D corner = low, size = (Vector3D)high - low;
        var perUnit = new Vector3D(MortonCurve.PerUnit(size.X), MortonCurve.PerUnit(size.Y), MortonCurve.PerUnit(size.Z));
        int n = _pendingList.Count;
        for (int i = 0; i < n; i++)
        {
            ref readonly Aabb box = ref _table.Boxes[_pendingList[i]];
            Vector3D centre = ((Vector3D)box.Min + box.Max) * 0.5;
            _curve[i] = (ulong)MortonCurve.Cell(centre, corner, perUnit) << 32 | (uint)_pendingList[i];
        }

        SortKeys.Sort(ref _curve, ref _scratch, _histograms, n);
        for (int i = 0; i < n; i++) _pendingList[i] = (int)(uint)_curve[i];
    }

    /// <summary>Rounding is monotone, so the larger box holds the box.</summary>
    private static void Fatten(in Aabb box, out Vector3 min, out Vector3 max)
    {
        var fat = new Vector3((float)(Fatness * Math.Min(box.LongestSide, float.MaxValue)));
        min = box.Min - fat;
        max = box.Max + fat;
    }
}
