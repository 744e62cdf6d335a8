namespace Gjk.Core;

/// <summary>The rotations of a pair: A's in the world, B's seen from A, and back.</summary>
internal static class PoseComposition
{
    /// <param name="poseA">A's pose.</param>
    /// <param name="poseB">B's pose.</param>
    /// <param name="placedA">Where A's core is turned inside the pose; else null.</param>
    /// <param name="placedB">The same for B's core.</param>
    /// <param name="rotationA">From A's axes to the world's.</param>
    /// <param name="rotation">From B's axes to A's.</param>
    /// <param name="inverse">From A's axes to B's.</param>
    /// <param name="areRotations">Whether both quaternions are of unit length.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Compose(
        in RigidPose poseA, in RigidPose poseB, Placement? placedA, Placement? placedB, out RotationD rotationA,
        out RotationD rotation, out RotationD inverse, out bool areRotations)
    {
#if NET
        if (Avx2.IsSupported)
        {
            ComposeLanes(poseA, poseB, placedA, placedB, out rotationA, out rotation, out inverse, out areRotations);
            return;
        }
#endif
        QuaternionD.Widen(poseA.Rotation, out QuaternionD qa);
        QuaternionD.Widen(poseB.Rotation, out QuaternionD qb);
        double normA = qa.LengthSquared, normB = qb.LengthSquared, one = 1 / (normA * normB);
        if (placedA is not null || placedB is not null)
        {
            ToCore(ref qa, placedA);
            ToCore(ref qb, placedB);
        }

        double ax = qa.X, ay = qa.Y, az = qa.Z, aw = qa.W, bx = qb.X, by = qb.Y, bz = qb.Z, bw = qb.W;
        RotationD.Set(out rotationA, ax, ay, az, aw, 2 * normB * one);
        RotationD.Set(
            out rotation,
            aw * bx - ax * bw - ay * bz + az * by,
            aw * by - ay * bw - az * bx + ax * bz,
            aw * bz - az * bw - ax * by + ay * bx,
            aw * bw + ax * bx + ay * by + az * bz,
            2 * one);
        rotation.Transpose(out inverse);
        areRotations = RigidPose.IsUnit(normA) && RigidPose.IsUnit(normB);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void ToCore(ref QuaternionD q, Placement? placed) => q *= (placed ?? Placement.None).UnitRotation;

#if NET
    /// <summary>The lanes of a quaternion in the orders that its products need.</summary>
    private const byte Yzx = 0b11_00_10_01, Zxy = 0b11_01_00_10, AllW = 0b11_11_11_11;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void ComposeLanes(
        in RigidPose poseA, in RigidPose poseB, Placement? placedA, Placement? placedB, out RotationD rotationA,
        out RotationD rotation, out RotationD inverse, out bool areRotations)
    {
        Vector256<double> a = Lanes(poseA), b = Lanes(poseB);
        Vector128<double> norms = NormsOf(a, b);
        if (placedA is not null || placedB is not null) (a, b) = (ToCore(a, placedA), ToCore(b, placedB));
        double normA = norms.ToScalar(), normB = norms.GetElement(1), one = 1 / (normA * normB);
        Vector256<double> q = ConjugateTimes(a, b);
        Diagonals(
            a, Avx2.Permute4x64(a, AllW), 2 * normB * one, out Vector256<double> main, out Vector256<double> below,
            out Vector256<double> above);
        Unsafe.SkipInit(out rotationA);
        SetColumns(ref rotationA, main, below, above);
        Diagonals(q, Avx2.Permute4x64(q, AllW), 2 * one, out main, out below, out above);
        Unsafe.SkipInit(out rotation);
        SetColumns(ref rotation, main, below, above);
        Unsafe.SkipInit(out inverse);
        SetColumns(ref inverse, main, above, below);
        areRotations = RigidPose.IsUnit(normA) & RigidPose.IsUnit(normB);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Lanes(in RigidPose pose) =>
        Avx.ConvertToVector256Double(Vector128.LoadUnsafe(in pose.Rotation.X));

    /// <summary>The rotation of a core that is turned inside its pose.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static Vector256<double> ToCore(Vector256<double> q, Placement? placed) =>
        ConjugateTimes(q ^ XyzExtensions.SignBits, Vector256.LoadUnsafe(in (placed ?? Placement.None).UnitRotation.X));

    /// <summary>The squared lengths, ((x² + y²) + z²) + w².</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<double> NormsOf(Vector256<double> a, Vector256<double> b)
    {
        Vector256<double> aa = a * a, bb = b * b;
        Vector256<double> even = Avx.UnpackLow(aa, bb), odd = Avx.UnpackHigh(aa, bb);
        return even.GetLower() + odd.GetLower() + even.GetUpper() + odd.GetUpper();
    }

    /// <summary>The product of A's conjugate and B.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> ConjugateTimes(Vector256<double> a, Vector256<double> b) =>
        Avx2.Permute4x64(a, AllW) * b
            + (Avx2.Permute4x64(a, 0b00_10_01_00) ^ XyzExtensions.SignBits) * Avx2.Permute4x64(b, 0b00_11_11_11)
            + (Avx2.Permute4x64(a, 0b01_00_10_01) ^ XyzExtensions.SignBits) * Avx2.Permute4x64(b, 0b01_01_00_10)
            + Avx2.Permute4x64(a, 0b10_01_00_10) * Avx2.Permute4x64(b, 0b10_00_10_01);

    /// <summary>A rotation matrix by its diagonals (00 11 22), (10 21 02) and (01 12 20), which is how it comes out of
    /// the cyclic products of a quaternion; as <see cref="RotationD.Set"/>, product by product.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Diagonals(
        Vector256<double> q, Vector256<double> w, double scale, out Vector256<double> main,
        out Vector256<double> below, out Vector256<double> above)
    {
        Vector256<double> yzx = Avx2.Permute4x64(q, Yzx), zxy = Avx2.Permute4x64(q, Zxy);
        Vector256<double> s = Vector256.Create(scale, scale, scale, 0);
        main = Vector256<double>.One - (yzx * yzx + zxy * zxy) * s;
        Vector256<double> symmetric = q * yzx * s, skew = w * zxy * s;
        below = symmetric + skew;
        above = symmetric - skew;
    }

    /// <summary>The columns (00 10 20), (01 11 21) and (02 12 22) of the diagonals, whose last lanes are 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void SetColumns(
        ref RotationD matrix, Vector256<double> main, Vector256<double> below, Vector256<double> above)
    {
        Vector256<double> moved = Avx2.Permute4x64(below, 0b11_01_10_10);
        matrix.Column0 = Avx.Blend(Avx.UnpackLow(main, below), above, 0b1100);
        matrix.Column1 = Avx.Blend(Avx.Blend(above, main, 0b0010), moved, 0b0100);
        matrix.Column2 = Avx.Blend(Avx.Blend(above, main, 0b0100), moved, 0b0001);
    }
#endif
}
