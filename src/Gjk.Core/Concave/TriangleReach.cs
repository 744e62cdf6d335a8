namespace Gjk.Core;

/// <summary>Decides whether a triangle is within a distance of a point, where double is certain. A point on a triangle,
/// but for rounding, is the slowest to measure; most points are such, or far away.</summary>
/// <remarks>The error is that of a determinant: how far a plane through three corners may be off.</remarks>
internal readonly ref struct TriangleReach(in Double3 a, in Double3 b, in Double3 c, in Double3 point)
{
    /// <summary>The corners relative to the point.</summary>
    private readonly Double3 _a = a - point, _b = b - point, _c = c - point;

    /// <summary>An upper bound of the distance to any corner.</summary>
    public double Size => _a.SumOfMagnitudes + _b.SumOfMagnitudes + _c.SumOfMagnitudes;

    /// <summary>Whether the triangle is certainly further away, by its box or its plane.</summary>
    public bool IsBeyond(double room)
    {
        if (AreBeyond(_a.X, _b.X, _c.X, room) || AreBeyond(_a.Y, _b.Y, _c.Y, room)
            || AreBeyond(_a.Z, _b.Z, _c.Z, room))
        {
            return true;
        }

        Double3 across = Double3.Cross(_b - _a, _c - _a);
        double error = GjkTolerances.DeterminantError * Size * Size * (Size + room);
        return Math.Abs(Double3.Dot(across, _a)) > room * across.SumOfMagnitudes + error;
    }

    /// <summary>Whether the triangle is certainly no further away: one of its points is not. That point is the nearest,
    /// up to rounding, if the point is over the triangle, and close to it beside an edge.</summary>
    public bool IsWithin(double room)
    {
        Double3 across = Double3.Cross(_b - _a, _c - _a);
        double ofA = Math.Max(Double3.Dot(across, Double3.Cross(_b, _c)), 0);
        double ofB = Math.Max(Double3.Dot(across, Double3.Cross(_c, _a)), 0);
        double ofC = Math.Max(Double3.Dot(across, Double3.Cross(_a, _b)), 0);
        Double3 near = (_a * ofA + _b * ofB + _c * ofC) * (1 / (ofA + ofB + ofC));
        return near.SumOfMagnitudes + GjkTolerances.DeterminantError * Size <= room;
    }

    private static bool AreBeyond(double a, double b, double c, double room) =>
        (a > room && b > room && c > room) || (-a > room && -b > room && -c > room);
}
