#if NET
using Lanes = System.Runtime.Intrinsics.Vector256<double>;

namespace Gjk.Core;

/// <summary>A vector of each of four pairs, one pair per lane. Every operation is that of <see cref="Double3"/>,
/// product by product and sum by sum, so a lane has the bits that its pair would have alone.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct WideVector(Lanes x, Lanes y, Lanes z)
{
    public readonly Lanes X = x, Y = y, Z = z;

    public Lanes LengthSquared
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => X * X + Y * Y + Z * Z;
    }

    /// <inheritdoc cref="Double3.SumOfMagnitudes"/>
    public Lanes SumOfMagnitudes
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Vector256.Abs(X) + Vector256.Abs(Y) + Vector256.Abs(Z);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes Dot(in WideVector a, in WideVector b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideVector Cross(in WideVector a, in WideVector b) =>
        new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

    /// <summary>a in the lanes of the mask, b in the others.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideVector Select(Lanes mask, in WideVector a, in WideVector b) => new(
        Vector256.ConditionalSelect(mask, a.X, b.X), Vector256.ConditionalSelect(mask, a.Y, b.Y),
        Vector256.ConditionalSelect(mask, a.Z, b.Z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideVector operator +(in WideVector a, in WideVector b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideVector operator -(in WideVector a, in WideVector b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideVector operator -(in WideVector a) => new(-a.X, -a.Y, -a.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideVector operator *(in WideVector a, Lanes s) => new(a.X * s, a.Y * s, a.Z * s);

    /// <summary>Four vectors, each a register of x, y, z and a 0, as one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideVector Transpose(Lanes a, Lanes b, Lanes c, Lanes d)
    {
        Lanes xzAB = Avx.UnpackLow(a, b), yAB = Avx.UnpackHigh(a, b);
        Lanes xzCD = Avx.UnpackLow(c, d), yCD = Avx.UnpackHigh(c, d);
        return new WideVector(
            Avx.Permute2x128(xzAB, xzCD, 0x20), Avx.Permute2x128(yAB, yCD, 0x20), Avx.Permute2x128(xzAB, xzCD, 0x31));
    }

    /// <summary>Four vectors, one in each lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideVector Of(in Double3 a, in Double3 b, in Double3 c, in Double3 d) => new(
        Vector256.Create(a.X, b.X, c.X, d.X), Vector256.Create(a.Y, b.Y, c.Y, d.Y),
        Vector256.Create(a.Z, b.Z, c.Z, d.Z));

    /// <summary>The vector of one lane.</summary>
    public Double3 this[int lane] => new(X.GetElement(lane), Y.GetElement(lane), Z.GetElement(lane));
}

/// <summary>A rotation matrix of each of four pairs.</summary>
internal struct WideRotation
{
    public Lanes M00, M01, M02, M10, M11, M12, M20, M21, M22;

    /// <inheritdoc cref="RotationD.Set"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Set(Lanes x, Lanes y, Lanes z, Lanes w, Lanes s)
    {
        Lanes one = Lanes.One, xx = x * x, yy = y * y, zz = z * z;
        Lanes xy = x * y * s, xz = x * z * s, yz = y * z * s;
        Lanes wx = w * x * s, wy = w * y * s, wz = w * z * s;
        M00 = one - (yy + zz) * s;
        M01 = xy - wz;
        M02 = xz + wy;
        M10 = xy + wz;
        M11 = one - (xx + zz) * s;
        M12 = yz - wx;
        M20 = xz - wy;
        M21 = yz + wx;
        M22 = one - (xx + yy) * s;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly WideVector Rotate(in WideVector v) => new(
        M00 * v.X + M01 * v.Y + M02 * v.Z,
        M10 * v.X + M11 * v.Y + M12 * v.Z,
        M20 * v.X + M21 * v.Y + M22 * v.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly WideVector InverseRotate(in WideVector v) => new(
        M00 * v.X + M10 * v.Y + M20 * v.Z,
        M01 * v.X + M11 * v.Y + M21 * v.Z,
        M02 * v.X + M12 * v.Y + M22 * v.Z);
}
#endif
