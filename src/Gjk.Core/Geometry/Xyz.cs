#if NET
global using Xyz = System.Runtime.Intrinsics.Vector256<double>;
#else
global using Xyz = Gjk.Core.Double3;
#endif

namespace Gjk.Core;

/// <summary>Three doubles to compute with: a register, whose last lane is unused, where the hardware has such, else a
/// <see cref="Double3"/>. Both give the same bits.</summary>
internal static class XyzExtensions
{
#if NET
    /// <summary>The signs of the first three lanes.</summary>
    public static Xyz SignBits
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Vector256.Create(-0.0, -0.0, -0.0, 0);
    }

    /// <summary>The first three lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double3 ToDouble3(this Xyz v) => new(v.ToScalar(), v.GetElement(1), v.GetElement(2));

    /// <summary>Rounded to float.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Round(this in Xyz v, out Vector3 rounded) =>
        rounded = Vector128.Narrow(v.GetLower(), v.GetUpper()).AsVector3();

    /// <summary>The vector with a 0 behind it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Xyz ToXyz(this in Double3 v) => Vector256.Create(v.X, v.Y, v.Z, 0);

    /// <summary>The first three of four doubles in memory. A last one that no writer has cleared may be a denormal
    /// number, whose products are slow.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Xyz Load(this in Double3 v) =>
        Vector256.LoadUnsafe(in v.X) & Vector256.Create(-1L, -1, -1, 0).AsDouble();

    /// <summary>Writes the three components and one double more.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Store(this in Xyz v, out Double3 to)
    {
        Unsafe.SkipInit(out to);
        v.StoreUnsafe(ref Unsafe.AsRef(in to.X));
    }

    /// <summary>v s.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Times(this in Xyz v, double s, out Xyz product) => product = v * s;

    /// <summary>-v.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Opposite(this in Double3 v, out Xyz opposite) => opposite = (-v).ToXyz();

    /// <summary>v + w s.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Plus(this Xyz v, Xyz w, double s, out Xyz sum) => sum = v + w * s;

    /// <summary>A point of a core and the margin along a unit normal, in the shape's frame and in world
    /// units.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void OnSurface(
        this Xyz onCore, Xyz normal, double margin, in Double3 center, double unit, out Xyz point) =>
        point = (onCore + normal * margin + center.ToXyz()) * unit;

    /// <summary>A point, rotated and translated.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Transform(this in RotationD matrix, Xyz v, in Vector3 position, out Xyz placed) =>
        placed = matrix.Rotate(v) + ((Double3)position).ToXyz();

    /// <summary>The opposite of a rotated vector.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Opposite(this in RotationD matrix, Xyz v, out Xyz opposite) => opposite = -matrix.Rotate(v);

    /// <summary>A point less another one that is rotated and translated.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Subtract(
        this in RotationD matrix, in Xyz from, in Xyz v, in Double3 translation, out Double3 difference) =>
        difference = Vector256.IsHardwareAccelerated
            ? (from - (matrix.Rotate(v) + translation.ToXyz())).ToDouble3()
            : from.ToDouble3() - (matrix.Rotate(v.ToDouble3()) + translation);

    /// <summary>A vector, rotated.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Rotate(this in RotationD matrix, in Double3 v, out Xyz turned) =>
        turned = Vector256.IsHardwareAccelerated
            ? matrix.Column0 * v.X + matrix.Column1 * v.Y + matrix.Column2 * v.Z : matrix.Rotate(v).ToXyz();

    /// <summary><see cref="RotationD.Rotate(in Double3)"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Xyz Rotate(this in RotationD matrix, Xyz v) =>
        !Vector256.IsHardwareAccelerated ? matrix.Rotate(v.ToDouble3()).ToXyz()
            : matrix.Column0 * Spread(v, 0) + matrix.Column1 * Spread(v, 1) + matrix.Column2 * Spread(v, 2);

    /// <summary><see cref="QuaternionD.Rotate"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Xyz Rotate(this in QuaternionD q, Xyz v)
    {
        Xyz u = Vector256.LoadUnsafe(in q.X);
        return v + Cross(u, Cross(u, v) + v * Spread(u, 3)) * 2;
    }

    /// <summary>One lane in all. Where there are no such registers, a shuffle is a loop.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Xyz Spread(Xyz v, int lane) =>
        Vector256.IsHardwareAccelerated
            ? Vector256.Shuffle(v, Vector256.Create((long)lane)) : Vector256.Create(v.GetElement(lane));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Xyz Cross(Xyz a, Xyz b)
    {
        if (!Vector256.IsHardwareAccelerated) return Double3.Cross(a.ToDouble3(), b.ToDouble3()).ToXyz();
        Vector256<long> yzx = Vector256.Create(1L, 2, 0, 3), zxy = Vector256.Create(2L, 0, 1, 3);
        return Vector256.Shuffle(a, yzx) * Vector256.Shuffle(b, zxy)
            - Vector256.Shuffle(a, zxy) * Vector256.Shuffle(b, yzx);
    }
#else
    public static Double3 ToDouble3(this Double3 v) => v;

    public static void Round(this in Double3 v, out Vector3 rounded)
    {
        rounded.X = (float)v.X;
        rounded.Y = (float)v.Y;
        rounded.Z = (float)v.Z;
    }

    public static ref readonly Double3 ToXyz(this in Double3 v) => ref v;

    public static ref readonly Double3 Load(this in Double3 v) => ref v;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Store(this in Double3 v, out Double3 to) => Double3.Write(v.X, v.Y, v.Z, out to);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Times(this in Double3 v, double s, out Double3 product) =>
        Double3.Write(v.X * s, v.Y * s, v.Z * s, out product);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Opposite(this in Double3 v, out Double3 opposite) =>
        Double3.Write(-v.X, -v.Y, -v.Z, out opposite);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Rotate(this in RotationD matrix, in Double3 v, out Double3 turned)
    {
        matrix.Rotate(v, out double x, out double y, out double z);
        Double3.Write(x, y, z, out turned);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Subtract(
        this in RotationD matrix, in Double3 from, in Double3 v, in Double3 translation, out Double3 difference)
    {
        matrix.Rotate(v, out double x, out double y, out double z);
        Double3.Write(
            from.X - (x + translation.X), from.Y - (y + translation.Y), from.Z - (z + translation.Z), out difference);
    }

    public static void OnSurface(
        this in Double3 onCore, in Double3 normal, double margin, in Double3 center, double unit, out Double3 point) =>
        Double3.Write(
            (onCore.X + normal.X * margin + center.X) * unit, (onCore.Y + normal.Y * margin + center.Y) * unit,
            (onCore.Z + normal.Z * margin + center.Z) * unit, out point);

    public static void Transform(this in RotationD matrix, in Double3 v, in Vector3 position, out Double3 placed)
    {
        matrix.Rotate(v, out double x, out double y, out double z);
        Double3.Write(x + position.X, y + position.Y, z + position.Z, out placed);
    }

    public static void Opposite(this in RotationD matrix, in Double3 v, out Double3 opposite)
    {
        matrix.Rotate(v, out double x, out double y, out double z);
        Double3.Write(-x, -y, -z, out opposite);
    }
#endif

    /// <summary>v + w s, in one step: Mono clears and copies what a step makes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Plus(this in Double3 v, in Double3 w, double s, out Double3 sum) =>
        Double3.Write(v.X + w.X * s, v.Y + w.Y * s, v.Z + w.Z * s, out sum);
}
