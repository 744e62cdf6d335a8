namespace Gjk.Core;

/// <summary>On which side of a line lies a point of the plane? Exact for coordinates that are finite floats, denormal
/// or huge. Not thread-safe.</summary>
internal sealed class PlanarOrientation
{
    /// <summary>Relative to the sum of the two products of the test: 4 u, in units of u = 2^-53, is proved enough (3 u
    /// + 16 u^2 in Shewchuk 1997; with the differences of doubles proofs/hull-line.g), 8 u leaves room. Pinned by
    /// HullPredicatesTests.</summary>
    private const double LineErrorFactor = 8.0 / (1L << 53);

    private readonly ExactSum _sum = new();

    /// <summary>1 when c lies to the left of the line from a to b, 0 on it, -1 to the right.</summary>
    public int Sign(double au, double av, double bu, double bv, double cu, double cv)
    {
        double left = (bu - au) * (cv - av), right = (bv - av) * (cu - au);
        double turn = left - right;
        if (Math.Abs(turn) > LineErrorFactor * (Math.Abs(left) + Math.Abs(right))) return Math.Sign(turn);

        // A product of two floats is exact in double.
        _sum.Clear();
        _sum.Add(bu * cv);
        _sum.Add(-bv * cu);
        _sum.Add(cu * av);
        _sum.Add(-cv * au);
        _sum.Add(au * bv);
        _sum.Add(-av * bu);
        return _sum.Sign;
    }
}
