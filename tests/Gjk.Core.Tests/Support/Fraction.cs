namespace Gjk.Core.Tests.Support;

/// <summary>A quotient of two integers of any size: what the tests of the arithmetic compute in instead.</summary>
internal readonly record struct Fraction(BigInteger Numerator, BigInteger Denominator)
{
    public int Sign => Numerator.Sign * Denominator.Sign;

    public Fraction Absolute => new(BigInteger.Abs(Numerator), BigInteger.Abs(Denominator));

    public static implicit operator Fraction(double x)
    {
        int exponent = Dyadic.Exponent(x);
        if (exponent == Dyadic.NoExponent) return new Fraction(0, 1);
        BigInteger mantissa = Dyadic.ToInteger(x, exponent);
        return exponent < 0
            ? new Fraction(mantissa, BigInteger.One << -exponent)
            : new Fraction(mantissa << exponent, BigInteger.One);
    }

    public static Fraction operator +(Fraction a, Fraction b) =>
        new(a.Numerator * b.Denominator + b.Numerator * a.Denominator, a.Denominator * b.Denominator);

    public static Fraction operator -(Fraction a, Fraction b) => a + new Fraction(-b.Numerator, b.Denominator);

    public static Fraction operator *(Fraction a, Fraction b) =>
        new(a.Numerator * b.Numerator, a.Denominator * b.Denominator);

    public static Fraction operator /(Fraction a, Fraction b) =>
        new(a.Numerator * b.Denominator, a.Denominator * b.Numerator);

    public static bool operator <=(Fraction a, Fraction b) => (a - b).Sign <= 0;

    public static bool operator >=(Fraction a, Fraction b) => (a - b).Sign >= 0;
}
