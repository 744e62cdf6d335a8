namespace Gjk.Core;

/// <summary>An unevaluated sum of two doubles, about 106 bits: what double arithmetic loses, kept. Dekker (1971) for
/// the products, Knuth for the sums; the quotient is one Newton step. Relative error per operation below 2^-100 while
/// nothing over- or underflows.</summary>
internal readonly struct DoubleDouble(double high, double low = 0)
{
    /// <summary>2^27 + 1, which splits a double into two halves of 26 bits (Dekker 1971).</summary>
    private const double Splitter = 134217729;

    public readonly double High = high, Low = low;

    public static implicit operator DoubleDouble(double value) => new(value);

    public static explicit operator double(in DoubleDouble value) => value.High + value.Low;

    /// <summary>-1, 0 or 1; 0 for NaN.</summary>
    public int Sign => High > 0 ? 1 : High < 0 ? -1 : Low > 0 ? 1 : Low < 0 ? -1 : 0;

    /// <summary>a + b without error.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static DoubleDouble Sum(double a, double b)
    {
        double s = a + b;
        double t = s - a;
        return new DoubleDouble(s, a - (s - t) + (b - t));
    }

    /// <summary>a * b without error.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static DoubleDouble Product(double a, double b)
    {
        double p = a * b;
        double t = Splitter * a;
        double ah = t - (t - a), al = a - ah;
        t = Splitter * b;
        double bh = t - (t - b), bl = b - bh;
        return new DoubleDouble(p, ah * bh - p + ah * bl + al * bh + al * bl);
    }

    public static DoubleDouble operator +(in DoubleDouble a, in DoubleDouble b)
    {
        DoubleDouble s = Sum(a.High, b.High), t = Sum(a.Low, b.Low);
        DoubleDouble u = Quick(s.High, s.Low + t.High);
        return Quick(u.High, u.Low + t.Low);
    }

    public static DoubleDouble operator -(in DoubleDouble a) => new(-a.High, -a.Low);

    public static DoubleDouble operator -(in DoubleDouble a, in DoubleDouble b) => a + -b;

    public static DoubleDouble operator *(in DoubleDouble a, in DoubleDouble b)
    {
        DoubleDouble p = Product(a.High, b.High);
        return Quick(p.High, p.Low + (a.High * b.Low + a.Low * b.High));
    }

    public static DoubleDouble operator /(in DoubleDouble a, in DoubleDouble b)
    {
        double q = a.High / b.High;
        DoubleDouble rest = a - b * q;
        return Quick(q, rest.High / b.High);
    }

    /// <summary>|a| &gt;= |b| is known.</summary>
    private static DoubleDouble Quick(double a, double b)
    {
        double s = a + b;
        return new DoubleDouble(s, b - (s - a));
    }
}
