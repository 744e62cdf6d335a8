namespace Gjk.Core;

/// <summary>A tree of boxes over a hull's vertices, searched by branch and bound. It finds the vertex of the scan where
/// lists would be long: towards a face with thousands of corners, or along a rim.</summary>
/// <remarks>Each node has two boxes, and its bound is the lower of theirs. One is turned so that it fits tightly,
/// whatever the slope of the face. Its bound is taken with an allowance for rounding, in proportion to the coordinates
/// in the node: a hull can have corners at every scale down to 10^-38 of its size, and an allowance in proportion to
/// the hull would hide all that is small. The other box is along the axes. Its bound is computed by the operations of a
/// vertex's dot product, in their order, from the box's furthest coordinates. Rounding is monotone, so this bound is
/// not below the computed dot product of any vertex inside, without an allowance. A node can be left out where its
/// bound is below the best dot product, or equal to it with no lower id inside: that is the scan's rule.</remarks>
/// <param name="nodes">The root first.</param>
/// <param name="inverse">The factors of the nodes' coordinates: powers of two, 0 for an axis without
/// extent.</param>
internal sealed class HullTree(HullTreeNode[] nodes, in Double3 inverse)
{
    /// <summary>Count: vertices of a leaf. A scan of so many takes about as long as a visit to a node.
    /// Measured.</summary>
    public const int LeafVertices = 8 * HullCells.Lanes;

    /// <summary>Relative to m, the sum of |c_i d_i| over the coordinates c_i of a turned box's four vectors (centre and
    /// half sides): how far its bound can be below a computed dot product inside. With u = 2^-53 it is at most 12 u: 3
    /// u in that dot product, whose terms add up to no more than m, 1 u in the centre, 3 u in the products with the
    /// direction and their sums, 5 u in the sum of the four and of this. The sides of the box cover whatever else is
    /// rounded. This is 16 u. A larger one costs time alone. Pinned by HullLookupTests.</summary>
    private const double Rounding = 1.0 / (1L << 49);

    /// <summary>Absolute, 2^-1060: what products lose that are no normal numbers. Two dozen of them lose 2^-1075 each,
    /// some times a coordinate of up to 16. The smallest dot product that counts is 2^-849: a float with a direction of
    /// the least safe reach.</summary>
    private const double Underflow = double.Epsilon * (1 << 14);

    /// <summary>Count: nodes that wait on the way to a leaf; 2^31 vertices have fewer.</summary>
    private const int MaxDepth = 40;

    private readonly Double3 _scale = new(Inverse(inverse.X), Inverse(inverse.Y), Inverse(inverse.Z));
    private readonly HullTreeNode[] _nodes = nodes;

    /// <summary>The slot of the furthest vertex.</summary>
    /// <param name="cells">Holds the leaves' blocks.</param>
    /// <param name="d">The direction, prepared.</param>
    /// <param name="start">The slot of a vertex that is furthest nearby.</param>
    /// <param name="steps">How many pairs of children, and leaves, were compared.</param>
    public unsafe int Find(HullCells cells, in Double3 d, int start, out int steps)
    {
        steps = 0;
        Double3 s = Double3.Multiply(d, _scale);
        double best = HullBlocks.Dot(cells.Coordinates, start, d);
        int* waiting = stackalloc int[MaxDepth];
        double* bounds = stackalloc double[MaxDepth];
        int depth = 0, bestId = cells.Ids[start], bestSlot = start, next = _nodes[0].Next;
        while (true)
        {
            while (next >= 0)
            {
                steps++;
                ref HullTreeNode left = ref _nodes[next], right = ref _nodes[next + 1];
                double leftBound = Bound(ref left, s, d), rightBound = Bound(ref right, s, d);
                bool isLeft = CanHoldBetter(ref left, leftBound, best, bestId);
                bool isRight = CanHoldBetter(ref right, rightBound, best, bestId);
                if (!isLeft && !isRight) break;
                if (isLeft && isRight)
                {
                    // Of vertices that are level the lowest id wins.
                    isLeft = leftBound == rightBound ? left.LeastId < right.LeastId : leftBound > rightBound;
                    waiting[depth] = isLeft ? next + 1 : next;
                    bounds[depth++] = isLeft ? rightBound : leftBound;
                }

                next = isLeft ? left.Next : right.Next;
            }

            if (next < 0)
            {
                steps++;
                int end = Math.Min(~next + LeafVertices / HullCells.Lanes, cells.Ids.Length / HullCells.Lanes);
                int slot = HullBlocks.Best(cells.Coordinates, ~next, end, d), id = cells.Ids[slot];
                double dot = HullBlocks.Dot(cells.Coordinates, slot, d);
                bool isBetter = dot > best || (dot == best && id < bestId);
                if (isBetter) (best, bestId, bestSlot) = (dot, id, slot);
            }

            while (true)
            {
                if (depth == 0) return bestSlot;
                depth--;
                ref HullTreeNode node = ref _nodes[waiting[depth]];
                next = node.Next;
                if (CanHoldBetter(ref node, bounds[depth], best, bestId)) break;
            }
        }
    }

    /// <summary>False when no vertex inside a node exceeds the best, or is level with it and has a lower id.</summary>
    private static bool CanHoldBetter(ref HullTreeNode node, double bound, double best, int bestId) =>
        bound > best || (bound == best && node.LeastId < bestId);

    /// <summary>No computed dot product of a vertex inside is larger.</summary>
    private static double Bound(ref HullTreeNode node, in Double3 s, in Double3 d)
    {
        double x = d.X < 0 ? node.MinX : node.MaxX;
        double y = d.Y < 0 ? node.MinY : node.MaxY;
        double z = d.Z < 0 ? node.MinZ : node.MaxZ;
        double straight = x * d.X + y * d.Y + z * d.Z;
#if NET
        ref double center = ref node.CenterX;
        Vector256<double> alongX = Vector256.LoadUnsafe(ref center) * s.X;
        Vector256<double> alongY = Vector256.LoadUnsafe(ref center, 4) * s.Y;
        Vector256<double> alongZ = Vector256.LoadUnsafe(ref center, 8) * s.Z;
        Vector256<double> size = Vector256.Abs(alongX) + Vector256.Abs(alongY) + Vector256.Abs(alongZ);
        Vector256<long> withoutSigns = Vector256.Create(-1, long.MaxValue, long.MaxValue, long.MaxValue);
        Vector256<double> along = ((alongX + alongY + alongZ).AsInt64() & withoutSigns).AsDouble();
        double turned = Vector256.Sum(along + size * Rounding) + Underflow;
#else
        double centerX = node.CenterX * s.X, centerY = node.CenterY * s.Y, centerZ = node.CenterZ * s.Z;
        double reach = 0, size = Math.Abs(centerX) + Math.Abs(centerY) + Math.Abs(centerZ);
        Add(node.FirstX * s.X, node.FirstY * s.Y, node.FirstZ * s.Z, ref reach, ref size);
        Add(node.SecondX * s.X, node.SecondY * s.Y, node.SecondZ * s.Z, ref reach, ref size);
        Add(node.ThirdX * s.X, node.ThirdY * s.Y, node.ThirdZ * s.Z, ref reach, ref size);
        double turned = centerX + centerY + centerZ + reach + size * Rounding + Underflow;
#endif
        return turned < straight ? turned : straight;
    }

#if !NET
    private static void Add(double x, double y, double z, ref double reach, ref double size)
    {
        reach += Math.Abs(x + y + z);
        size += Math.Abs(x) + Math.Abs(y) + Math.Abs(z);
    }
#endif

    private static double Inverse(double power) => power > 0 ? 1 / power : 0;
}
