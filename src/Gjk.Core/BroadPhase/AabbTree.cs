namespace Gjk.Core;

/// <summary>A binary tree of boxes with an object at each leaf. An insertion descends where it adds least surface and
/// turns the branches on its way back (Catto, "Dynamic bounding volume hierarchies", 2019; Kopta et al. 2012); the
/// expected work of a look-up is proportional to the surfaces.</summary>
/// <remarks>Leaf i is node i; the inner nodes follow at <see cref="_leafEnd"/>, so growing renumbers them. Surfaces say
/// nothing about equal boxes, or about points on a line, and are infinite for the largest boxes; so insertions alone
/// could make a tree as deep as it has leaves. <see cref="TryInsert"/> tells when it is deeper than
/// <see cref="MaxDepth"/>, and the owner builds anew.</remarks>
internal sealed partial class AabbTree
{
    /// <summary>Levels below the root: twice as many as a built tree has at most, so that a build is followed by
    /// insertions again. Pinned by DeepTreeTests.</summary>
    public const int MaxDepth = 128;

    private const int None = -1;

    private AabbNode[] _nodes = [];
    private int[] _parents = [];

    /// <summary>Levels below a node; more than there are where leaves were removed lately.</summary>
    private byte[] _heights = [];
    private int[] _free = [];
    private int _freeCount;
    private int _root = None;

    /// <summary>Nodes from here on are inner ones.</summary>
    private int _leafEnd;

    /// <summary>How many leaves fit; their numbers are below it.</summary>
    public int Capacity => _leafEnd;

    /// <summary>The node above all others; negative where there is none.</summary>
    public int Root => _root;

    /// <summary>Whether it has to be built anew before it is asked.</summary>
    public bool IsTooDeep => _root != None && _heights[_root] > MaxDepth;

    /// <summary>A node: a leaf's box as it was inserted, or an inner box and its children.</summary>
    public ref readonly AabbNode Node(int node) => ref _nodes[node];

    /// <summary>Empties the tree, and makes room for leaves with numbers below the capacity.</summary>
    public void Reset(int capacity)
    {
        if (capacity > _leafEnd)
        {
            var nodes = new AabbNode[2 * capacity];
            int[] parents = new int[2 * capacity], free = new int[capacity];
            byte[] heights = new byte[2 * capacity];
            (_nodes, _parents, _heights, _free, _leafEnd) = (nodes, parents, heights, free, capacity);
        }

        _root = None;
        _freeCount = 0;
        for (int node = 2 * _leafEnd - 1; node >= _leafEnd; node--) _free[_freeCount++] = node;
    }

    /// <summary>Makes room for more leaves and keeps the tree.</summary>
    public void Grow(int capacity)
    {
        int shift = capacity - _leafEnd;
        var nodes = new AabbNode[2 * capacity];
        int[] parents = new int[2 * capacity], free = new int[capacity];
        byte[] heights = new byte[2 * capacity];
        Array.Copy(_nodes, nodes, _leafEnd);
        Array.Copy(_parents, parents, _leafEnd);
        Array.Copy(_nodes, _leafEnd, nodes, capacity, _leafEnd);
        Array.Copy(_parents, _leafEnd, parents, capacity, _leafEnd);
        Array.Copy(_heights, _leafEnd, heights, capacity, _leafEnd);
        for (int i = 0; i < nodes.Length; i++)
        {
            if (parents[i] >= _leafEnd) parents[i] += shift;
            if (i < capacity) continue;
            if (nodes[i].Left >= _leafEnd) nodes[i].Left += shift;
            if (nodes[i].Right >= _leafEnd) nodes[i].Right += shift;
        }

        int count = 0;
        for (int node = 2 * capacity - 1; node >= capacity + _leafEnd; node--) free[count++] = node;
        for (int i = 0; i < _freeCount; i++) free[count++] = _free[i] + shift;
        if (_root >= _leafEnd) _root += shift;
        (_nodes, _parents, _heights, _free) = (nodes, parents, heights, free);
        (_freeCount, _leafEnd) = (count, capacity);
    }

    /// <summary>Adds a leaf.</summary>
    /// <returns>False where the tree is too deep now, and has to be built anew.</returns>
    public bool TryInsert(int leaf, Vector3 min, Vector3 max)
    {
        Attach(leaf, min, max, _root == None ? None : _free[--_freeCount], ref _root, None);
        return !IsTooDeep;
    }

    public void Remove(int leaf)
    {
        int spare = Detach(leaf, ref _root, None);
        if (spare != None) _free[_freeCount++] = spare;
    }

    /// <summary>Adds a leaf to a subtree.</summary>
    /// <param name="leaf">The leaf.</param>
    /// <param name="min">Of its box.</param>
    /// <param name="max">Of its box.</param>
    /// <param name="spare">A free inner node; none is needed where there is no root.</param>
    /// <param name="root">The subtree's root, which may become another one.</param>
    /// <param name="top">The node above the root, which only gets another child.</param>
    private void Attach(int leaf, Vector3 min, Vector3 max, int spare, ref int root, int top)
    {
        SetLeaf(leaf, min, max);
        if (root == None)
        {
            root = leaf;
            _parents[leaf] = top;
            return;
        }

        int sibling = FindSibling(leaf, root), above = _parents[sibling];
        ref AabbNode joined = ref _nodes[spare];
        joined.Left = sibling;
        joined.Right = leaf;
        _parents[spare] = above;
        _parents[sibling] = _parents[leaf] = spare;
        if (sibling == root) root = spare;
        if (above != None) Replace(above, sibling, spare);
        Refit(spare, top);
    }

