using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// A binary tree of boxes with an object at each leaf. An insertion descends where it adds least surface and turns the branches on its way back (Catto, "Dynamic bounding volume
/// hierarchies", 2019; Kopta et al. 2012); the expected work of a look-up is proportional to the surfaces.
/// </summary>
/// <remarks>Leaf i is node i; the inner nodes follow at <see cref="_leafEnd"/>, so growing renumbers them.</remarks>
internal sealed class AabbTree
{
    private const int None = -1;

    private AabbNode[] _nodes = [];
    private int[] _parents = [];
    private int[] _free = [];
    private int[] _stack = new int[64];
    private int _freeCount;
    private int _root = None;

    /// <summary>Nodes from here on are inner ones.</summary>
    private int _leafEnd;

    /// <summary>How many leaves fit; their numbers are below it.</summary>
    public int Capacity => _leafEnd;

    /// <summary>A leaf's box, as it was inserted.</summary>
    public ref readonly AabbNode Leaf(int leaf) => ref _nodes[leaf];

    /// <summary>Empties the tree, and makes room for leaves with numbers below the capacity.</summary>
    public void Reset(int capacity)
    {
        if (capacity > _leafEnd)
        {
            _nodes = new AabbNode[2 * capacity];
            _parents = new int[2 * capacity];
            _free = new int[capacity];
            _leafEnd = capacity;
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
        var parents = new int[2 * capacity];
        Array.Copy(_nodes, nodes, _leafEnd);
        Array.Copy(_parents, parents, _leafEnd);
        Array.Copy(_nodes, _leafEnd, nodes, capacity, _leafEnd);
        Array.Copy(_parents, _leafEnd, parents, capacity, _leafEnd);
        for (int i = 0; i < nodes.Length; i++)
        {
            if (parents[i] >= _leafEnd) parents[i] += shift;
            if (i < capacity) continue;
            if (nodes[i].Left >= _leafEnd) nodes[i].Left += shift;
            if (nodes[i].Right >= _leafEnd) nodes[i].Right += shift;
        }

        int[] free = new int[capacity];
        int count = 0;
        for (int node = 2 * capacity - 1; node >= capacity + _leafEnd; node--) free[count++] = node;
        for (int i = 0; i < _freeCount; i++) free[count++] = _free[i] + shift;
        if (_root >= _leafEnd) _root += shift;
        (_nodes, _parents, _free, _freeCount, _leafEnd) = (nodes, parents, free, count, capacity);
    }

    public void Insert(int leaf, Vector3 min, Vector3 max)
    {
        ref AabbNode box = ref _nodes[leaf];
        box.Min = min;
        box.Max = max;
        if (_root == None)
        {
            _root = leaf;
            _parents[leaf] = None;
            return;
        }

        int sibling = FindSibling(box);
        int parent = _free[--_freeCount], above = _parents[sibling];
        ref AabbNode joined = ref _nodes[parent];
        joined.Left = sibling;
        joined.Right = leaf;
        _parents[parent] = above;
        _parents[sibling] = _parents[leaf] = parent;
        if (above == None) _root = parent;
        else Replace(above, sibling, parent);
        Refit(parent);
    }

    public void Remove(int leaf)
    {
        int parent = _parents[leaf];
        if (parent == None)
        {
            _root = None;
            return;
        }

        int sibling = _nodes[parent].Left == leaf ? _nodes[parent].Right : _nodes[parent].Left;
        int above = _parents[parent];
        _free[_freeCount++] = parent;
        _parents[sibling] = above;
        if (above == None)
        {
            _root = sibling;
            return;
        }

        Replace(above, parent, sibling);
        Shrink(above);
    }

    /// <summary>Builds the tree anew over leaves that are sorted along a space-filling curve; their boxes are set by <see cref="SetLeaf"/>.</summary>
    public void Build(ulong[] curve, int count)
    {
        Reset(_leafEnd);
        if (count == 0) return;
        _root = Join(curve, 0, count);
        _parents[_root] = None;
    }

    /// <summary>A leaf's box, for <see cref="Build"/>.</summary>
    public void SetLeaf(int leaf, Vector3 min, Vector3 max)
    {
        _nodes[leaf].Min = min;
        _nodes[leaf].Max = max;
    }

    /// <summary>The leaves whose boxes overlap the given one.</summary>
    public void Query(Vector3 min, Vector3 max, List<int> leaves)
    {
        int depth = 0, node = _root;
        while (node != None)
        {
            ref readonly AabbNode box = ref _nodes[node];
            bool down = false;
            if (box.Meets(min, max))
            {
                down = node >= _leafEnd;
                if (!down) leaves.Add(node);
            }

            if (down)
            {
                if (depth == _stack.Length) Array.Resize(ref _stack, 2 * depth);
                _stack[depth++] = box.Right;
                node = box.Left;
            }
            else
            {
                node = depth > 0 ? _stack[--depth] : None;
            }
        }
    }

    /// <summary>
    /// Adds a pair for each leaf whose box overlaps this leaf's when one of them is widened, but for those that are being looked up as well and come first. The ends are added
    /// and rounded as <see cref="BoundsTable.Near"/> does it, so that what is near there is found here.
    /// </summary>
    public void QueryPairs(int leaf, float margin, bool[] pending, PairKeys keys)
    {
        var widening = new Vector3(margin);
        Vector3 min = _nodes[leaf].Min, max = _nodes[leaf].Max + widening;
        int depth = 0, node = _root;
        while (true)
        {
            ref readonly AabbNode box = ref _nodes[node];
            if (box.Min.X <= max.X && min.X <= (float)(box.Max.X + margin) &&
                box.Min.Y <= max.Y && min.Y <= (float)(box.Max.Y + margin) &&
                box.Min.Z <= max.Z && min.Z <= (float)(box.Max.Z + margin))
            {
                if (node >= _leafEnd)
                {
                    if (depth == _stack.Length) Array.Resize(ref _stack, 2 * depth);
                    _stack[depth++] = box.Right;
                    node = box.Left;
                    continue;
                }

                if (node != leaf && !(pending[node] && node < leaf)) keys.Add(PairKeys.Key(leaf, node));
            }

            if (depth == 0) return;
            node = _stack[--depth];
        }
    }

    /// <summary>A tree over part of the curve, cut where the highest bit changes; its depth is that of the bits and, among equal places, logarithmic.</summary>
    private int Join(ulong[] curve, int begin, int end)
    {
        if (end - begin == 1) return (int)(uint)curve[begin];
        int middle = MortonCurve.Split(curve, begin, end);
        int node = _free[--_freeCount];
        int left = Join(curve, begin, middle), right = Join(curve, middle, end);
        _nodes[node].Left = left;
        _nodes[node].Right = right;
        _parents[left] = _parents[right] = node;
        Enclose(node);
        return node;
    }

    /// <summary>
    /// Down from the root: each node entered grows by the new box, so stopping at it, as the box's sibling, costs its grown surface; going on costs what the node itself
    /// grows by and at least the new box's own growth of a child.
    /// </summary>
    private int FindSibling(in AabbNode box)
    {
        int node = _root;
        while (node >= _leafEnd)
        {
            ref readonly AabbNode inner = ref _nodes[node];
            float joined = AabbNode.UnionArea(inner, box), growth = joined - AabbNode.Area(inner);
            float left = growth + DescentCost(_nodes[inner.Left], box, inner.Left < _leafEnd);
            float right = growth + DescentCost(_nodes[inner.Right], box, inner.Right < _leafEnd);
            if (joined < left && joined < right) break;
            node = left < right ? inner.Left : inner.Right;
        }

        return node;
    }

    private static float DescentCost(in AabbNode child, in AabbNode box, bool isLeaf) => isLeaf ? AabbNode.UnionArea(child, box) : AabbNode.UnionArea(child, box) - AabbNode.Area(child);

    /// <summary>From a node to the root: the boxes, and a turn where it lessens the surface.</summary>
    private void Refit(int node)
    {
        for (; node != None; node = _parents[node])
        {
            Turn(node, _nodes[node].Left, _nodes[node].Right);
            Turn(node, _nodes[node].Right, _nodes[node].Left);
            Enclose(node);
        }
    }

    /// <summary>From a node to the root, or to where the removed leaf was not at the edge: the boxes alone; the next insertion turns the branches.</summary>
    private void Shrink(int node)
    {
        for (; node != None; node = _parents[node])
        {
            AabbNode before = _nodes[node];
            Enclose(node);
            if (_nodes[node].Min == before.Min && _nodes[node].Max == before.Max) return;
        }
    }

    /// <summary>Exchanges a child with one of its sibling's children where that makes the sibling smaller; nothing else changes its box.</summary>
    private void Turn(int node, int child, int sibling)
    {
        if (sibling < _leafEnd) return;
        ref AabbNode branch = ref _nodes[sibling];
        float area = AabbNode.Area(branch);
        float withLeft = AabbNode.UnionArea(_nodes[child], _nodes[branch.Left]), withRight = AabbNode.UnionArea(_nodes[child], _nodes[branch.Right]);
        int raised;
        if (withLeft < area && withLeft <= withRight)
        {
            raised = branch.Right;
            branch.Right = child;
        }
        else if (withRight < area)
        {
            raised = branch.Left;
            branch.Left = child;
        }
        else
        {
            return;
        }

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
    }
}
