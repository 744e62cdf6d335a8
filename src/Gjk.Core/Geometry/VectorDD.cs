namespace Gjk.Core;

/// <summary>A vector of three <see cref="DoubleDouble"/>.</summary>
internal readonly struct VectorDD
{
    public readonly DoubleDouble X, Y, Z;

    public VectorDD(in DoubleDouble x, in DoubleDouble y, in DoubleDouble z)
    {
        X = x;
        Y = y;
        Z = z;
    }

    public static implicit operator VectorDD(in Vector3D v) => new(v.X, v.Y, v.Z);

    public static explicit operator Vector3D(in VectorDD v) => new((double)v.X, (double)v.Y, (double)v.Z);

    public static VectorDD operator +(in VectorDD a, in VectorDD b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    public static VectorDD operator -(in VectorDD a, in VectorDD b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static VectorDD operator *(in VectorDD a, in DoubleDouble s) => new(a.X * s, a.Y * s, a.Z * s);

    public static DoubleDouble Dot(in VectorDD a, in VectorDD b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

    public static VectorDD Cross(in VectorDD a, in VectorDD b) =>
        new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);
}
