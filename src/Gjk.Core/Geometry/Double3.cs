using System.Globalization;

namespace Gjk.Core;

/// <summary>A vector of three doubles. The library's inputs and outputs are <see cref="Vector3"/>; directions and
/// support points are doubles, because a support taken in a rounded direction can be the wrong vertex.</summary>
/// <remarks>Immutable. No method throws; NaN and infinities pass through as IEEE 754 has it.</remarks>
public readonly struct Double3 : IEquatable<Double3>
{
    /// <summary>A pure number: a component that is smaller than this share of the largest is what rounding to double
    /// leaves. Pinned by TextTests.</summary>
    private const double RoundingNoise = 1e-14;

    /// <summary>The x component.</summary>
    public readonly double X;

    /// <summary>The y component.</summary>
    public readonly double Y;

    /// <summary>The z component.</summary>
    public readonly double Z;

    /// <summary>Makes a vector from its components.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Double3(double x, double y, double z)
    {
        X = x;
        Y = y;
        Z = z;
    }

    /// <summary>The squared length, in units squared.</summary>
    public double LengthSquared
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => X * X + Y * Y + Z * Z;
    }

    /// <summary>The largest of the components' magnitudes, in their units.</summary>
    internal double LargestMagnitude
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Math.Max(Math.Max(Math.Abs(X), Math.Abs(Y)), Math.Abs(Z));
    }

    /// <summary>The sum of the components' magnitudes, in their units.</summary>
    internal double SumOfMagnitudes
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Math.Abs(X) + Math.Abs(Y) + Math.Abs(Z);
    }

    /// <summary>The length, in the units of the components.</summary>
    public double Length => Math.Sqrt(LengthSquared);

    /// <summary>True when no component is NaN or infinite.</summary>
    public bool IsFinite => X - X + (Y - Y) + (Z - Z) == 0;

    /// <summary>The dot product a · b.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Dot(in Double3 a, in Double3 b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

    /// <summary>The cross product a × b (right-handed).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double3 Cross(in Double3 a, in Double3 b) =>
        new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

    /// <summary>Component-wise product.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double3 Multiply(in Double3 a, in Double3 b) => new(a.X * b.X, a.Y * b.Y, a.Z * b.Z);

    /// <summary>Writes a vector in place. Mono's constructor call would clear a temporary vector and copy it, and the
    /// next step would wait for the copy.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static unsafe void Write(double x, double y, double z, out Double3 v)
    {
#if NET
        v = new Double3(x, y, z);
#else
        fixed (Double3* same = &v)
        {
            var to = (Fields*)same;
            to->X = x;
            to->Y = y;
            to->Z = z;
        }
#endif
    }

#if !NET
    /// <summary>The fields of a vector, to be written: Mono computes the address of an array's third number.</summary>
    private struct Fields
    {
        public double X, Y, Z;
    }
#endif

    /// <summary>The normal of a triangle, (q - p) × (r - p).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void Normal(in Double3 p, in Double3 q, in Double3 r, out Double3 normal)
    {
        double ex = q.X - p.X, ey = q.Y - p.Y, ez = q.Z - p.Z, fx = r.X - p.X, fy = r.Y - p.Y, fz = r.Z - p.Z;
        Write(ey * fz - ez * fy, ez * fx - ex * fz, ex * fy - ey * fx, out normal);
    }

    /// <summary>The product of the cross product of a and b with c.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static double Triple(in Double3 a, in Double3 b, in Double3 c) =>
        (a.Y * b.Z - a.Z * b.Y) * c.X + (a.Z * b.X - a.X * b.Z) * c.Y + (a.X * b.Y - a.Y * b.X) * c.Z;

    /// <summary>Sum.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double3 operator +(in Double3 a, in Double3 b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    /// <summary>From one position to another.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void Between(in Vector3 from, in Vector3 to, out Double3 way) =>
        Write((double)to.X - from.X, (double)to.Y - from.Y, (double)to.Z - from.Z, out way);

    /// <summary>Difference.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double3 operator -(in Double3 a, in Double3 b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    /// <summary>The opposite vector.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double3 operator -(in Double3 a) => new(-a.X, -a.Y, -a.Z);

    /// <summary>Product with a number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double3 operator *(in Double3 a, double s) => new(a.X * s, a.Y * s, a.Z * s);

    /// <summary>Product with a number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double3 operator *(double s, in Double3 a) => new(a.X * s, a.Y * s, a.Z * s);

    /// <summary>Every float is a double, so this widening is exact.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator Double3(Vector3 v) => new(v.X, v.Y, v.Z);

    /// <summary>Rounds each component to the nearest float.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator Vector3(in Double3 v)
    {
        // Mono calls the constructor.
        Vector3 rounded;
        rounded.X = (float)v.X;
        rounded.Y = (float)v.Y;
        rounded.Z = (float)v.Z;
        return rounded;
    }

    /// <summary>Component-wise equality.</summary>
    public static bool operator ==(in Double3 a, in Double3 b) => a.X == b.X && a.Y == b.Y && a.Z == b.Z;

    /// <summary>Component-wise inequality.</summary>
    public static bool operator !=(in Double3 a, in Double3 b) => !(a == b);

    /// <inheritdoc/>
    public bool Equals(Double3 other) => X.Equals(other.X) && Y.Equals(other.Y) && Z.Equals(other.Z);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is Double3 other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => (X.GetHashCode() * 397 ^ Y.GetHashCode()) * 397 ^ Z.GetHashCode();

    /// <summary>The components in invariant culture, as many digits as a reader needs to get the same doubles
    /// back.</summary>
    public override string ToString() => $"<{Text(X, "R")}, {Text(Y, "R")}, {Text(Z, "R")}>";

    /// <summary>The components for people: nine digits, and 0 for a component that is only rounding beside the
    /// largest.</summary>
    internal string ToText()
    {
        double noise = RoundingNoise * LargestMagnitude;
        return $"<{Text(Clean(X, noise), "G9")}, {Text(Clean(Y, noise), "G9")}, {Text(Clean(Z, noise), "G9")}>";
    }

    private static double Clean(double x, double noise) => Math.Abs(x) <= noise ? 0 : x;

    private static string Text(double x, string format) => x.ToString(format, CultureInfo.InvariantCulture);
}
