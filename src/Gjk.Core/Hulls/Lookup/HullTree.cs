using System;
#if NET
using System.Runtime.Intrinsics;
#endif

namespace Gjk.Core;

/// <summary>
/// A tree of boxes over a hull's vertices, searched by branch and bound. It finds the vertex of the scan where lists
/// would be long: towards a face with thousands of corners, or along a rim.
/// </summary>
/// <remarks>
/// Each node has two boxes. One is turned so that it fits tightly, whatever the slope of the face. Its bound is taken
/// with an allowance for rounding. The other is along the axes. Its bound is computed by the operations of a vertex's
/// dot product, in their order, from the box's furthest coordinates. Rounding is monotone, so this bound is not below
/// the computed dot product of any vertex inside, without an allowance. A node can be left out where it is below the
/// best dot product, or equal to it with no lower id inside: that is the scan's rule.
/// </remarks>
internal sealed class HullTree
{
    /// <summary>
    /// Count: vertices of a leaf. A scan of so many takes about as long as a visit to a node. Measured.
    /// </summary>
    public const int LeafVertices = 8 * HullCells.Lanes;

    /// <summary>
    /// Relative to m, the sum of |d_i| times the largest coordinate on axis i: how far a turned box's bound can be
    /// below a computed dot product inside. With u = 2^-53 it is at most 25 u: 3 u in that dot product, 3 u in that of
    /// the vertex that bounds are relative to, 1 u in the centre of the box, 2 u where that vertex is subtracted, 12 u
    /// in the product with the direction and in the sum, 4 u where this and the best's level are added. The sides of
    /// the box cover whatever else is rounded. This is 32 u. Pinned by HullLookupTests.
    /// </summary>
    private const double Rounding = 1.0 / (1L << 48);

    /// <summary>In roundings: where a bound is this close to the best, the box along the axes is asked too.</summary>
    private const double Near = 16;

    /// <summary>Count: nodes that wait on the way to a leaf; 2^31 vertices have fewer.</summary>
    private const int MaxDepth = 40;

    private readonly Vector3D _scale, _inverse, _largest;
    private readonly HullTreeNode[] _nodes;

    /// <param name="nodes">The root first.</param>
    /// <param name="inverse">The factors of the nodes' coordinates: powers of two, 0 for an axis without
    /// extent.</param>
    /// <param name="largest">The largest magnitude of such a coordinate on each axis.</param>
    public HullTree(HullTreeNode[] nodes, in Vector3D inverse, in Vector3D largest)
    {
        _nodes = nodes;
        _inverse = inverse;
        _scale = new Vector3D(Inverse(inverse.X), Inverse(inverse.Y), Inverse(inverse.Z));
        _largest = largest;
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
    /// <param name="start">The slot of a vertex that is furthest nearby. Bounds are relative to it.</param>
    public int Find(HullCells cells, in Vector3D d, int start)
    {
        var trace = default(Unobserved);
        return Find(cells, d, start, ref trace);
    }

    /// <summary>The same, observed.</summary>
    public unsafe int Find<TTrace>(HullCells cells, in Vector3D d, int start, ref TTrace trace)
        where TTrace : struct, ITrace
    {
        HullBlocks.Read(cells.Coordinates, start, out Vector3D origin);
        origin = Vector3D.Multiply(origin, _inverse);
        Vector3D s = Vector3D.Multiply(d, _scale);
        double size = Math.Abs(s.X) * _largest.X + Math.Abs(s.Y) * _largest.Y + Math.Abs(s.Z) * _largest.Z;
        double rounding = Rounding * size, near = Near * rounding;
        double level = HullBlocks.Dot(cells.Coordinates, start, d), best = level;
        int* waiting = stackalloc int[MaxDepth];
        double* bounds = stackalloc double[MaxDepth];
        int depth = 0, bestId = cells.Ids[start], bestSlot = start, next = _nodes[0].Next;
        while (true)
        {
            while (next >= 0)
            {
                trace.Step();
                ref HullTreeNode left = ref _nodes[next], right = ref _nodes[next + 1];
                double leftBound = Bound(ref left, s, origin) + rounding;
                double rightBound = Bound(ref right, s, origin) + rounding;
                double least = best - level, clear = least + near;
                bool isLeft = leftBound > clear || (leftBound >= least && CanHoldBetter(ref left, d, best, bestId));
                bool isRight = rightBound > clear || (rightBound >= least && CanHoldBetter(ref right, d, best, bestId));
                if (!isLeft && !isRight) break;
                if (isLeft && isRight)
                {
                    // Where the bounds do not tell, the lower id may win the tie.
                    isLeft = Math.Abs(leftBound - rightBound) <= rounding
                        ? left.LeastId < right.LeastId
                        : leftBound > rightBound;
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
                bool isBetter = dot > best || (dot == best && id < bestId);
                if (isBetter) (best, bestId, bestSlot) = (dot, id, slot);
            }

            while (true)
            {
                if (depth == 0) return bestSlot;
                depth--;
                ref HullTreeNode node = ref _nodes[waiting[depth]];
                next = node.Next;
                double bound = bounds[depth], least = best - level;
                if (bound > least + near || (bound >= least && CanHoldBetter(ref node, d, best, bestId))) break;
            }
        }
    }

    /// <summary>False when no vertex inside a node exceeds the best, or is level with it and has a lower id.</summary>
    private static bool CanHoldBetter(ref HullTreeNode node, in Vector3D d, double best, int bestId)
    {
        double x = d.X < 0 ? node.MinX : node.MaxX;
        double y = d.Y < 0 ? node.MinY : node.MaxY;
        double z = d.Z < 0 ? node.MinZ : node.MaxZ;
        double bound = x * d.X + y * d.Y + z * d.Z;
        return bound > best || (bound == best && node.LeastId < bestId);
    }

    /// <summary>How far beyond a vertex a turned box reaches.</summary>
    private static double Bound(ref HullTreeNode node, in Vector3D s, in Vector3D origin)
    {
#if NET
        ref double x = ref node.CenterX;
        Vector256<double> along = (Vector256.LoadUnsafe(ref x) - Vector256.CreateScalar(origin.X)) * s.X
            + (Vector256.LoadUnsafe(ref x, 4) - Vector256.CreateScalar(origin.Y)) * s.Y
            + (Vector256.LoadUnsafe(ref x, 8) - Vector256.CreateScalar(origin.Z)) * s.Z;
        Vector256<long> withoutSigns = Vector256.Create(-1, long.MaxValue, long.MaxValue, long.MaxValue);
        return Vector256.Sum((along.AsInt64() & withoutSigns).AsDouble());
#else
        return (node.CenterX - origin.X) * s.X + (node.CenterY - origin.Y) * s.Y + (node.CenterZ - origin.Z) * s.Z
            + (Math.Abs(node.FirstX * s.X + node.FirstY * s.Y + node.FirstZ * s.Z)
            + Math.Abs(node.SecondX * s.X + node.SecondY * s.Y + node.SecondZ * s.Z)
            + Math.Abs(node.ThirdX * s.X + node.ThirdY * s.Y + node.ThirdZ * s.Z));
#endif
    }

    private static double Inverse(double power) => power > 0 ? 1 / power : 0;

    private struct Unobserved : ITrace
    {
        public void Step()
        {
        }
    }
}
