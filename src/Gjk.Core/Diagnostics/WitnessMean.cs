namespace Gjk.Core.Diagnostics;

/// <summary>A weighted mean of up to four points that is near the origin: the witness of an upper bound. Whatever the
/// weights are, as long as none is negative, it lies in everything convex that holds the points.</summary>
internal struct WitnessMean
{
    /// <summary>A pure number: to solve once more does not mend a weight so far below 0. Only speed depends on
    /// it.</summary>
    private const double Outside = -0.01;

    private Double3 _p0, _p1, _p2;
    private double _squared;

    /// <summary>How many points it is made of; 0 before the first.</summary>
    public int Count;

    /// <summary>The mean.</summary>
    public Double3 Value;

    /// <summary>Its distance from the origin.</summary>
    public readonly double Length => Value.Length;

    /// <summary>Tries the means that another point makes with those at hand, and keeps the nearest.</summary>
    /// <returns>False when none is nearer than before.</returns>
    public bool TryAdd(in Double3 p)
    {
        Double3 a = _p0, b = _p1, c = _p2;
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

    /// <summary>The direction in which to look for a nearer mean: away from the origin, across the points. It is the
    /// direction of the mean, but does not lose it where the mean is a small difference of long vectors.</summary>
    public readonly Double3 Across()
    {
        if (Count == 2)
        {
            Double3 e = _p1 - _p0;
            return Double3.Cross(e, Double3.Cross(Value, e));
        }

        if (Count != 3) return Value;
        Double3 n = Double3.Cross(_p1 - _p0, _p2 - _p0);
        return Double3.Dot(n, Value) < 0 ? -n : n;
    }

    /// <summary>With three points at hand: the solid, and what its further faces and edges are.</summary>
    private void TryFaces(in Double3 p, in Double3 a, in Double3 b, in Double3 c)
    {
        TryWeights(4, p, a, b, c, c - p);
        if (Count == 4) return;
        TrySegment(p, c);
        TryTriangle(p, b, c);
        TryTriangle(p, c, a);
    }

    private void TrySegment(in Double3 p, in Double3 a)
    {
        Double3 e = p - a;
        double wp = -Double3.Dot(a, e), wa = Double3.Dot(p, e), sum = wp + wa;
        Try(2, p, a, default, default, wp / sum, wa / sum, 0, 0);
    }

    private void TryTriangle(in Double3 p, in Double3 a, in Double3 b) =>
        TryWeights(3, p, a, b, default, Double3.Cross(a - p, b - p));

    /// <summary>The weights of the origin, or of what is nearest to it in the plane, by Cramer's rule. What that leaves
    /// of the mean is solved for once more: needles need it.</summary>
    /// <param name="count">Three or four points.</param>
    /// <param name="p">One of them.</param>
    /// <param name="a">The second.</param>
    /// <param name="b">The third.</param>
    /// <param name="c">The fourth, if there is one.</param>
    /// <param name="third">From p to c, or across the plane.</param>
    private void TryWeights(int count, in Double3 p, in Double3 a, in Double3 b, in Double3 c, in Double3 third)
    {
        Double3 first = a - p, second = b - p, overA = Double3.Cross(second, third);
        Double3 overB = Double3.Cross(third, first), overC = Double3.Cross(first, second), mean = p;
        double one = 1 / Double3.Dot(first, overA), wp = 1, wa = 0, wb = 0, wc = 0;
        for (int i = 0; i < 2; i++)
        {
            wa -= Double3.Dot(mean, overA) * one;
            wb -= Double3.Dot(mean, overB) * one;
            if (count == 4) wc -= Double3.Dot(mean, overC) * one;
            wp = 1 - wa - wb - wc;
            if (!(wp > Outside && wa > Outside && wb > Outside && wc > Outside)) return;
            mean = p * wp + a * wa + b * wb + c * wc;
        }

        Try(count, p, a, b, c, wp, wa, wb, wc);
    }

    /// <summary>Takes a mean if it is one and nearer.</summary>
    private void Try(
        int count, in Double3 p, in Double3 a, in Double3 b, in Double3 c, double wp, double wa, double wb,
        double wc)
    {
        if (!(wp > 0 && wa >= 0 && wb >= 0 && wc >= 0)) return;
        Double3 value = (p * wp + a * wa + b * wb + c * wc) * (1 / (wp + wa + wb + wc));
        double squared = value.LengthSquared;
        if (!(squared < _squared)) return;
        (_p0, _p1, _p2, Count, Value, _squared) = (p, a, b, count, value, squared);
    }
}
