using System;
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
    /// <summary>The furthest vertex by the cells.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Find(ConvexHull hull, in Vector3D direction, out Vector3D point)
    {
        HullCells cells = hull.Cells;
        int cell = cells.Side == 0 ? 0 : CellOf(cells, direction);
        return Best(cells, cells.Start[cell], cells.Start[cell + 1], direction, out point);
    }

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
    private static int CellOf(HullCells cells, in Vector3D direction)
    {
        double x = direction.X * cells.Stretch.X, y = direction.Y * cells.Stretch.Y, z = direction.Z * cells.Stretch.Z;
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
    private static int Best(HullCells cells, int block, int end, in Vector3D direction, out Vector3D point)
    {
        ref float coordinates = ref MemoryMarshal.GetArrayDataReference(cells.Coordinates);
        Vector256<double> dx = Vector256.Create(direction.X), dy = Vector256.Create(direction.Y), dz = Vector256.Create(direction.Z);
        Vector256<double> best = Dots(ref coordinates, block, dx, dy, dz);
        int at = block;
        if (end - block > 1) BestOfMany(ref coordinates, block, end, dx, dy, dz, ref best, ref at);

        Vector256<double> highest = Vector256.Max(best, Vector256.Shuffle(best, Vector256.Create(2L, 3, 0, 1)));
        highest = Vector256.Max(highest, Vector256.Shuffle(highest, Vector256.Create(1L, 0, 3, 2)));
        int lane = System.Numerics.BitOperations.TrailingZeroCount(Vector256.Equals(best, highest).ExtractMostSignificantBits() | 8);
        ref float x = ref Unsafe.Add(ref coordinates, at * HullCells.BlockFloats + lane);
        point = new Vector3D(x, Unsafe.Add(ref x, HullCells.Lanes), Unsafe.Add(ref x, 2 * HullCells.Lanes));
        return Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(cells.Ids), at * HullCells.Lanes + lane);
    }

    /// <summary>The first block that holds the run's largest dot product, with its dot products.</summary>
    private static void BestOfMany(
        ref float coordinates, int block, int end, in Vector256<double> dx, in Vector256<double> dy, in Vector256<double> dz, ref Vector256<double> best, ref int at)
    {
        Vector256<double> highest = best;
        for (int i = block + 1; i < end; i++) highest = Vector256.Max(highest, Dots(ref coordinates, i, dx, dy, dz));
        highest = Vector256.Max(highest, Vector256.Shuffle(highest, Vector256.Create(2L, 3, 0, 1)));
        highest = Vector256.Max(highest, Vector256.Shuffle(highest, Vector256.Create(1L, 0, 3, 2)));
        for (int i = block; i < end; i++)
        {
            best = Dots(ref coordinates, i, dx, dy, dz);
            at = i;
            if (Vector256.EqualsAny(best, highest)) return;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Dots(ref float coordinates, int block, in Vector256<double> dx, in Vector256<double> dy, in Vector256<double> dz)
    {
        ref float x = ref Unsafe.Add(ref coordinates, block * HullCells.BlockFloats);
        return Widen(ref x) * dx + Widen(ref Unsafe.Add(ref x, HullCells.Lanes)) * dy + Widen(ref Unsafe.Add(ref x, 2 * HullCells.Lanes)) * dz;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Widen(ref float four) => Vector256.WidenLower(Vector128.LoadUnsafe(ref four).ToVector256Unsafe());
#else
    /// <summary>The best of a run of blocks, one corner at a time.</summary>
    private static int Best(HullCells cells, int block, int end, in Vector3D direction, out Vector3D point)
    {
        float[] coordinates = cells.Coordinates;
        double dx = direction.X, dy = direction.Y, dz = direction.Z, bestDot = double.NegativeInfinity;
        int best = block * HullCells.Lanes, bestAt = block * HullCells.BlockFloats;
        for (int i = block; i < end; i++)
        {
            int at = i * HullCells.BlockFloats;
            for (int lane = 0; lane < HullCells.Lanes; lane++, at++)
            {
                double dot = coordinates[at] * dx + coordinates[at + HullCells.Lanes] * dy + coordinates[at + 2 * HullCells.Lanes] * dz;
                if (!(dot > bestDot)) continue;
                bestDot = dot;
                best = i * HullCells.Lanes + lane;
                bestAt = at;
            }
        }

        point = new Vector3D(coordinates[bestAt], coordinates[bestAt + HullCells.Lanes], coordinates[bestAt + 2 * HullCells.Lanes]);
        return cells.Ids[best];
    }
#endif
}
