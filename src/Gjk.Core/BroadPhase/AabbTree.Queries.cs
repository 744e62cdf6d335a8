namespace Gjk.Core;

internal sealed partial class AabbTree
{
    private int[] _stack = new int[64];

    /// <summary>How many nodes, or pairs of nodes, were looked at since the tree was made, for the tests of
    /// cost.</summary>
    public long Visits { get; private set; }

    /// <summary>The leaves whose boxes overlap the given one.</summary>
    public void Query(Vector3 min, Vector3 max, List<int> leaves)
    {
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
                if (depth == _stack.Length) Array.Resize(ref _stack, 2 * depth);
                _stack[depth++] = box.Right;
                node = box.Left;
            }
            else
            {
                node = depth > 0 ? _stack[--depth] : None;
            }
        }

        Visits += visits;
    }

    /// <summary>Adds a pair for each leaf whose box overlaps this leaf's when one of them is widened, but for those
    /// that are being looked up as well and come first.</summary>
    public void QueryPairs(int leaf, float margin, bool[] pending, PairKeys keys)
    {
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
                    if (depth == _stack.Length) Array.Resize(ref _stack, 2 * depth);
                    _stack[depth++] = box.Right;
                    node = box.Left;
                    continue;
                }

                if (node != leaf && !(pending[node] && node < leaf)) keys.Add(PairKeys.Key(leaf, node));
            }

            if (depth == 0) break;
            node = _stack[--depth];
        }

        Visits += visits;
    }

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
}
