namespace Gjk.Core;

internal sealed partial class AabbTree
{
    /// <summary>Levels: so far down a built tree follows the curve; below, it halves what is left, so that it is never
    /// deeper than this and the logarithm of the number of leaves. A curve alone peels off the points of a row of 1,
    /// 1/2, 1/4, ... one by one.</summary>
    private const int MaxCurveDepth = 40;

    /// <summary>A leaf's box, for <see cref="Build"/>.</summary>
    public void SetLeaf(int leaf, Vector3 min, Vector3 max)
    {
        _nodes[leaf].Min = min;
        _nodes[leaf].Max = max;
    }

    /// <summary>Builds the tree anew over leaves whose boxes were set by <see cref="SetLeaf"/>.</summary>
    public void Build(CurveOrder order)
    {
        Reset(_leafEnd);
        if (order.Count == 0) return;
        _root = Join(order, 0, order.Count, 0);
        _parents[_root] = None;
    }

    /// <summary>A tree over a part of the order; it calls itself no deeper than the tree is.</summary>
    private int Join(CurveOrder order, int begin, int end, int depth)
    {
        if (end - begin == 1) return order[begin];
        int middle = order.Split(begin, end);
        if (depth >= MaxCurveDepth) middle = CurveOrder.Middle(begin, end);
        int node = _free[--_freeCount];
        int left = Join(order, begin, middle, depth + 1), right = Join(order, middle, end, depth + 1);
        _nodes[node].Left = left;
        _nodes[node].Right = right;
        _parents[left] = _parents[right] = node;
        Enclose(node);
        return node;
    }
}
