#if NET
namespace Gjk.Core;

/// <summary>The furthest vertex of a hull that is scanned as a whole: the lowest of those that tie.</summary>
/// <remarks>Up to 64 vertices, as many as a word has bits: a first pass finds the largest dot product, a second marks
/// the vertices that have it, and the lowest bit is the answer. Neither has a branch that depends on the direction, so
/// the supports of two hulls overlap in the processor, and each is faster than the look-up of a cell, which is a chain
/// of dependent steps. The dot products are those of <see cref="HullBlocks"/>, rounding by rounding; the coordinates
/// are kept as doubles to save the conversions.</remarks>
internal static class HullScan
{
    /// <summary>Count: vertices that fit the marks. Measured by the SupportAlone benchmark.</summary>
    public const int MostVertices = 64;

    /// <summary>Blocks are taken two at a time.</summary>
    private const int Step = 2 * HullCells.BlockFloats;

    private const int MostBlocks = MostVertices / HullCells.Lanes;

    /// <summary>The blocks of <see cref="HullCells"/> as doubles, an even number of them, filled up with the first
    /// vertex, which ties with itself and is lower.</summary>
    public static double[] Widen(float[] coordinates)
    {
        double[] blocks = new double[(coordinates.Length + HullCells.BlockFloats) / Step * Step];
        for (int i = 0; i < blocks.Length; i++)
        {
            int first = i % HullCells.BlockFloats / HullCells.Lanes * HullCells.Lanes;
            blocks[i] = coordinates[i < coordinates.Length ? i : first];
        }

        return blocks;
    }

    /// <summary>The id of the furthest vertex.</summary>
    /// <param name="blocks">From <see cref="Widen"/>.</param>
    /// <param name="x">The direction's components: finite, of safe reach.</param>
    /// <param name="y">As <paramref name="x"/>.</param>
    /// <param name="z">As <paramref name="x"/>.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Best(double[] blocks, double x, double y, double z)
    {
        Debug.Assert(blocks.Length > 0 && blocks.Length % Step == 0);
        Debug.Assert(blocks.Length / HullCells.BlockFloats * HullCells.Lanes <= MostVertices);
        ref double at = ref MemoryMarshal.GetArrayDataReference(blocks);
        Vector256<double> dx = Vector256.Create(x), dy = Vector256.Create(y), dz = Vector256.Create(z);
        Vector256<double> even = Dots(ref at, dx, dy, dz);
        Vector256<double> odd = Dots(ref Unsafe.Add(ref at, HullCells.BlockFloats), dx, dy, dz);
        if (blocks.Length == Step)
        {
            Vector256<double> most = HullBlocks.Highest(HullBlocks.Larger(even, odd));
            uint lanes = HullBlocks.LanesOf(even, most) | HullBlocks.LanesOf(odd, most) << HullCells.Lanes;
            return BitOperations.TrailingZeroCount(lanes) & (2 * HullCells.Lanes - 1);
        }

        Unsafe.SkipInit(out DotProducts dots);
        ref Vector256<double> dot = ref Unsafe.As<DotProducts, Vector256<double>>(ref dots);
        int count = (int)((uint)blocks.Length / HullCells.BlockFloats);
        dot = even;
        Unsafe.Add(ref dot, 1) = odd;
        for (int i = 2; i < count; i += 2)
        {
            at = ref Unsafe.Add(ref at, Step);
            Vector256<double> first = Dots(ref at, dx, dy, dz);
            Vector256<double> second = Dots(ref Unsafe.Add(ref at, HullCells.BlockFloats), dx, dy, dz);
            Unsafe.Add(ref dot, i) = first;
            Unsafe.Add(ref dot, i + 1) = second;
            even = HullBlocks.Larger(even, first);
            odd = HullBlocks.Larger(odd, second);
        }

        Vector256<double> highest = HullBlocks.Highest(HullBlocks.Larger(even, odd));
        ulong marks = 0;
        for (int i = 0; i < count; i += 2)
        {
            ulong pair = HullBlocks.LanesOf(Unsafe.Add(ref dot, i), highest)
                | HullBlocks.LanesOf(Unsafe.Add(ref dot, i + 1), highest) << HullCells.Lanes;
            marks |= pair << (i * HullCells.Lanes);
        }

        // With NaN dot products nothing is marked, and vertex 0 will do.
        return BitOperations.TrailingZeroCount(marks) & (MostVertices - 1);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Dots(
        ref double block, Vector256<double> dx, Vector256<double> dy, Vector256<double> dz) =>
        Vector256.LoadUnsafe(ref block) * dx + Vector256.LoadUnsafe(ref block, HullCells.Lanes) * dy
            + Vector256.LoadUnsafe(ref block, 2 * HullCells.Lanes) * dz;

    [InlineArray(MostBlocks)]
    private struct DotProducts
    {
        private Vector256<double> _first;
    }
}
#endif
