#if NET
global using Xyz = System.Runtime.Intrinsics.Vector256<double>;
#else
global using Xyz = Gjk.Core.Double3;
#endif

namespace Gjk.Core;

/// <summary>Three doubles to compute with: a register whose last lane is nobody's where there are such, or a
/// <see cref="Double3"/>. What is written with either has the same bits.</summary>
internal static class XyzExtensions
{
#if NET
    /// <summary>The first three lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double3 ToDouble3(this Xyz v) => new(v.ToScalar(), v.GetElement(1), v.GetElement(2));

    /// <summary>Rounded to float.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Round(this in Xyz v, out Vector3 rounded) => rounded = v.ToSingle();

    /// <summary>Rounded to float, as a value.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 ToSingle(this Xyz v) => Vector128.Narrow(v.GetLower(), v.GetUpper()).AsVector3();

    /// <summary>The vector with a 0 behind it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Xyz ToXyz(this in Double3 v) => Vector256.Create(v.X, v.Y, v.Z, 0);

    /// <summary>The magnitudes of the components.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Xyz Abs(this Xyz v) => Vector256.Abs(v);

    /// <summary>The products of the components.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Xyz Times(this Xyz v, Xyz w) => v * w;

    /// <summary>Writes the components, and one double more.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void StoreAt(this Xyz v, double* to) => Vector256.Store(v, to);

    /// <summary>v + w s, in one step: Mono clears and copies what a step makes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Plus(this Xyz v, Xyz w, double s, out Xyz sum) => sum = v + w * s;

    /// <summary>A point of a core and the margin along a unit normal, in the shape's frame and in world
    /// units.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void OnSurface(
        this Xyz onCore, Xyz normal, double margin, in Double3 center, double unit, out Xyz point) =>
        point = (onCore + normal * margin + center.ToXyz()) * unit;

    /// <summary>A vector turned, and what is added to it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Place(this in RotationD matrix, Xyz v, in Vector3 position, out Xyz placed) =>
        placed = matrix.Rotate(v) + ((Double3)position).ToXyz();

    /// <summary>A vector turned, and reversed.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Opposite(this in RotationD matrix, Xyz v, out Xyz opposite) => opposite = -matrix.Rotate(v);

    /// <summary><see cref="RotationD.Rotate(in Double3)"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Xyz Rotate(this in RotationD matrix, Xyz v) =>
        matrix.Column0 * Vector256.Shuffle(v, Vector256.Create(0L))
            + matrix.Column1 * Vector256.Shuffle(v, Vector256.Create(1L))
            + matrix.Column2 * Vector256.Shuffle(v, Vector256.Create(2L));

    /// <summary><see cref="QuaternionD.Rotate"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Xyz Rotate(this in QuaternionD q, Xyz v)
    {
        Xyz u = Vector256.LoadUnsafe(in q.X);
        return v + Cross(u, Cross(u, v) + v * Vector256.Shuffle(u, Vector256.Create(3L))) * 2;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Xyz Cross(Xyz a, Xyz b)
    {
        Vector256<long> yzx = Vector256.Create(1L, 2, 0, 3), zxy = Vector256.Create(2L, 0, 1, 3);
        return Vector256.Shuffle(a, yzx) * Vector256.Shuffle(b, zxy)
            - Vector256.Shuffle(a, zxy) * Vector256.Shuffle(b, yzx);
    }
#else
    public static Double3 ToDouble3(this Double3 v) => v;

    public static Vector3 ToSingle(this in Double3 v) => (Vector3)v;

    public static void Round(this in Double3 v, out Vector3 rounded)
    {
        rounded.X = (float)v.X;
        rounded.Y = (float)v.Y;
        rounded.Z = (float)v.Z;
    }

    public static Double3 ToXyz(this in Double3 v) => v;

    public static void Plus(this in Double3 v, in Double3 w, double s, out Double3 sum) =>
        Double3.Write(v.X + w.X * s, v.Y + w.Y * s, v.Z + w.Z * s, out sum);

    public static void OnSurface(
        this in Double3 onCore, in Double3 normal, double margin, in Double3 center, double unit, out Double3 point) =>
        Double3.Write(
            (onCore.X + normal.X * margin + center.X) * unit, (onCore.Y + normal.Y * margin + center.Y) * unit,
            (onCore.Z + normal.Z * margin + center.Z) * unit, out point);

    public static void Place(this in RotationD matrix, in Double3 v, in Vector3 position, out Double3 placed)
    {
        matrix.Rotate(v, out double x, out double y, out double z);
        Double3.Write(x + position.X, y + position.Y, z + position.Z, out placed);
    }

    public static void Opposite(this in RotationD matrix, in Double3 v, out Double3 opposite)
    {
        matrix.Rotate(v, out double x, out double y, out double z);
        Double3.Write(-x, -y, -z, out opposite);
    }

    public static Double3 Abs(this in Double3 v) =>
        new(System.Math.Abs(v.X), System.Math.Abs(v.Y), System.Math.Abs(v.Z));

    public static Double3 Times(this in Double3 v, in Double3 w) => new(v.X * w.X, v.Y * w.Y, v.Z * w.Z);

    public static unsafe void StoreAt(this in Double3 v, double* to) => (to[0], to[1], to[2]) = (v.X, v.Y, v.Z);
#endif
}
