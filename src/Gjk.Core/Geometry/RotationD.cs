namespace Gjk.Core;

/// <summary>A rotation matrix in double, from a quaternion that is divided by its own squared length, so that one of
/// floats, a few units in the last place off unit length, still gives a rotation to 1e-16.</summary>
internal struct RotationD
{
    /// <summary>Row and column. A column is followed by a 0, so that it can be read as a register of four
    /// doubles.</summary>
    public double M00, M10, M20, _end0, M01, M11, M21, _end1, M02, M12, M22, _end2;

    public RotationD(in QuaternionD q) => Set(out this, q.X, q.Y, q.Z, q.W, 2 / q.LengthSquared);

    public RotationD(in Quaternion q)
    {
        double x = q.X, y = q.Y, z = q.Z, w = q.W;
        Set(out this, x, y, z, w, 2 / (x * x + y * y + z * z + w * w));
    }

    /// <summary>The matrix of q/|q|: I + s (u uᵀ - u² I) + s w [u]ₓ with s = 2/|q|² (Shoemake 1985), written where it
    /// is to be, without a copy.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Set(out RotationD matrix, double x, double y, double z, double w, double s)
    {
        double xx = x * x, yy = y * y, zz = z * z;
        double xy = x * y * s, xz = x * z * s, yz = y * z * s;
        double wx = w * x * s, wy = w * y * s, wz = w * z * s;
        matrix.M00 = 1 - (yy + zz) * s;
        matrix.M01 = xy - wz;
        matrix.M02 = xz + wy;
        matrix.M10 = xy + wz;
        matrix.M11 = 1 - (xx + zz) * s;
        matrix.M12 = yz - wx;
        matrix.M20 = xz - wy;
        matrix.M21 = yz + wx;
        matrix.M22 = 1 - (xx + yy) * s;
        matrix._end0 = matrix._end1 = matrix._end2 = 0;
    }

#if NET
    /// <summary>The columns, each with a 0 below it.</summary>
    public readonly ref Xyz Column0 => ref Unsafe.As<double, Xyz>(ref Unsafe.AsRef(in M00));

    public readonly ref Xyz Column1 => ref Unsafe.As<double, Xyz>(ref Unsafe.AsRef(in M01));

    public readonly ref Xyz Column2 => ref Unsafe.As<double, Xyz>(ref Unsafe.AsRef(in M02));
#endif

    /// <summary>The inverse.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Transpose(out RotationD t)
    {
        t.M00 = M00;
        t.M10 = M01;
        t.M20 = M02;
        t.M01 = M10;
        t.M11 = M11;
        t.M21 = M12;
        t.M02 = M20;
        t.M12 = M21;
        t.M22 = M22;
        t._end0 = t._end1 = t._end2 = 0;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Double3 Rotate(in Double3 v)
    {
        Rotate(v, out double x, out double y, out double z);
        return new Double3(x, y, z);
    }

    /// <summary>The same in numbers, which Mono keeps in registers where it clears and copies a vector.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Rotate(in Double3 v, out double x, out double y, out double z)
    {
        x = M00 * v.X + M01 * v.Y + M02 * v.Z;
        y = M10 * v.X + M11 * v.Y + M12 * v.Z;
        z = M20 * v.X + M21 * v.Y + M22 * v.Z;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Double3 InverseRotate(in Double3 v)
    {
        InverseRotate(v, out double x, out double y, out double z);
        return new Double3(x, y, z);
    }

    /// <inheritdoc cref="Rotate(in Double3, out double, out double, out double)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void InverseRotate(in Double3 v, out double x, out double y, out double z)
    {
        x = M00 * v.X + M10 * v.Y + M20 * v.Z;
        y = M01 * v.X + M11 * v.Y + M21 * v.Z;
        z = M02 * v.X + M12 * v.Y + M22 * v.Z;
    }
}
