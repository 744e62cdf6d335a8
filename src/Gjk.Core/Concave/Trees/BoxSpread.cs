namespace Gjk.Core;

/// <summary>How the surfaces of triangles are spread: the moments of area about a point, and the axes along which they
/// spread most and least (Gottschalk, Lin and Manocha, "OBBTree", 1996).</summary>
/// <remarks>The axes only have to be good: the box along them is measured from the corners themselves.</remarks>
internal struct BoxSpread
{
    /// <summary>Count: each sweep of rotations doubles the digits, so eight are more than enough.</summary>
    private const int Sweeps = 8;

    /// <summary>Ratio to the diagonal: what is left beside it turns an axis by less than a float tells.</summary>
    private const double Negligible = 1e-12;

    private double _area, _x, _y, _z, _xx, _xy, _xz, _yy, _yz, _zz;

    /// <summary>Adds a triangle, whose corners are measured from near the middle of all.</summary>
    public void Add(in Double3 a, in Double3 b, in Double3 c)
    {
        Double3 sum = a + b + c;
        double area = Double3.Cross(b - a, c - a).Length;
        _area += area;
        _x += area * sum.X;
        _y += area * sum.Y;
        _z += area * sum.Z;
        _xx += area * (a.X * a.X + b.X * b.X + c.X * c.X + sum.X * sum.X);
        _xy += area * (a.X * a.Y + b.X * b.Y + c.X * c.Y + sum.X * sum.Y);
        _xz += area * (a.X * a.Z + b.X * b.Z + c.X * c.Z + sum.X * sum.Z);
        _yy += area * (a.Y * a.Y + b.Y * b.Y + c.Y * c.Y + sum.Y * sum.Y);
        _yz += area * (a.Y * a.Z + b.Y * b.Z + c.Y * c.Z + sum.Y * sum.Z);
        _zz += area * (a.Z * a.Z + b.Z * b.Z + c.Z * c.Z + sum.Z * sum.Z);
    }

    /// <summary>The axes of the spread; false where there is no area, or none that double holds.</summary>
    /// <param name="u">The first axis, a unit vector.</param>
    /// <param name="v">The second, perpendicular to it.</param>
    /// <param name="w">The third.</param>
    public readonly bool TryGetAxes(out Double3 u, out Double3 v, out Double3 w)
    {
        double k = 1 / (12 * _area), x = _x / (3 * _area), y = _y / (3 * _area), z = _z / (3 * _area);
        double xx = _xx * k - x * x, yy = _yy * k - y * y, zz = _zz * k - z * z;
        double xy = _xy * k - x * y, xz = _xz * k - x * z, yz = _yz * k - y * z;
        (u, v, w) = (new Double3(1, 0, 0), new Double3(0, 1, 0), new Double3(0, 0, 1));
        if (!Guard.IsFinite(xx + yy + zz + xy + xz + yz)) return false;
        for (int sweep = 0; sweep < Sweeps; sweep++)
        {
            double rest = Math.Abs(xy) + Math.Abs(xz) + Math.Abs(yz);
            if (!(rest > Negligible * (Math.Abs(xx) + Math.Abs(yy) + Math.Abs(zz)))) break;
            Uncouple(ref xx, ref yy, ref xy, ref xz, ref yz, ref u, ref v);
            Uncouple(ref xx, ref zz, ref xz, ref xy, ref yz, ref u, ref w);
            Uncouple(ref yy, ref zz, ref yz, ref xy, ref xz, ref v, ref w);
        }

        return true;
    }

    /// <summary>One of Jacobi's rotations (Golub and Van Loan, 8.5): what couples two axes becomes 0.</summary>
    private static void Uncouple(
        ref double pp, ref double qq, ref double pq, ref double pr, ref double qr, ref Double3 p, ref Double3 q)
    {
        if (pq == 0) return;
        double theta = (qq - pp) / (2 * pq);
        double t = (theta >= 0 ? 1 : -1) / (Math.Abs(theta) + Math.Sqrt(theta * theta + 1));
        double c = 1 / Math.Sqrt(t * t + 1), s = t * c;
        pp -= t * pq;
        qq += t * pq;
        pq = 0;
        (pr, qr) = (c * pr - s * qr, s * pr + c * qr);
        (p, q) = (p * c - q * s, p * s + q * c);
    }
}
