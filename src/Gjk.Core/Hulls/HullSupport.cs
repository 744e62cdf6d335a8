using System;
#if NET
using System.Numerics;
#endif
using System.Runtime.CompilerServices;
#if NET
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
#endif

namespace Gjk.Core;

/// <summary>The vertex of a hull that is furthest in a direction: the lowest id among those whose dot product, in double, is largest.</summary>
/// <remarks>
/// <see cref="Scan"/> is the definition; <see cref="Find"/> gets the same vertex from the direction's cell (<see cref="HullCells"/>). The dot product is
/// (x dx + y dy) + z dz, three products and two sums rounded one by one, in every path: a fused multiply-add in one of them would break ties differently.
/// </remarks>
internal static class HullSupport
{
    /// <summary>The furthest vertex: by the signs for a box, by the cells for a large hull, by a scan of all blocks for a small one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Find(ConvexHull hull, in Vector3D direction, out Vector3D point)
    {
        HullCells cells = hull.Cells;
        if (cells.Kind == HullCells.SupportKind.Box) return BoxCorner(cells, direction, out point);
        if (cells.Kind == HullCells.SupportKind.Scan) return Corner(cells, Best(cells, 0, cells.BlockCount, direction), out point);
        int cell = CellOf(cells, direction.X, direction.Y, direction.Z);
        return cells.Ids[Corner(cells, Best(cells, cells.Start[cell], cells.Start[cell + 1], direction), out point)];
    }

    /// <summary>A component of 0 leaves two corners level, and the lowest id is wanted: the scan knows.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int BoxCorner(HullCells cells, in Vector3D direction, out Vector3D point)
    {
        double x = direction.X, y = direction.Y, z = direction.Z;
        int slot = x == 0 || y == 0 || z == 0
            ? ScanBox(cells, x, y, z)
            : cells.BoxSlots[BranchFree.IsNegative(x) | (BranchFree.IsNegative(y) << 1) | (BranchFree.IsNegative(z) << 2)];
        return Corner(cells, slot, out point);
    }

    private static int ScanBox(HullCells cells, double x, double y, double z) => Best(cells, 0, cells.BlockCount, new Vector3D(x, y, z));

    /// <summary>The definition that every faster way must agree with.</summary>
    public static int Scan(ConvexHull hull, in Vector3D direction)
    {
        float[] xs = hull.X, ys = hull.Y, zs = hull.Z;
        double dx = direction.X, dy = direction.Y, dz = direction.Z;
        int best = 0;
        double bestDot = double.NegativeInfinity;
        for (int i = 0; i < hull.VertexCount; i++)
        {
            double dot = dx * xs[i] + dy * ys[i] + dz * zs[i];
            if (dot > bestDot)
            {
                bestDot = dot;
                best = i;
            }
        }

        return best;
    }

    /// <summary>The cube's face by the largest stretched component, then the cell by the other two over it. A zero or NaN direction gives some cell.</summary>
    private static int CellOf(HullCells cells, double dx, double dy, double dz)
    {
        double x = dx * cells.Stretch.X, y = dy * cells.Stretch.Y, z = dz * cells.Stretch.Z;
        double ax = Math.Abs(x), ay = Math.Abs(y), az = Math.Abs(z);
        int face;
        double u, v, w;
        if (ax >= ay && ax >= az)
        {
            (u, v, w) = (y, z, ax);
            face = x < 0 ? 1 : 0;
        }
        else if (ay >= az)
        {
            (u, v, w) = (x, z, ay);
            face = y < 0 ? 3 : 2;
        }
        else
        {
            (u, v, w) = (x, y, az);
            face = z < 0 ? 5 : 4;
        }

        int side = cells.Side;
        double scale = 0.5 * side / w, middle = 0.5 * side;
        return (face * side + Index(v * scale + middle, side)) * side + Index(u * scale + middle, side);
    }

    /// <summary>The integer part, held inside 0 .. side - 1 whatever comes in.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Index(double position, int side)
    {
        int index = (int)position;
        if (index >= side) index = side - 1;
        return index < 0 ? 0 : index;
    }

#if NET
    /// <summary>The best of a run of blocks, four corners at a time.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Best(HullCells cells, int block, int end, in Vector3D direction)
    {
        ref float coordinates = ref MemoryMarshal.GetArrayDataReference(cells.Coordinates);
        Vector256<double> dx = Vector256.Create(direction.X), dy = Vector256.Create(direction.Y), dz = Vector256.Create(direction.Z);
        Vector256<double> first = Dots(ref coordinates, block, dx, dy, dz);
        if (end - block == 1)
            return block * HullCells.Lanes + FirstLane(Vector256.Equals(first, Highest(first)).ExtractMostSignificantBits());
        if (end - block > 2) return BestOfMany(ref coordinates, block, end, direction.X, direction.Y, direction.Z);

        Vector256<double> second = Dots(ref coordinates, block + 1, dx, dy, dz);
        Vector256<double> highest = Highest(Larger(first, second));
        uint lanes = Vector256.Equals(first, highest).ExtractMostSignificantBits() | Vector256.Equals(second, highest).ExtractMostSignificantBits() << HullCells.Lanes;
        return block * HullCells.Lanes + FirstLane(lanes);
    }

