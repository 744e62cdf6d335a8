namespace Gjk.Core;

/// <summary>
/// A weighted mean of up to four points that is near the origin: the witness of an upper bound. Whatever the weights,
/// as long as none is negative, it is a point of everything convex that holds the points.
/// </summary>
internal struct WitnessMean
{
    /// <summary>A pure number: a weight so far below 0 is not mended by solving once more. Any such will do.</summary>
    private const double Outside = -0.01;

    private Vector3D _p0, _p1, _p2, _p3;

    /// <summary>How many points it is made of; 0 before the first.</summary>
    public int Count;

    /// <summary>The mean.</summary>
    public Vector3D Value;

    private double _squared;

    /// <summary>Its distance from the origin.</summary>
    public readonly double Length => Value.Length;

    /// <summary>Tries the means that another point makes with those at hand, and keeps the nearest.</summary>
    /// <returns>False when none is nearer than before.</returns>
    public bool TryAdd(in Vector3D p)
    {
        Vector3D a = _p0, b = _p1, c = _p2;
        int count = Count;
        double before = count == 0 ? double.PositiveInfinity : _squared;
        _squared = before;
        if (count >= 3) TryTetrahedron(a, b, c, p);
        if (Count == 4) return true;
        Try(1, p, default, default, default, 1, 0, 0, 0);
        if (count >= 1) TrySegment(a, p);
        if (count >= 2) TrySegment(b, p);
        if (count >= 2) TryTriangle(a, b, p);
        if (count >= 3) TrySegment(c, p);
        if (count >= 3) TryTriangle(b, c, p);
        if (count >= 3) TryTriangle(c, a, p);
        return _squared < before;
    }

    /// <summary>
    /// The direction in which to look for a nearer mean: away from the origin, across the points.
    /// </summary>
    public readonly Vector3D Across()
    {
        if (Count == 2)
        {
            Vector3D e = _p1 - _p0;
            return Vector3D.Cross(e, Vector3D.Cross(Value, e));
        }

        if (Count != 3) return Value;
        Vector3D n = Vector3D.Cross(_p1 - _p0, _p2 - _p0);
        return Vector3D.Dot(n, Value) < 0 ? -n : n;
    }

    private void TrySegment(in Vector3D a, in Vector3D p)
    {
        Vector3D e = p - a;
        double wp = -Vector3D.Dot(a, e), wa = Vector3D.Dot(p, e), sum = wp + wa;
        Try(2, p, a, default, default, wp / sum, wa / sum, 0, 0);
    }

    private void TryTriangle(in Vector3D a, in Vector3D b, in Vector3D p) =>
        TrySolid(3, a, b, default, p, Vector3D.Cross(a - p, b - p));

    private void TryTetrahedron(in Vector3D a, in Vector3D b, in Vector3D c, in Vector3D p) =>
        TrySolid(4, a, b, c, p, c - p);

    /// <summary>
    /// The weights by Cramer's rule, twice: what the first time leaves of the mean is solved for once more, which is
    /// what needles need.
    /// </summary>
    private void TrySolid(
        int count, in Vector3D a, in Vector3D b, in Vector3D c, in Vector3D p, in Vector3D third)
    {
        Vector3D first = a - p, second = b - p, overA = Vector3D.Cross(second, third);
        Vector3D overB = Vector3D.Cross(third, first), overC = Vector3D.Cross(first, second), mean = p;
        double one = 1 / Vector3D.Dot(first, overA), wp = 1, wa = 0, wb = 0, wc = 0;
        for (int i = 0; i < 2; i++)
        {
            wa -= Vector3D.Dot(mean, overA) * one;
            wb -= Vector3D.Dot(mean, overB) * one;
            if (count == 4) wc -= Vector3D.Dot(mean, overC) * one;
            wp = 1 - wa - wb - wc;
            if (!(wp > Outside && wa > Outside && wb > Outside && wc > Outside)) return;
            mean = p * wp + a * wa + b * wb + c * wc;
        }

        Try(count, p, a, b, c, wp, wa, wb, wc);
    }

    /// <summary>Takes a mean if it is one and nearer.</summary>
    private void Try(
        int count, in Vector3D p, in Vector3D a, in Vector3D b, in Vector3D c, double wp, double wa, double wb,
        double wc)
    {
        if (!(wp > 0 && wa >= 0 && wb >= 0 && wc >= 0)) return;
        Vector3D value = (p * wp + a * wa + b * wb + c * wc) * (1 / (wp + wa + wb + wc));
        double squared = value.LengthSquared;
        if (!(squared < _squared)) return;
        (_p0, _p1, _p2, _p3, Count, Value, _squared) = (p, a, b, c, count, value, squared);
    }
}