    /// <summary>Takes a leaf out of a subtree.</summary>
    /// <returns>The inner node that is free now.</returns>
    private int Detach(int leaf, ref int root, int top)
    {
        if (leaf == root)
        {
            root = None;
            return None;
        }

        int parent = _parents[leaf], above = _parents[parent];
        int sibling = _nodes[parent].Left == leaf ? _nodes[parent].Right : _nodes[parent].Left;
        _parents[sibling] = above;
        if (parent == root) root = sibling;
        if (above != None) Replace(above, parent, sibling);
        Shrink(above, top);
        return parent;
    }

    /// <summary>Down from the root: each node entered grows by the new box, so stopping at it, as the box's sibling,
    /// costs its grown surface; going on costs what the node itself grows by and at least the new box's own growth of a
    /// child.</summary>
    private int FindSibling(int leaf, int root)
    {
        ref readonly AabbNode box = ref _nodes[leaf];
        int node = root;
        for (int depth = 0; node >= _leafEnd; depth++)
        {
            ref readonly AabbNode inner = ref _nodes[node];
            float joined = AabbNode.UnionArea(inner, box), growth = joined - AabbNode.Area(inner);
            float left = growth + DescentCost(_nodes[inner.Left], box, inner.Left < _leafEnd);
            float right = growth + DescentCost(_nodes[inner.Right], box, inner.Right < _leafEnd);
            if (joined < left && joined < right) break;
            bool isLeft = left < right || (left == right && IsLeftNearer(inner, box, leaf >> (depth & 15)));
            node = isLeft ? inner.Left : inner.Right;
        }

        return node;
    }

    private static float DescentCost(in AabbNode child, in AabbNode box, bool isLeaf)
    {
        float joined = AabbNode.UnionArea(child, box);
        return isLeaf ? joined : joined - AabbNode.Area(child);
    }

    /// <summary>Where surfaces are equal, as they are on a line, the child that grows less in length; where both hold
    /// the box already, the two in turn.</summary>
    private bool IsLeftNearer(in AabbNode inner, in AabbNode box, int turn)
    {
        float left = AabbNode.LengthGrowth(_nodes[inner.Left], box);
        float right = AabbNode.LengthGrowth(_nodes[inner.Right], box);
        return left < right || (left == right && (turn & 1) != 0);
    }

    /// <summary>From a node up to one that stays: the boxes, and a turn where it lessens the surface.</summary>
    private void Refit(int node, int top)
    {
        for (; node != top; node = _parents[node])
        {
            Rotate(node, _nodes[node].Left, _nodes[node].Right);
            Rotate(node, _nodes[node].Right, _nodes[node].Left);
            Enclose(node);
        }
    }

    /// <summary>From a node up to one that stays, or to where the removed leaf was not at the edge: the boxes
    /// alone; the next insertion turns the branches.</summary>
    private void Shrink(int node, int top)
    {
        for (; node != top; node = _parents[node])
        {
            AabbNode before = _nodes[node];
            Enclose(node);
            if (_nodes[node].Min == before.Min && _nodes[node].Max == before.Max) return;
        }
    }

    /// <summary>Exchanges a child with one of its sibling's children where that makes the sibling smaller; nothing else
    /// changes its box.</summary>
    private void Rotate(int node, int child, int sibling)
    {
        if (sibling < _leafEnd) return;
        ref AabbNode branch = ref _nodes[sibling];
        float area = AabbNode.Area(branch);
        float withLeft = AabbNode.UnionArea(_nodes[child], _nodes[branch.Left]);
        float withRight = AabbNode.UnionArea(_nodes[child], _nodes[branch.Right]);
        bool raisesRight = withLeft < area && withLeft <= withRight;
        if (!raisesRight && !(withRight < area)) return;
        int raised = raisesRight ? branch.Right : branch.Left;
        Replace(sibling, raised, child);
        Replace(node, child, raised);
        _parents[child] = sibling;
        _parents[raised] = node;
        Enclose(sibling);
    }

    private void Replace(int parent, int old, int child)
    {
        if (_nodes[parent].Left == old) _nodes[parent].Left = child;
        else _nodes[parent].Right = child;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Enclose(int node)
    {
        ref AabbNode box = ref _nodes[node];
        ref readonly AabbNode left = ref _nodes[box.Left];
        ref readonly AabbNode right = ref _nodes[box.Right];
        box.Min = Vector3.Min(left.Min, right.Min);
        box.Max = Vector3.Max(left.Max, right.Max);
        _heights[node] = (byte)Math.Min(Math.Max(_heights[box.Left], _heights[box.Right]) + 1, byte.MaxValue);
    }
}
