using System;
#if NET
using System.Runtime.Intrinsics;
#endif

namespace Gjk.Core;

/// <summary>
/// A tree of boxes over a hull's vertices, searched by branch and bound. It finds the vertex of the scan where lists would be
/// long: towards a face with thousands of corners, or along a rim.
/// </summary>
/// <remarks>
/// Each node has two boxes. One is turned so that it fits tightly, whatever the slope of the face. Its bound is taken with an allowance for
/// rounding. The other is along the axes. Its bound is computed by the operations of a vertex's dot product, in their order, from
/// the box's furthest coordinates. Rounding is monotone, so this bound is not below the computed dot product of any vertex inside, without an
/// allowance. A node can be left out where it is below the best dot product, or equal to it with no lower id inside: that is the scan's rule.
/// </remarks>
internal sealed class HullTree
{
    /// <summary>Count: vertices of a leaf. A scan of so many takes about as long as a visit to a node. Measured.</summary>
    public const int LeafVertices = 4 * HullCells.Lanes;

    /// <summary>
    /// Relative to the sum of the stretched direction's components: how far a turned box's bound can be below a computed dot product inside. With coordinates of
    /// at most 4 and half sides of at most 2 it is 90 u, u = 2^-53: 12 u in the dot product, 20 u in stretching and in the centre, 60 u in the
    /// bound. What fitting the box rounds is in its sides. Pinned by HullLookupTests.
    /// </summary>
    private const double Rounding = 1.0 / (1L << 46);

    /// <summary>In roundings: where a bound is this close to the best, the box along the axes is asked too.</summary>
    private const double Near = 16;

    /// <summary>Count: nodes that wait on the way to a leaf; 2^31 vertices have fewer.</summary>
    private const int MaxDepth = 40;

    private readonly Vector3D _stretch;
    private readonly HullTreeNode[] _nodes;

    public HullTree(HullTreeNode[] nodes, in Vector3D stretch)
    {
        _nodes = nodes;
        _stretch = stretch;
    }

    /// <summary>What a search tells while it runs.</summary>
    public interface ITrace
    {
        /// <summary>Two children, or the vertices of a leaf, are looked at.</summary>
        void Step();
    }

    /// <summary>The slot of the furthest vertex.</summary>
    /// <param name="cells">Holds the leaves' blocks.</param>
    /// <param name="d">The direction, prepared.</param>
    public int Find(HullCells cells, in Vector3D d)
    {
        var trace = default(NoTrace);
        return Find(cells, d, ref trace);
    }

    /// <summary>The same, observed.</summary>
    public unsafe int Find<TTrace>(HullCells cells, in Vector3D d, ref TTrace trace)
        where TTrace : struct, ITrace
    {
        Vector3D s = Vector3D.Multiply(d, _stretch);
        double rounding = (Math.Abs(s.X) + Math.Abs(s.Y) + Math.Abs(s.Z)) * Rounding, near = Near * rounding;
        int* waiting = stackalloc int[MaxDepth];
        double* bounds = stackalloc double[MaxDepth];
        int depth = 0, bestId = int.MaxValue, bestSlot = -1, next = _nodes[0].Next;
        double best = double.NegativeInfinity;
        while (true)
        {
            while (next >= 0)
            {
                trace.Step();
                ref HullTreeNode left = ref _nodes[next], right = ref _nodes[next + 1];
                double leftBound = Bound(ref left, s) + rounding, rightBound = Bound(ref right, s) + rounding;
                bool isLeft = leftBound > best + near || (leftBound >= best && CanHoldBetter(ref left, d, best, bestId));
                bool isRight = rightBound > best + near || (rightBound >= best && CanHoldBetter(ref right, d, best, bestId));
                if (!isLeft && !isRight) break;
                if (isLeft && isRight)
                {
                    // Where the bounds do not tell, the lower id may win the tie.
                    isLeft = Math.Abs(leftBound - rightBound) <= rounding ? left.LeastId < right.LeastId : leftBound > rightBound;
                    waiting[depth] = isLeft ? next + 1 : next;
                    bounds[depth++] = isLeft ? rightBound : leftBound;
                }

                next = isLeft ? left.Next : right.Next;
            }

            if (next < 0)
            {
                trace.Step();
                int end = Math.Min(~next + LeafVertices / HullCells.Lanes, cells.Ids.Length / HullCells.Lanes);
                int slot = HullBlocks.Best(cells.Coordinates, ~next, end, d), id = cells.Ids[slot];
                double dot = HullBlocks.Dot(cells.Coordinates, slot, d);
                if (bestSlot < 0 || dot > best || (dot == best && id < bestId)) (best, bestId, bestSlot) = (dot, id, slot);
            }

            while (true)
            {
                if (depth == 0) return bestSlot;
                depth--;
                ref HullTreeNode node = ref _nodes[waiting[depth]];
                next = node.Next;
                if (bounds[depth] > best + near || (bounds[depth] >= best && CanHoldBetter(ref node, d, best, bestId))) break;
            }
        }
    }

    /// <summary>False when no vertex inside a node exceeds the best, or is level with it and has a lower id.</summary>
    private static bool CanHoldBetter(ref HullTreeNode node, in Vector3D d, double best, int bestId)
    {
        double x = d.X < 0 ? node.MinX : node.MaxX, y = d.Y < 0 ? node.MinY : node.MaxY, z = d.Z < 0 ? node.MinZ : node.MaxZ;
        double bound = x * d.X + y * d.Y + z * d.Z;
        return bound > best || (bound == best && node.LeastId < bestId);
    }

    private static double Bound(ref HullTreeNode node, in Vector3D s)
    {
#if NET
        ref double x = ref node.CenterX;
        Vector256<double> along = Vector256.LoadUnsafe(ref x) * s.X + Vector256.LoadUnsafe(ref x, 4) * s.Y + Vector256.LoadUnsafe(ref x, 8) * s.Z;
        return Vector256.Sum((along.AsInt64() & Vector256.Create(-1, long.MaxValue, long.MaxValue, long.MaxValue)).AsDouble());
#else
        return node.CenterX * s.X + node.CenterY * s.Y + node.CenterZ * s.Z
            + (Math.Abs(node.FirstX * s.X + node.FirstY * s.Y + node.FirstZ * s.Z)
            + Math.Abs(node.SecondX * s.X + node.SecondY * s.Y + node.SecondZ * s.Z)
            + Math.Abs(node.ThirdX * s.X + node.ThirdY * s.Y + node.ThirdZ * s.Z));
#endif
    }

    private struct NoTrace : ITrace
    {
        public void Step()
        {
        }
    }
}
