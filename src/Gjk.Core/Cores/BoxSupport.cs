namespace Gjk.Core;

/// <summary>The support function of a box about its centre: corners by the signs of the direction.</summary>
internal static class BoxSupport
{
    /// <summary>The furthest corner.</summary>
    /// <returns>The corner's signs: bit 0, 1, 2 set where x, y, z is at its negative end.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Furthest(in Double3 half, in Double3 direction, out Double3 point)
    {
        double x = direction.X, y = direction.Y, z = direction.Z;
        Double3.Write(
            BranchFree.WithSign(half.X, x), BranchFree.WithSign(half.Y, y), BranchFree.WithSign(half.Z, z), out point);
        return BranchFree.IsNegative(x) | (BranchFree.IsNegative(y) << 1) | (BranchFree.IsNegative(z) << 2);
    }

    /// <summary>The corner with the given signs; false when these are none.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool TryGetVertex(in Double3 half, int signs, out Double3 point)
    {
        Double3.Write(
            BranchFree.NegatedBy(half.X, signs & 1), BranchFree.NegatedBy(half.Y, signs >> 1 & 1),
            BranchFree.NegatedBy(half.Z, signs >> 2 & 1), out point);
        return (uint)signs < 8u;
    }

    /// <summary>A box's face, its corners by their signs as in <see cref="TryGetVertex"/>.</summary>
    public static void Face(in Double3 half, in Double3 direction, ref FaceCorners corners)
    {
        Double3 seen = corners.AlongAxes(direction);
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

    private static double HalfOf(in Double3 half, int bit) => bit == 1 ? half.X : bit == 2 ? half.Y : half.Z;

    private static void AddBoxCorner(in Double3 half, int signs, ref FaceCorners corners)
    {
        TryGetVertex(half, signs, out Double3 point);
        corners.Add(point, signs);
    }
}
