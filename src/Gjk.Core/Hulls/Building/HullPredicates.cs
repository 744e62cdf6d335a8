namespace Gjk.Core;

/// <summary>On which side of a line or a plane does a point of the cloud lie? The answers are exact for every finite
/// float, denormal or huge.</summary>
/// <remarks>A test against a plane is done in double first. The error bound belongs to the plane and holds for the
/// whole cloud, so a test costs three products. <see cref="HullDeterminant"/> decides where double cannot tell. On a
/// coarse lattice (<see cref="IsCoarseLattice"/>) determinants are exact in double: grids, where every other test is an
/// exact zero, cost no more than random points. Not thread-safe: one per build.</remarks>
internal sealed class HullPredicates
{
    /// <summary>Relative to the sum of the magnitudes of the terms. In units of u = 2^-53 a term of the height suffers:
    /// 2 for the two differences of the normal, 1 for their product, 1 for the subtraction, 1 for the difference p - A,
    /// 1 for the product, 2 for the sum, 8 u in all; 16 u leaves room for second orders and for the rounding of the
    /// bound itself (proofs/hull-plane.g). Pinned by HullPredicatesTests, which asks for exact answers on nearly flat
    /// quadruples.</summary>
    private const double PlaneErrorFactor = 16.0 / (1L << 53);

    /// <summary>A determinant of differences up to 2^16 units is below 6 * 2^48 &lt; 2^53, so that every step of it is
    /// exact in double.</summary>
    private const double CoarseLatticeSteps = 1 << 16;

    private readonly Vector3[] _points;
    private readonly PlanarOrientation _orientation = new();
    private readonly bool _exactInDouble;
    private readonly double _extentX, _extentY, _extentZ;

    public HullPredicates(Vector3[] points)
    {
        _points = points;
        var bounds = Aabb.Around(points);
        Double3 extent = (Double3)bounds.Max - bounds.Min;
        (_extentX, _extentY, _extentZ) = (extent.X, extent.Y, extent.Z);
        _exactInDouble = IsCoarseLattice(points, bounds.LongestSide);
    }

    public Vector3[] Points => _points;

    /// <summary>What decides where double cannot tell; it counts how often.</summary>
    public HullDeterminant Determinant { get; } = new();

    public HullPlane PlaneThrough(int a, int b, int c)
    {
        Double3 origin = _points[a];
        Double3 u = _points[b] - origin, v = _points[c] - origin;
        double yz = u.Y * v.Z, zy = u.Z * v.Y, zx = u.Z * v.X, xz = u.X * v.Z, xy = u.X * v.Y, yx = u.Y * v.X;
        double largest = (Math.Abs(yz) + Math.Abs(zy)) * _extentX
            + (Math.Abs(zx) + Math.Abs(xz)) * _extentY
            + (Math.Abs(xy) + Math.Abs(yx)) * _extentZ;
        return new HullPlane
        {
            A = a,
            B = b,
            C = c,
            NormalX = yz - zy,
            NormalY = zx - xz,
            NormalZ = xy - yx,
            HeightError = _exactInDouble ? 0 : PlaneErrorFactor * largest,
        };
    }

    /// <summary>1 strictly above the plane, 0 in it, -1 below. The height, by the length of the normal, is rounded and
    /// only good for comparing.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Side(in HullPlane plane, int point, out double height)
    {
        Vector3 anchor = _points[plane.A], p = _points[point];
        height = plane.NormalX * ((double)p.X - anchor.X)
            + plane.NormalY * ((double)p.Y - anchor.Y)
            + plane.NormalZ * ((double)p.Z - anchor.Z);
        if (height > plane.HeightError) return 1;
        if (height < -plane.HeightError) return -1;
        return _exactInDouble ? 0 : Determinant.Sign(_points[plane.A], _points[plane.B], _points[plane.C], p);
    }

    /// <summary>1 when c lies to the left of the line from a to b in the plane of two axes, 0 on it, -1 to the
    /// right.</summary>
    public int Orientation(int a, int b, int c, int axisU, int axisV) => _orientation.Sign(
        Coordinate(a, axisU), Coordinate(a, axisV), Coordinate(b, axisU), Coordinate(b, axisV),
        Coordinate(c, axisU), Coordinate(c, axisV));

    /// <summary>True when the three points lie on one line: they do in every projection.</summary>
    public bool AreCollinear(int a, int b, int c) =>
        Orientation(a, b, c, 0, 1) == 0 && Orientation(a, b, c, 1, 2) == 0 && Orientation(a, b, c, 2, 0) == 0;

    public float Coordinate(int point, int axis) => axis switch
    {
        0 => _points[point].X,
        1 => _points[point].Y,
        _ => _points[point].Z,
    };

    /// <summary>True when all coordinates are multiples of one power of two that fits into the extent at most 2^16
    /// times.</summary>
    private static bool IsCoarseLattice(Vector3[] points, double extent)
    {
        // The smallest power of two with which the extent is short enough: multiples of a larger one are multiples of
        // it too.
        double step = 1;
        while (step * CoarseLatticeSteps < extent) step *= 2;
        while (step * CoarseLatticeSteps >= 2 * extent && step > float.Epsilon) step /= 2;
        foreach (Vector3 p in points)
        {
            if (!IsMultiple(p.X, step) || !IsMultiple(p.Y, step) || !IsMultiple(p.Z, step)) return false;
        }

        return true;
    }

    /// <summary>The quotient by a power of two is exact, and doubles from 2^52 upwards are whole numbers.</summary>
    private static bool IsMultiple(float x, double step)
    {
        double quotient = x / step;
        return quotient == Math.Floor(quotient);
    }
}