    /// <summary>Reads the corner in a slot; gives the slot back.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Corner(HullCells cells, int slot, out Vector3D point)
    {
        ref float coordinates = ref MemoryMarshal.GetArrayDataReference(cells.Coordinates);
        ref float x = ref Unsafe.Add(ref coordinates, (uint)slot / HullCells.Lanes * HullCells.BlockFloats + (uint)slot % HullCells.Lanes);
        point = new Vector3D(x, Unsafe.Add(ref x, HullCells.Lanes), Unsafe.Add(ref x, 2 * HullCells.Lanes));
        return slot;
    }

    /// <summary>Each lane keeps its first highest; of the lanes that tie for the whole run's highest the lowest slot wins.</summary>
    private static int BestOfMany(ref float coordinates, int block, int end, double x, double y, double z)
    {
        Vector256<double> dx = Vector256.Create(x), dy = Vector256.Create(y), dz = Vector256.Create(z);
        Vector256<double> best = Dots(ref coordinates, block, dx, dy, dz);
        Vector256<long> bestBlock = Vector256.Create((long)block), now = bestBlock;
        for (int i = block + 1; i < end; i++)
        {
            now += Vector256<long>.One;
            Vector256<double> dots = Dots(ref coordinates, i, dx, dy, dz);
            Vector256<double> better = Vector256.GreaterThan(dots, best);
            best = Vector256.ConditionalSelect(better, dots, best);
            bestBlock = Vector256.ConditionalSelect(better.AsInt64(), now, bestBlock);
        }

        uint lanes = Vector256.Equals(best, Highest(best)).ExtractMostSignificantBits();
        int slot = int.MaxValue;
        for (; lanes != 0; lanes &= lanes - 1)
        {
            int lane = BitOperations.TrailingZeroCount(lanes);
            slot = Math.Min(slot, (int)bestBlock.GetElement(lane) * HullCells.Lanes + lane);
        }

        return slot == int.MaxValue ? block * HullCells.Lanes : slot;
    }

    /// <summary>The largest lane, in every lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Highest(Vector256<double> v)
    {
        v = Larger(v, Vector256.Shuffle(v, Vector256.Create(2L, 3, 0, 1)));
        return Larger(v, Vector256.Shuffle(v, Vector256.Create(1L, 0, 3, 2)));
    }

    /// <summary>The larger of two lanes by one instruction; what it does with NaN and with the sign of 0 does not matter to the comparisons that follow.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Larger(Vector256<double> a, Vector256<double> b) =>
#if NET9_0_OR_GREATER
        Vector256.MaxNative(a, b);
#else
        Vector256.Max(a, b);
#endif

    /// <summary>The lowest set bit; with NaN dot products none is set, and lane 0 will do.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int FirstLane(uint lanes) => BitOperations.TrailingZeroCount(lanes) & 7;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Dots(ref float coordinates, int block, Vector256<double> dx, Vector256<double> dy, Vector256<double> dz)
    {
        ref float x = ref Unsafe.Add(ref coordinates, block * HullCells.BlockFloats);
        return Widen(ref x) * dx + Widen(ref Unsafe.Add(ref x, HullCells.Lanes)) * dy + Widen(ref Unsafe.Add(ref x, 2 * HullCells.Lanes)) * dz;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Widen(ref float four) => Vector256.WidenLower(Vector128.LoadUnsafe(ref four).ToVector256Unsafe());
#else
    /// <summary>The best of a run of blocks, one corner at a time.</summary>
    private static int Best(HullCells cells, int block, int end, in Vector3D direction)
    {
        float[] coordinates = cells.Coordinates;
        double dx = direction.X, dy = direction.Y, dz = direction.Z, bestDot = double.NegativeInfinity;
        int best = block * HullCells.Lanes;
        for (int i = block; i < end; i++)
        {
            int at = i * HullCells.BlockFloats;
            for (int lane = 0; lane < HullCells.Lanes; lane++, at++)
            {
                double dot = coordinates[at] * dx + coordinates[at + HullCells.Lanes] * dy + coordinates[at + 2 * HullCells.Lanes] * dz;
                if (!(dot > bestDot)) continue;
                bestDot = dot;
                best = i * HullCells.Lanes + lane;
            }
        }

        return best;
    }

    /// <summary>Reads the corner in a slot; gives the slot back.</summary>
    private static int Corner(HullCells cells, int slot, out Vector3D point)
    {
        float[] coordinates = cells.Coordinates;
        int x = slot / HullCells.Lanes * HullCells.BlockFloats + slot % HullCells.Lanes;
        point = new Vector3D(coordinates[x], coordinates[x + HullCells.Lanes], coordinates[x + 2 * HullCells.Lanes]);
        return slot;
    }
#endif
}
