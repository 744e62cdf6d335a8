using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>The support function of a box about its centre: corners by the signs of the direction.</summary>
internal static class BoxSupport
{
    /// <summary>The furthest corner.</summary>
    /// <returns>The corner's signs: bit 0, 1, 2 set where x, y, z is at its negative end.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Furthest(in Vector3D half, in Vector3D direction, out Vector3D point)
    {
        double x = direction.X, y = direction.Y, z = direction.Z;
        point = new Vector3D(
            BranchFree.WithSign(half.X, x), BranchFree.WithSign(half.Y, y), BranchFree.WithSign(half.Z, z));
        return BranchFree.IsNegative(x) | (BranchFree.IsNegative(y) << 1) | (BranchFree.IsNegative(z) << 2);
    }

    /// <summary>The corner with the given signs; false when these are none.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool TryGetVertex(in Vector3D half, int signs, out Vector3D point)
    {
        point = new Vector3D(
            BranchFree.NegatedBy(half.X, signs & 1), BranchFree.NegatedBy(half.Y, signs >> 1 & 1),
            BranchFree.NegatedBy(half.Z, signs >> 2 & 1));
        return (uint)signs < 8u;
    }
}
