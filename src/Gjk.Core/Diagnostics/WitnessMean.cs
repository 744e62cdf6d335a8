namespace Gjk.Core;

/// <summary>
/// A weighted mean of up to four points that is near the origin: the witness of an upper bound. Whatever the weights
/// are, as long as none is negative, it lies in everything convex that holds the points.
/// </summary>
internal struct WitnessMean
{
    /// <summary>
    /// A pure number: to solve once more does not mend a weight so far below 0. Only speed depends on it.
    /// </summary>
    private const double Outside = -0.01;

    private Vector3D _p0, _p1, _p2, _p3;
    private double _squared;

    /// <summary>How many points it is made of; 0 before the first.</summary>
    public int Count;

    /// <summary>The mean.</summary>
    public Vector3D Value;

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
        if (count >= 3) TryFaces(p, a, b, c);
        if (Count == 4) return true;
        Try(1, p, default, default, default, 1, 0, 0, 0);
        if (count >= 1) TrySegment(p, a);
        if (count >= 2) TrySegment(p, b);
        if (count >= 2) TryTriangle(p, a, b);
        return _squared < before;
    }

    /// <summary>
    /// The direction in which to look for a nearer mean: away from the origin, across the points. It is the direction
    /// of the mean, but does not lose it where the mean is a small difference of long vectors.
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

    /// <summary>With three points at hand: the solid, and what its further faces and edges are.</summary>
    private void TryFaces(in Vector3D p, in Vector3D a, in Vector3D b, in Vector3D c)
    {
        TryWeights(4, p, a, b, c, c - p);
        if (Count == 4) return;
        TrySegment(p, c);
        TryTriangle(p, b, c);
        TryTriangle(p, c, a);
    }

    private void TrySegment(in Vector3D p, in Vector3D a)
    {
        Vector3D e = p - a;
        double wp = -Vector3D.Dot(a, e), wa = Vector3D.Dot(p, e), sum = wp + wa;
        Try(2, p, a, default, default, wp / sum, wa / sum, 0, 0);
    }

    private void TryTriangle(in Vector3D p, in Vector3D a, in Vector3D b) =>
        TryWeights(3, p, a, b, default, Vector3D.Cross(a - p, b - p));

    /// <summary>
    /// The weights of the origin, or of what is nearest to it in the plane, by Cramer's rule. What that leaves of the
    /// mean is solved for once more: needles need it.
    /// </summary>
    /// <param name="count">Three or four points.</param>
    /// <param name="p">One of them.</param>
    /// <param name="a">The second.</param>
    /// <param name="b">The third.</param>
    /// <param name="c">The fourth, if there is one.</param>
    /// <param name="third">From p to c, or across the plane.</param>
    private void TryWeights(
        int count, in Vector3D p, in Vector3D a, in Vector3D b, in Vector3D c, in Vector3D third)
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
