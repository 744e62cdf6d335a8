namespace Gjk.Core.Tests.Arithmetic;

/// <summary>Sums and products of two doubles are exact, and each operation is as accurate as it says.</summary>
public class DoubleDoubleTests
{
    private const int Tries = 4000;

    /// <summary>The promised relative error of an operation.</summary>
    private static readonly Fraction Accuracy = Math.ScaleB(1, -100);

    [Fact]
    public void SumsOfTwoDoublesAreExact() => ForPairs((a, b) =>
    {
        var sum = DoubleDouble.Sum(a, b);
        Assert.Equal(0, (Value(sum) - (Fraction)a - b).Sign);
        Assert.Equal(a + b, sum.High);
    });

    [Fact]
    public void ProductsOfTwoDoublesAreExact() => ForPairs((a, b) =>
    {
        var product = DoubleDouble.Product(a, b);
        Assert.Equal(0, (Value(product) - (Fraction)a * b).Sign);
        Assert.Equal(a * b, product.High);
    });

    [Fact]
    public void TheFourOperationsKeepAHundredBits()
    {
        var rng = new Rng(3);
        for (int i = 0; i < Budget.Count(Tries); i++)
        {
            DoubleDouble a = Any(rng), b = rng.Below(3) == 0 ? Near(rng, a) : Any(rng);
            AssertNear(Value(a) + Value(b), a + b);
            AssertNear(Value(a) - Value(b), a - b);
            AssertNear(Value(a) * Value(b), a * b);
            AssertNear(Value(a) / Value(b), a / b);
        }
    }

    [Fact]
    public void TheSignIsThatOfTheSum()
    {
        var rng = new Rng(4);
        for (int i = 0; i < Tries; i++)
        {
            DoubleDouble a = Any(rng), difference = a - (rng.Below(3) == 0 ? a : Near(rng, a));
            Assert.Equal(Value(difference).Sign, difference.Sign);
            Assert.Equal(-Value(difference).Sign, (-difference).Sign);
        }

        Assert.Equal(0, new DoubleDouble(double.NaN).Sign);
        Assert.Equal(0, new DoubleDouble(-0.0).Sign);
    }

    private static void AssertNear(Fraction expected, in DoubleDouble actual)
    {
        Fraction error = (Value(actual) - expected).Absolute;
        Assert.True(error <= Accuracy * expected.Absolute, $"{actual.High:R} + {actual.Low:R}");
    }

    private static void ForPairs(Action<double, double> examine)
    {
        double[] special =
            [0, 1, -1, 1.0 / 3, 1 - Math.ScaleB(1, -53), 1 + Math.ScaleB(1, -52), Math.ScaleB(1, 53) - 1];
        foreach (double a in special)
        {
            foreach (double b in special) examine(a, b);
        }

        var rng = new Rng(1);
        for (int i = 0; i < Budget.Count(Tries); i++) examine(Double(rng, 300), Double(rng, 300));
    }

    /// <summary>Of either sign, with a full mantissa.</summary>
    private static double Double(Rng rng, int exponents) =>
        Math.ScaleB((rng.Below(2) == 0 ? 1 : -1) * (1 + rng.Unit()), rng.Below(2 * exponents + 1) - exponents);

    private static DoubleDouble Any(Rng rng)
    {
        double high = Double(rng, 100);
        return DoubleDouble.Sum(high, high * Math.ScaleB(rng.Signed(), -54));
    }

    /// <summary>So near that most digits of a difference cancel.</summary>
    private static DoubleDouble Near(Rng rng, in DoubleDouble a) =>
        DoubleDouble.Sum(a.High, a.Low + a.High * Math.ScaleB(rng.Signed(), -54 - rng.Below(40)));

    private static Fraction Value(in DoubleDouble x) => (Fraction)x.High + x.Low;
}
