namespace Gjk.Core;

/// <summary>The best of a run of blocks: the lowest slot among those whose dot product is largest.</summary>
/// <remarks>The dot product is (x dx + y dy) + z dz, three products and two sums rounded one by one, in every path: a
/// fused multiply-add in one of them would break ties differently. A block is x of four vertices, then y, then z
/// (<see cref="HullCells"/>).</remarks>
internal static class HullBlocks
{
    /// <summary>The dot product of the vertex in a slot.</summary>
    public static double Dot(float[] blocks, int slot, in Double3 direction)
    {
        int x = slot / HullCells.Lanes * HullCells.BlockFloats + slot % HullCells.Lanes;
        double y = blocks[x + HullCells.Lanes], z = blocks[x + 2 * HullCells.Lanes];
        return blocks[x] * direction.X + y * direction.Y + z * direction.Z;
    }

#if NET
    /// <summary>The best of a run of blocks, four vertices at a time.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Best(float[] blocks, int block, int end, in Double3 direction)
    {
        Debug.Assert(block >= 0 && end > block && end * HullCells.BlockFloats <= blocks.Length);
        ref float coordinates = ref MemoryMarshal.GetArrayDataReference(blocks);
        Vector256<double> dx = Vector256.Create(direction.X);
        Vector256<double> dy = Vector256.Create(direction.Y);
        Vector256<double> dz = Vector256.Create(direction.Z);
        Vector256<double> first = Dots(ref coordinates, block, dx, dy, dz);
        if (end - block == 1) return block * HullCells.Lanes + FirstLane(LanesOf(first, Highest(first)));
        if (end - block > 2) return BestOfMany(ref coordinates, block, end, direction.X, direction.Y, direction.Z);

        Vector256<double> second = Dots(ref coordinates, block + 1, dx, dy, dz);
        Vector256<double> highest = Highest(Larger(first, second));
        uint lanes = LanesOf(first, highest) | LanesOf(second, highest) << HullCells.Lanes;
        return block * HullCells.Lanes + FirstLane(lanes);
    }

    /// <summary>Reads the vertex in a slot; gives the slot back.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Read(float[] blocks, int slot, out Double3 point)
    {
        Debug.Assert((uint)slot < (uint)(blocks.Length / HullCells.BlockFloats * HullCells.Lanes));
        ref float coordinates = ref MemoryMarshal.GetArrayDataReference(blocks);
        uint block = (uint)slot / HullCells.Lanes, lane = (uint)slot % HullCells.Lanes;
        ref float x = ref Unsafe.Add(ref coordinates, block * HullCells.BlockFloats + lane);
        Double3.Write(x, Unsafe.Add(ref x, HullCells.Lanes), Unsafe.Add(ref x, 2 * HullCells.Lanes), out point);
        return slot;
    }

    /// <summary>Each lane keeps its first highest; of the lanes that tie for the whole run's highest the lowest slot
    /// wins.</summary>
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

        uint lanes = LanesOf(best, Highest(best));
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
    public static Vector256<double> Highest(Vector256<double> v)
    {
        v = Larger(v, Vector256.Shuffle(v, Vector256.Create(2L, 3, 0, 1)));
        return Larger(v, Vector256.Shuffle(v, Vector256.Create(1L, 0, 3, 2)));
    }

    /// <summary>One bit for each lane with a value.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint LanesOf(Vector256<double> v, Vector256<double> value) =>
        Vector256.Equals(v, value).ExtractMostSignificantBits();

    /// <summary>The larger of two lanes by one instruction; what it does with NaN and with the sign of 0 does not
    /// matter to the comparisons that follow.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<double> Larger(Vector256<double> a, Vector256<double> b) => Vector256.MaxNative(a, b);

    /// <summary>The lowest set bit; with NaN dot products none is set, and lane 0 will do.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int FirstLane(uint lanes) => BitOperations.TrailingZeroCount(lanes) & 7;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Dots(
        ref float coordinates, int block, Vector256<double> dx, Vector256<double> dy, Vector256<double> dz)
    {
        ref float x = ref Unsafe.Add(ref coordinates, block * HullCells.BlockFloats);
        ref float y = ref Unsafe.Add(ref x, HullCells.Lanes), z = ref Unsafe.Add(ref x, 2 * HullCells.Lanes);
        return Widen(ref x) * dx + Widen(ref y) * dy + Widen(ref z) * dz;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Widen(ref float four) =>
        Vector256.WidenLower(Vector128.LoadUnsafe(ref four).ToVector256Unsafe());
#else
    /// <summary>The best of a run of blocks, one vertex at a time.</summary>
    public static unsafe int Best(float[] blocks, int block, int end, in Double3 direction)
    {
        double dx = direction.X, dy = direction.Y, dz = direction.Z, bestDot = double.NegativeInfinity;
        int best = block * HullCells.Lanes;
        fixed (float* first = blocks)
        {
            for (int i = block; i < end; i++)
            {
                float* at = first + i * HullCells.BlockFloats;
                for (int lane = 0; lane < HullCells.Lanes; lane++, at++)
                {
                    double dot = at[0] * dx + at[HullCells.Lanes] * dy + at[2 * HullCells.Lanes] * dz;
                    if (!(dot > bestDot)) continue;
                    bestDot = dot;
                    best = i * HullCells.Lanes + lane;
                }
            }
        }

        return best;
    }

    /// <summary>Reads the vertex in a slot; gives the slot back.</summary>
    public static int Read(float[] blocks, int slot, out Double3 point)
    {
        int x = slot / HullCells.Lanes * HullCells.BlockFloats + slot % HullCells.Lanes;
        Double3.Write(blocks[x], blocks[x + HullCells.Lanes], blocks[x + 2 * HullCells.Lanes], out point);
        return slot;
    }
#endif
}
