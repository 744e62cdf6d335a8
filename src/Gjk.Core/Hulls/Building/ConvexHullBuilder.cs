namespace Gjk.Core;

/// <summary>From distinct points to their hull: finds out whether they span a point, a segment, a polygon or a solid,
/// and calls the method for it.</summary>
/// <remarks>Rounded measures choose good starting points (far apart), exact predicates decide what they span. So a
/// cloud that is flat but for one bit is a solid, and a cloud that is exactly flat is a polygon. Not thread-safe: one
/// per build.</remarks>
internal sealed class ConvexHullBuilder(Vector3[] points, int mostWork)
{
    private readonly Vector3[] _points = points;
    private readonly HullPredicates _predicates = new(points);
    private long _work;

    /// <param name="points">At least one, all different, all finite.</param>
    public static HullMesh Build(Vector3[] points) => Build(points, QuickHull.MostWork, out _);

    /// <param name="points">At least one, all different, all finite.</param>
    /// <param name="mostWork">As for <see cref="QuickHull.Build"/>.</param>
    /// <param name="work">The work of a solid, in tests of a point against a plane; 0 for others.</param>
    public static HullMesh Build(Vector3[] points, int mostWork, out long work)
    {
        var builder = new ConvexHullBuilder(points, mostWork);
        HullMesh mesh = builder.Build();
        work = builder._work;
        return mesh;
    }

    private HullMesh Build()
    {
        if (_points.Length == 1) return new HullMesh(0, [0], [], 1);
        int a = FirstInLexicographicOrder(1);
        int b = FurthestFrom(a);
        int c = OffLine(a, b);
        if (c < 0) return Segment(a);
        int d = OffPlane(a, b, c, out bool isAbove);
        if (d < 0) return Polygon(a, b, c);

        if (isAbove) (b, c) = (c, b);
        HullSurface surface = QuickHull.Build(_predicates, a, b, c, d, mostWork, out _work);
        return HullFacets.Build(surface, _points.Length);
    }

    /// <summary>On a line the lexicographic order is the order along it, so the ends are its first and its
    /// last.</summary>
    private HullMesh Segment(int first)
    {
        int last = FirstInLexicographicOrder(-1);
        return new HullMesh(1, [Math.Min(first, last), Math.Max(first, last)], [], _points.Length);
    }

    /// <summary>Projects along an axis that is not parallel to the plane; there is one, because the three points are
    /// not on a line.</summary>
    private HullMesh Polygon(int a, int b, int c)
    {
        int axis = 0;
        while (_predicates.Orientation(a, b, c, (axis + 1) % 3, (axis + 2) % 3) == 0) axis++;
        return PlanarHull.Build(_predicates, (axis + 1) % 3, (axis + 2) % 3);
    }

    private int FirstInLexicographicOrder(int sign)
    {
        int best = 0;
        for (int i = 1; i < _points.Length; i++)
        {
            Vector3 p = _points[i], q = _points[best];
            int order = p.X.CompareTo(q.X);
            if (order == 0) order = p.Y.CompareTo(q.Y);
            if (order == 0) order = p.Z.CompareTo(q.Z);
            if (sign * order < 0) best = i;
        }

        return best;
    }

    private int FurthestFrom(int a)
    {
        Double3 origin = _points[a];
        int best = -1;
        double most = 0;
        for (int i = 0; i < _points.Length; i++)
        {
            // Different floats are at least 2^-149 apart, so the square of their distance does not vanish in double.
            double squared = (_points[i] - origin).LengthSquared;
            if (squared <= most) continue;
            most = squared;
            best = i;
        }

        return best;
    }

    /// <summary>A point that is not on the line through a and b, or -1.</summary>
    private int OffLine(int a, int b)
    {
        Double3 origin = _points[a];
        Double3 along = _points[b] - origin;
        int best = a;
        double most = 0;
        for (int i = 0; i < _points.Length; i++)
        {
            double squared = Double3.Cross(along, _points[i] - origin).LengthSquared;
            if (squared <= most) continue;
            most = squared;
            best = i;
        }

        if (!_predicates.AreCollinear(a, b, best)) return best;

        // What looked furthest was rounding, so ask each point exactly.
        for (int i = 0; i < _points.Length; i++)
        {
            if (!_predicates.AreCollinear(a, b, i)) return i;
        }

        return -1;
    }

    /// <summary>A point that is not in the plane through a, b and c, or -1.</summary>
    private int OffPlane(int a, int b, int c, out bool isAbove)
    {
        HullPlane plane = _predicates.PlaneThrough(a, b, c);
        int best = -1;
        double most = -1;
        isAbove = false;
        for (int i = 0; i < _points.Length; i++)
        {
            int side = _predicates.Side(plane, i, out double height);
            if (side == 0 || Math.Abs(height) <= most) continue;
            most = Math.Abs(height);
            best = i;
            isAbove = side > 0;
        }

        return best;
    }
}
