namespace Gjk.Core;

/// <summary>A running sum of doubles without rounding, and its sign: the arithmetic behind the predicates of the
/// hull.</summary>
/// <remarks>
/// Source: J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997
/// (two-sum, two-product, Grow-Expansion with zeros left out). The parts are kept by increasing magnitude and do not
/// overlap, so the last one has the sign of the whole.
///
/// Range: every term here is a product of at most three floats or exact differences of floats. A float is a multiple of
/// 2^-149 below 2^128, so each term and each rounding error of one is a multiple of 2^-447 below 2^400: nothing
/// underflows and nothing overflows in double, and denormal or huge inputs need no scaling. Not thread-safe: one per
/// build.
/// </remarks>
/// <param name="mostParts">How many numbers are added at most; 24 products of three floats have two parts each.</param>
internal sealed class ExactSum(int mostParts = 48)
{
    private readonly double[] _parts = new double[mostParts];
    private int _count;

    /// <summary>-1, 0 or 1.</summary>
    public int Sign => _count == 0 ? 0 : Math.Sign(_parts[_count - 1]);

    public void Clear() => _count = 0;

    public void Add(double x)
    {
        double[] parts = _parts;
        int kept = 0;
        for (int i = 0; i < _count; i++)
        {
            DoubleDouble sum = DoubleDouble.Sum(x, parts[i]);
            if (sum.Low != 0) parts[kept++] = sum.Low;
            x = sum.High;
        }

        if (x != 0) parts[kept++] = x;
        _count = kept;
    }

    /// <summary>Adds a b c, in which a b and each of its two parts times c must be in the range of double.</summary>
    public void AddProduct(double a, double b, double c)
    {
        DoubleDouble product = DoubleDouble.Product(a, b);
        if (product.High == 0 || c == 0) return;
        if (product.Low != 0) AddProduct(product.Low, c);
        AddProduct(product.High, c);
    }

    private void AddProduct(double a, double b)
    {
        DoubleDouble product = DoubleDouble.Product(a, b);
        if (product.Low != 0) Add(product.Low);
        Add(product.High);
    }
}
