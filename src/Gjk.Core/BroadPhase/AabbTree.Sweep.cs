namespace Gjk.Core;

internal sealed partial class AabbTree
{
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
}
