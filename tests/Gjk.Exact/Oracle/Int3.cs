namespace Gjk.Exact.Oracle;

/// <summary>A vector of integers of any size.</summary>
public readonly record struct Int3(BigInteger X, BigInteger Y, BigInteger Z)
{
    public bool IsZero => X.IsZero && Y.IsZero && Z.IsZero;

    public static BigInteger Dot(in Int3 a, in Int3 b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

    public static Int3 Cross(in Int3 a, in Int3 b) =>
        new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

    public static Int3 operator +(in Int3 a, in Int3 b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    public static Int3 operator -(in Int3 a, in Int3 b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static Int3 operator -(in Int3 a) => new(-a.X, -a.Y, -a.Z);

    public static Int3 operator *(in Int3 a, BigInteger s) => new(a.X * s, a.Y * s, a.Z * s);

    /// <summary>The direction to double rounding, its largest component between 1 and 2; zero for zero.</summary>
    public Double3 ToDirection()
    {
        int bits = (int)Math.Max(
            BigInteger.Abs(X).GetBitLength(),
            Math.Max(BigInteger.Abs(Y).GetBitLength(), BigInteger.Abs(Z).GetBitLength()));
        return new Double3(Dyadic.ToDouble(X, 1 - bits), Dyadic.ToDouble(Y, 1 - bits), Dyadic.ToDouble(Z, 1 - bits));
    }
}
