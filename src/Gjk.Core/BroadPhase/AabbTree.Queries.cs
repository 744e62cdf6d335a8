namespace Gjk.Core;

internal sealed partial class AabbTree
{
    private int[] _stack = new int[64];

    /// <summary>How many nodes, or pairs of nodes, were looked at since the tree was made, for the tests of
    /// cost.</summary>
    public long Visits { get; private set; }

    /// <summary>The leaves whose boxes overlap the given one.</summary>
    public unsafe void Query(Vector3 min, Vector3 max, List<int> leaves)
    {
        int* stack = stackalloc int[MaxDepth];
        int depth = 0, visits = 0, node = _root;
        while (node != None)
        {
            visits++;
            ref readonly AabbNode box = ref _nodes[node];
            bool down = false;
            if (box.Meets(min, max))
            {
                down = node >= _leafEnd;
                if (!down) leaves.Add(node);
            }

            if (down)
            {
                stack[depth++] = box.Right;
                node = box.Left;
            }
            else
            {
                node = depth > 0 ? stack[--depth] : None;
            }
        }

        Visits += visits;
    }

    /// <summary>Adds a pair for each leaf whose box overlaps this leaf's when one of them is widened, but for those
    /// that are being looked up as well and come first. Several threads may look at once.</summary>
    /// <returns>How many nodes were looked at.</returns>
    public unsafe int QueryPairs(int leaf, float margin, bool[] pending, PairKeys keys)
    {
        int* stack = stackalloc int[MaxDepth];
        Vector3 min = _nodes[leaf].Min, max = _nodes[leaf].Max + new Vector3(margin);
        int depth = 0, visits = 0, node = _root;
        while (true)
        {
            visits++;
            ref readonly AabbNode box = ref _nodes[node];
            if (box.IsNear(min, max, margin))
            {
                if (node >= _leafEnd)
                {
                    stack[depth++] = box.Right;
                    node = box.Left;
                    continue;
                }

                if (node != leaf && !(pending[node] && node < leaf)) keys.Add(PairKeys.Key(leaf, node));
            }

            if (depth == 0) return visits;
            node = stack[--depth];
        }
    }

    /// <summary>Counts what <see cref="QueryPairs"/> looked at.</summary>
    public void Count(long visits) => Visits += visits;

    /// <summary>Adds all pairs of leaves whose boxes overlap when one of them is widened: the tree against itself, from
    /// the root down, two subtrees at a time.</summary>
    /// <returns>False where the budget ended it.</returns>
    public bool TryFindPairs(float margin, PairKeys keys, PairBudget budget)
    {
        if (_root == None) return true;
        var widening = new Vector3(margin);
        int depth = 0;
        long visits = 0;
        bool isDone = true;
        Push(ref depth, _root, _root);
        while (depth > 0 && isDone)
        {
            visits++;
            int a = _stack[depth - 2], b = _stack[depth - 1];
            depth -= 2;
            ref readonly AabbNode first = ref _nodes[a];
            if (a == b)
            {
                if (a < _leafEnd) continue;
                Push(ref depth, first.Left, first.Right);
                Push(ref depth, first.Right, first.Right);
                Push(ref depth, first.Left, first.Left);
                continue;
            }

            ref readonly AabbNode second = ref _nodes[b];
            if (!second.IsNear(first.Min, first.Max + widening, margin)) continue;
            if (a < _leafEnd && b < _leafEnd)
            {
                keys.Add(PairKeys.Key(a, b));
                isDone = keys.Count < budget.Limit || budget.Allows(keys);
            }
            else if (b < _leafEnd || (a >= _leafEnd && AabbNode.Area(first) > AabbNode.Area(second)))
            {
                Push(ref depth, first.Right, b);
                Push(ref depth, first.Left, b);
            }
            else
            {
                Push(ref depth, a, second.Right);
                Push(ref depth, a, second.Left);
            }
        }

        Visits += visits;
        return isDone;
    }

    private void Push(ref int depth, int a, int b)
    {
        if (depth + 2 > _stack.Length) Array.Resize(ref _stack, 2 * _stack.Length);
        _stack[depth++] = a;
        _stack[depth++] = b;
    }

    /// <summary>Shows a visitor the leaves whose own boxes a path meets, near ones first as a rule: of two children the
    /// one that the path enters first, and the other is left out where the path was shortened to before it.</summary>
    /// <param name="path">The path.</param>
    /// <param name="boxes">By leaf: a box in the leaf's, which decides.</param>
    /// <param name="visitor">Sees leaves, and may shorten the path.</param>
    /// <returns>How many boxes were looked at.</returns>
    /// <remarks>Changes nothing here, so several threads may ask at once.</remarks>
    public unsafe int Sweep<TVisitor>(in SweptBox path, Aabb[] boxes, ref TVisitor visitor)
        where TVisitor : struct, ISweepVisitor
    {
        if (_root == None || !path.Meets(_nodes[_root].Min, _nodes[_root].Max, path.Limit, out _)) return 0;

        // One for each level: a tree is built anew before it is asked where it has more.
        int* waiting = stackalloc int[MaxDepth];
        double* entries = stackalloc double[MaxDepth];
        int node = _root, depth = 0, visits = 1;
        double limit = path.Limit;
        while (true)
        {
            if (node < _leafEnd)
            {
                visits++;
                if (path.Meets(boxes[node], limit, out _)) limit = Math.Min(limit, visitor.Visit(node));
            }
            else
            {
                ref readonly AabbNode box = ref _nodes[node];
                ref readonly AabbNode left = ref _nodes[box.Left];
                ref readonly AabbNode right = ref _nodes[box.Right];
                visits += 2;
                bool isLeft = path.Meets(left.Min, left.Max, limit, out double leftEntry);
                bool isRight = path.Meets(right.Min, right.Max, limit, out double rightEntry);
                if (isLeft && isRight)
                {
                    bool isLeftFirst = leftEntry <= rightEntry;
                    node = isLeftFirst ? box.Left : box.Right;
                    waiting[depth] = isLeftFirst ? box.Right : box.Left;
                    entries[depth++] = isLeftFirst ? rightEntry : leftEntry;
                    continue;
                }

                if (isLeft || isRight)
                {
                    node = isLeft ? box.Left : box.Right;
                    continue;
                }
            }

            while (depth > 0 && entries[depth - 1] > limit) depth--;
            if (depth == 0) return visits;
            node = waiting[--depth];
        }
    }

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
        if (depth >= MaxCurveDepth) middle = begin + (end - begin) / 2;
        int node = _free[--_freeCount];
        int left = Join(order, begin, middle, depth + 1), right = Join(order, middle, end, depth + 1);
        _nodes[node].Left = left;
        _nodes[node].Right = right;
        _parents[left] = _parents[right] = node;
        Enclose(node);
        return node;
    }
}
