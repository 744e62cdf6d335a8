namespace Gjk.Core;

/// <summary>Places along the Morton curve, 10 bits per axis: what is near on it is near in space (Lauterbach et al.
/// 2009, "Fast BVH construction on GPUs").</summary>
internal static class MortonCurve
{
    /// <summary>Bits per axis.</summary>
    public const int BitsPerAxis = 10;

    /// <summary>Cells per axis.</summary>
    private const int Cells = 1 << BitsPerAxis;

    /// <summary>The cell of a point, in a world that begins at a corner, with so many cells per unit; in double, where
    /// no difference of floats overflows.</summary>
    public static uint Cell(in Double3 point, in Double3 corner, in Double3 cellsPerUnit)
    {
        Double3 cell = Double3.Multiply(point - corner, cellsPerUnit);
        return Spread(Clamped(cell.X)) << 2 | Spread(Clamped(cell.Y)) << 1 | Spread(Clamped(cell.Z));
    }

    /// <summary>Cells per unit of a side; 0 where it has no length.</summary>
    public static double PerUnit(double side) => side > 0 ? Cells / side : 0;

    /// <summary>Where the highest bit in which the ends differ changes; the middle of a range of one cell. The keys are
    /// sorted, the cell in the upper half.</summary>
    public static int Split(ulong[] curve, int begin, int end)
    {
        uint first = (uint)(curve[begin] >> 32), last = (uint)(curve[end - 1] >> 32);
        if (first == last) return begin + (end - begin) / 2;
        uint bit = 1;
        for (uint rest = (first ^ last) >> 1; rest != 0; rest >>= 1) bit <<= 1;
        int low = begin, high = end - 1;
        while (high - low > 1)
        {
            int middle = low + (high - low) / 2;
            if (((uint)(curve[middle] >> 32) & bit) == 0) low = middle;
            else high = middle;
        }

        return high;
    }

    private static uint Clamped(double cell) => cell > 0 ? (cell < Cells ? (uint)cell : Cells - 1) : 0;

    /// <summary>Two zero bits after each of ten bits.</summary>
    private static uint Spread(uint x)
    {
        x = (x | x << 16) & 0x030000FF;
        x = (x | x << 8) & 0x0300F00F;
        x = (x | x << 4) & 0x030C30C3;
        return (x | x << 2) & 0x09249249;
    }
}
