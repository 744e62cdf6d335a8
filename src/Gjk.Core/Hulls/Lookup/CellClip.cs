namespace Gjk.Core;

/// <summary>A rectangle of directions, clipped by half planes (Sutherland and Hodgman 1974).</summary>
internal sealed class CellClip
{
    private double[] _polygon = new double[16], _clipped = new double[16];
    private int _count;

    public void Start(double u, double v, double halfU, double halfV)
    {
        double left = u - halfU, right = u + halfU, low = v - halfV, high = v + halfV;
        (_polygon[0], _polygon[1], _polygon[2], _polygon[3]) = (left, low, right, low);
        (_polygon[4], _polygon[5], _polygon[6], _polygon[7]) = (right, high, left, high);
        _count = 4;
    }

    /// <summary>Keeps the part with p u + q v + r &lt;= limit; false when nothing is left.</summary>
    public bool Keep(double p, double q, double r, double limit)
    {
        // Rounding may add more corners than the one that a convex polygon gains, but never more than there are.
        if (_polygon.Length < 4 * _count) (_polygon, _clipped) = (Longer(_polygon), new double[2 * _polygon.Length]);
        int kept = 0;
        double u0 = _polygon[2 * _count - 2], v0 = _polygon[2 * _count - 1], d0 = p * u0 + q * v0 + r - limit;
        for (int i = 0; i < _count; i++)
        {
            double u1 = _polygon[2 * i], v1 = _polygon[2 * i + 1], d1 = p * u1 + q * v1 + r - limit;
            if (d0 <= 0 != d1 <= 0)
            {
                double t = d0 / (d0 - d1);
                _clipped[2 * kept] = u0 + t * (u1 - u0);
                _clipped[2 * kept++ + 1] = v0 + t * (v1 - v0);
            }

            if (d1 <= 0)
            {
                _clipped[2 * kept] = u1;
                _clipped[2 * kept++ + 1] = v1;
            }

            (u0, v0, d0) = (u1, v1, d1);
        }

        (_polygon, _clipped) = (_clipped, _polygon);
        _count = kept;
        return kept > 0;
    }

    private static double[] Longer(double[] polygon)
    {
        double[] longer = new double[2 * polygon.Length];
        polygon.CopyTo(longer, 0);
        return longer;
    }
}
