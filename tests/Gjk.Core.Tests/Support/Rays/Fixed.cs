namespace Gjk.Core.Tests.Support.Rays;

/// <summary>A number with 640 binary digits behind the point: what the closed forms of rays are judged by. Even the
/// fourth power of 1e-30 keeps two hundred of them, so the naive formulas of a textbook will do.</summary>
internal readonly record struct Fixed(BigInteger Raw)
{
    private const int Digits = 640;

    /// <summary>A hundred digits above the last: what divisions and roots may leave behind.</summary>
    public static readonly Fixed Tiny = new(BigInteger.One << 100);

    public int Sign => Raw.Sign;

    public static implicit operator Fixed(double x) => new(Dyadic.ToInteger(x, -Digits));

    public static explicit operator double(Fixed x) => Dyadic.ToDouble(x.Raw, -Digits);

    public static Fixed operator +(Fixed a, Fixed b) => new(a.Raw + b.Raw);

    public static Fixed operator -(Fixed a, Fixed b) => new(a.Raw - b.Raw);

    public static Fixed operator -(Fixed a) => new(-a.Raw);

    public static Fixed operator *(Fixed a, Fixed b) => new((a.Raw * b.Raw) >> Digits);

    public static Fixed operator /(Fixed a, Fixed b) => new((a.Raw << Digits) / b.Raw);

    public static bool operator <(Fixed a, Fixed b) => a.Raw < b.Raw;

    public static bool operator >(Fixed a, Fixed b) => a.Raw > b.Raw;

    public static bool operator <=(Fixed a, Fixed b) => a.Raw <= b.Raw;

    public static bool operator >=(Fixed a, Fixed b) => a.Raw >= b.Raw;

    public static Fixed Abs(Fixed a) => new(BigInteger.Abs(a.Raw));

    /// <summary>By Newton's iteration in integers, rounded down.</summary>
    public static Fixed Sqrt(Fixed a)
    {
        BigInteger square = a.Raw << Digits;
        if (square.Sign <= 0) return new Fixed(BigInteger.Zero);
        BigInteger root = BigInteger.One << (int)((square.GetBitLength() + 1) / 2 + 1);
        while (true)
        {
            BigInteger next = (root + square / root) >> 1;
            if (next >= root) return new Fixed(root);
            root = next;
        }
    }
}

/// <summary>Three of them.</summary>
internal readonly record struct FixedVector(Fixed X, Fixed Y, Fixed Z)
{
    public Fixed Length => Fixed.Sqrt(Dot(this, this));

    public static implicit operator FixedVector(in Double3 v) => new(v.X, v.Y, v.Z);

    public static implicit operator FixedVector(Vector3 v) => new(v.X, v.Y, v.Z);

    /// <summary>The unit vector of it, rounded to double.</summary>
    public Double3 Unit
    {
        get
        {
            Fixed length = Length;
            return new((double)(X / length), (double)(Y / length), (double)(Z / length));
        }
    }

    public static FixedVector operator +(FixedVector a, FixedVector b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    public static FixedVector operator -(FixedVector a, FixedVector b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static FixedVector operator *(FixedVector a, Fixed s) => new(a.X * s, a.Y * s, a.Z * s);

    public static FixedVector Divide(FixedVector a, FixedVector b) => new(a.X / b.X, a.Y / b.Y, a.Z / b.Z);

    public static Fixed Dot(FixedVector a, FixedVector b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

    public static FixedVector Cross(FixedVector a, FixedVector b) =>
        new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);
}
