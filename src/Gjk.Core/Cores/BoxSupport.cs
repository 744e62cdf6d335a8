namespace Gjk.Core;

/// <summary>The support function of a box about its centre: corners by the signs of the direction.</summary>
internal static unsafe class BoxSupport
{
    /// <summary>The furthest corner.</summary>
    /// <returns>The corner's signs: bit 0, 1, 2 set where x, y, z is at its negative end.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Furthest(in Double3 half, in Double3 direction, out Double3 point)
    {
        int signs = Signs(direction);
        TryGetVertex(half, signs, out point);
        return signs;
    }

    /// <summary>Bit 0, 1, 2 set where x, y, z is negative; a zero of either sign is not. Reads the signs as integers:
    /// a branch would be mispredicted.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Signs(in Double3 direction)
    {
        fixed (Double3* at = &direction)
        {
            var bits = (Bits*)at;
            return Sign(bits->X) | Sign(bits->Y) << 1 | Sign(bits->Z) << 2;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Sign(long bits) => (int)((ulong)(bits & (bits << 1 | -(bits << 1))) >> 63);

    /// <summary>The corner with the given signs; false when these are none.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool TryGetVertex(in Double3 half, int signs, out Double3 point)
    {
        fixed (Double3* at = &half, to = &point)
        {
            Bits* from = (Bits*)at, bits = (Bits*)to;
            bits->X = from->X ^ (long)signs << 63;
            bits->Y = from->Y ^ (long)signs >> 1 << 63;
            bits->Z = from->Z ^ (long)signs >> 2 << 63;
        }

        return (uint)signs < 8u;
    }

    /// <summary>A box's face, its corners by their signs as in <see cref="TryGetVertex"/>.</summary>
    public static void Face(in Double3 half, in Double3 direction, ref FaceCorners corners)
    {
        Double3 seen = corners.OuterCosines(direction);
        double x = Math.Abs(seen.X), y = Math.Abs(seen.Y), z = Math.Abs(seen.Z);
        int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
        double along = axis == 0 ? seen.X : axis == 1 ? seen.Y : seen.Z;
        int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
        int first = along < 0 ? 1 << axis : 0;
        bool hasU = HalfOf(half, u) > 0, hasV = HalfOf(half, v) > 0;
        AddBoxCorner(half, first, ref corners);
        if (hasU) AddBoxCorner(half, first | u, ref corners);
        if (hasU && hasV) AddBoxCorner(half, first | u | v, ref corners);
        if (hasV) AddBoxCorner(half, first | v, ref corners);
    }

    /// <summary>The bits of a vector's numbers. By name, since Mono computes the address of a third number.</summary>
    private struct Bits
    {
        public long X, Y, Z;
    }

    private static double HalfOf(in Double3 half, int bit) => bit == 1 ? half.X : bit == 2 ? half.Y : half.Z;

    private static void AddBoxCorner(in Double3 half, int signs, ref FaceCorners corners)
    {
        TryGetVertex(half, signs, out Double3 point);
        corners.Add(point, signs);
    }
}
