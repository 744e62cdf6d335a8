namespace Gjk.Core;

/// <summary>The sign of the volume that four points span, for the points on which a plane's rounded test cannot tell.
/// Exact.</summary>
/// <remarks>
/// Four stages, each asked only where the one before cannot tell:
/// 1. double, with an error bound of these four points, not of the whole cloud;
/// 2. double-double, 106 bits, in which the differences of coordinates are exact;
/// 3. lattice: x, y and z of the four points are multiples of some powers of two, so the volume is a multiple of their
///    product. If it is known to be smaller, it is zero;
/// 4. triple products, summed exactly: 6 of the differences where double holds these exactly, else 24 of the
///    coordinates. The differences are taken from the point nearest the others, where the magnitudes and the error
///    bounds are smallest. Coplanar points, of which meshes are full, end at stage 3 unless their magnitudes are far
///    apart. Not thread-safe: one per build.
/// </remarks>
internal sealed class HullDeterminant
{
    /// <summary>Relative to the sum of the magnitudes of the terms. In units of u = 2^-53 a term suffers: 3 for the
    /// three differences, 2 for the products, 3 for the sums, 8 u in all; 16 u leaves room for second orders and for
    /// the rounding of the bound itself (proofs/hull-plane.g). Pinned by HullPredicatesTests.</summary>
    private const double ErrorFactor = 16.0 / (1L << 53);

    /// <summary>As above, in double-double. In units of 2^-106 a product suffers 7 (proofs/extended-product.g) and a
    /// sum 3, so a term 7 + 3 + 7 + 3 + 3 = 23; 128 leaves room for what those figures leave out, and for the rounding
    /// of the bound itself (proofs/hull-extended.g).</summary>
    private const double ExtendedErrorFactor = 128.0 / (1L << 53) / (1L << 53);

    private readonly ExactSum _sum = new();

    /// <summary>How many determinants have been asked for.</summary>
    public long Count { get; private set; }

    /// <summary>How many of them had to be summed exactly.</summary>
    public long SumCount { get; private set; }

    /// <summary>1 when p is strictly above the plane through a, b and c, seen from where they are counter-clockwise; 0
    /// in it, -1 below.</summary>
    public int Sign(in Vector3 a, in Vector3 b, in Vector3 c, in Vector3 p)
    {
        Count++;
        double ab = Reach(a, b), ac = Reach(a, c), ap = Reach(a, p);
        double bc = Reach(b, c), bp = Reach(b, p), cp = Reach(c, p);
        double fromA = ab * ac * ap, fromB = ab * bc * bp, fromC = ac * bc * cp, fromP = ap * bp * cp;

        // Two exchanges of points leave the sign as it is.
        if (fromA <= fromB && fromA <= fromC && fromA <= fromP) return SignFrom(a, b, c, p);
        if (fromB <= fromC && fromB <= fromP) return SignFrom(b, a, p, c);
        return fromC <= fromP ? SignFrom(c, p, a, b) : SignFrom(p, c, b, a);
    }

    /// <summary>As <see cref="Sign"/>, with differences from a.</summary>
    private int SignFrom(in Vector3 a, in Vector3 b, in Vector3 c, in Vector3 p)
    {
        Double3 origin = a, u = b - origin, v = c - origin, w = p - origin;
        double yz = u.Y * v.Z, zy = u.Z * v.Y, zx = u.Z * v.X, xz = u.X * v.Z, xy = u.X * v.Y, yx = u.Y * v.X;
        double volume = (yz - zy) * w.X + (zx - xz) * w.Y + (xy - yx) * w.Z;
        double magnitude = (Math.Abs(yz) + Math.Abs(zy)) * Math.Abs(w.X)
            + (Math.Abs(zx) + Math.Abs(xz)) * Math.Abs(w.Y)
            + (Math.Abs(xy) + Math.Abs(yx)) * Math.Abs(w.Z);
        if (Math.Abs(volume) > ErrorFactor * magnitude) return Math.Sign(volume);

        double error = ExtendedErrorFactor * magnitude;
        VectorDD exactU = Difference(b, a), exactV = Difference(c, a), exactW = Difference(p, a);
        DoubleDouble extended = VectorDD.Dot(VectorDD.Cross(exactU, exactV), exactW);
        if (Math.Abs(extended.High) > error) return extended.Sign;

        // The exact volume is at most the computed one plus the error, and the computed one is at most the error.
        if (2 * error < Step(a.X, b.X, c.X, p.X) * Step(a.Y, b.Y, c.Y, p.Y) * Step(a.Z, b.Z, c.Z, p.Z)) return 0;

        SumCount++;
        _sum.Clear();
        if (IsDouble(exactU) && IsDouble(exactV) && IsDouble(exactW)) Add(u, v, w);
        else AddCoordinates(a, b, c, p);
        return _sum.Sign;
    }

    /// <summary>|b-a, c-a, p-a| by rows, multiplied out: terms with two rows a vanish.</summary>
    private void AddCoordinates(in Double3 a, in Double3 b, in Double3 c, in Double3 p)
    {
        Add(b, c, p);
        Add(-a, c, p);
        Add(a, b, p);
        Add(-a, b, c);
    }

    /// <summary>Adds the determinant with rows p, q, r, whose components are floats, or differences of floats that need
    /// no rounding.</summary>
    private void Add(in Double3 p, in Double3 q, in Double3 r)
    {
        _sum.AddProduct(p.X, q.Y, r.Z);
        _sum.AddProduct(-p.X, q.Z, r.Y);
        _sum.AddProduct(p.Y, q.Z, r.X);
        _sum.AddProduct(-p.Y, q.X, r.Z);
        _sum.AddProduct(p.Z, q.X, r.Y);
        _sum.AddProduct(-p.Z, q.Y, r.X);
    }

    private static double Reach(in Vector3 a, in Vector3 b) =>
        Math.Abs((double)a.X - b.X) + Math.Abs((double)a.Y - b.Y) + Math.Abs((double)a.Z - b.Z);

    /// <summary>a - b without error.</summary>
    private static VectorDD Difference(in Double3 a, in Double3 b) =>
        new(DoubleDouble.Sum(a.X, -b.X), DoubleDouble.Sum(a.Y, -b.Y), DoubleDouble.Sum(a.Z, -b.Z));

    private static bool IsDouble(in VectorDD v) => v.X.Low == 0 && v.Y.Low == 0 && v.Z.Low == 0;

    /// <summary>The largest power of two of which all four are multiples; infinite when all are zero.</summary>
    private static double Step(float a, float b, float c, float d) =>
        Math.Min(Math.Min(Step(a), Step(b)), Math.Min(Step(c), Step(d)));

    /// <summary>The value of the last bit that is set.</summary>
    private static unsafe double Step(float x)
    {
        const int MantissaBits = 23, DoubleMantissaBits = 52, BiasDifference = 1023 - 127;
        uint bits = *(uint*)&x;
        int exponent = (int)(bits >> MantissaBits & 0xFF);
        uint mantissa = bits & ((1u << MantissaBits) - 1);
        if (exponent == 0) exponent = 1;
        else mantissa |= 1u << MantissaBits;
        if (mantissa == 0) return double.PositiveInfinity;
        long unit = (long)(exponent - MantissaBits + BiasDifference) << DoubleMantissaBits;
        return *(double*)&unit * (mantissa & (~mantissa + 1));
    }
}
