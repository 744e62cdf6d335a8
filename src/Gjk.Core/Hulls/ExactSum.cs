using System;

namespace Gjk.Core;

/// <summary>
/// A running sum of doubles without rounding, and its sign: the arithmetic behind the predicates of the hull.
/// </summary>
/// <remarks>
/// Source: J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997 (two-sum, two-product, Grow-Expansion with zeros
/// left out). The parts are kept by increasing magnitude and do not overlap, so the last one has the sign of the whole.
///
/// Range: every term here is a product of at most three floats or exact differences of floats. A float is a multiple of 2^-149 below 2^128, so each term and each
/// rounding error of one is a multiple of 2^-447 below 2^400: nothing underflows and nothing overflows in double, and denormal or huge inputs need no scaling.
/// Not thread-safe: one per build.
/// </remarks>
internal sealed class ExactSum
{
    /// <summary>24 products of three floats, two parts each, is the longest sum asked for.</summary>
    private const int MostParts = 48;

    /// <summary>2^27 + 1 cuts the 53 bits of a double into two halves whose products are exact (Dekker 1971).</summary>
    private const double Splitter = 134217729.0;

    private readonly double[] _parts = new double[MostParts];
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
            double part = parts[i];
            double sum = x + part;
            double partRounded = sum - x;
            double error = x - (sum - partRounded) + (part - partRounded);
            if (error != 0) parts[kept++] = error;
            x = sum;
        }

        if (x != 0) parts[kept++] = x;
        _count = kept;
    }

    /// <summary>Adds the determinant with rows p, q, r, whose components are floats or differences of floats that need no rounding.</summary>
    public void AddDeterminant(in Vector3D p, in Vector3D q, in Vector3D r)
    {
        AddProduct(p.X, q.Y, r.Z);
        AddProduct(-p.X, q.Z, r.Y);
        AddProduct(p.Y, q.Z, r.X);
        AddProduct(-p.Y, q.X, r.Z);
        AddProduct(p.Z, q.X, r.Y);
        AddProduct(-p.Z, q.Y, r.X);
    }

    private void AddProduct(double a, double b, double c)
    {
        double product = a * b;
        if (product == 0 || c == 0) return;
        double error = ProductError(a, b, product);
        if (error != 0) AddProduct(error, c);
        AddProduct(product, c);
    }

    private void AddProduct(double a, double b)
    {
        double product = a * b;
        double error = ProductError(a, b, product);
        if (error != 0) Add(error);
        Add(product);
    }

    /// <summary>The exact a b - product, where product is a b rounded.</summary>
    private static double ProductError(double a, double b, double product)
    {
        double scaled = Splitter * a;
        double aHigh = scaled - (scaled - a);
        double aLow = a - aHigh;
        scaled = Splitter * b;
        double bHigh = scaled - (scaled - b);
        double bLow = b - bHigh;
        return aLow * bLow - (product - aHigh * bHigh - aLow * bHigh - aHigh * bLow);
    }
}
