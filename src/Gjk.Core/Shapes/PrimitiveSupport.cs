namespace Gjk.Core;

/// <summary>The closed-form support functions, each written once for the shape struct and for
/// <see cref="ConvexShape"/>. Ties go to the lowest id. Corners are compared by their differences, so that a shape far
/// from its local origin is asked as exactly as one at it. Ericson, Real-Time Collision Detection (2004), section 9.5,
/// has them all but the cone, which is in van den Bergen (2003), section 4.3.4.</summary>
internal static class PrimitiveSupport
{
    /// <summary>Squares of lengths between which no square has lost digits or overflowed. Outside, the direction is
    /// brought to unit size first. Pinned by DirectionLengthTests.</summary>
    private const double LeastSquare = 1e-270, MostSquare = 1e300;

    /// <summary>The only vertex of a point; a sphere's core is one.</summary>
    public static int Point(out Double3 point)
    {
        point = default;
        return 0;
    }

    /// <summary>Of no shape.</summary>
    public static int Nowhere(out Double3 point)
    {
        point = new Double3(double.NaN, double.NaN, double.NaN);
        return -1;
    }

    /// <summary>Of a shape without corners.</summary>
    public static bool NoVertex(out Double3 point)
    {
        point = default;
        return false;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Segment(in Double3 a, in Double3 b, in Double3 direction, out Double3 point)
    {
        a.Plus(b, -1, out point);
        int id = SegmentCore.FurthestEnd(point, direction);
        ref readonly Double3 end = ref id == 0 ? ref a : ref b;
        Double3.Write(end.X, end.Y, end.Z, out point);
        return id;
    }

    public static int Triangle(in Double3 a, in Double3 b, in Double3 c, in Double3 direction, out Double3 point)
    {
        int id = TriangleCore.Furthest(b.X - a.X, b.Y - a.Y, b.Z - a.Z, c.X - a.X, c.Y - a.Y, c.Z - a.Z, direction);
        ref readonly Double3 corner = ref id == 0 ? ref a : ref id == 1 ? ref b : ref c;
        Double3.Write(corner.X, corner.Y, corner.Z, out point);
        return id;
    }

    /// <summary>The disc of the given radius about the y axis: the rim point in the direction, the centre where the
    /// direction has no radial part.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Disc(double radius, double dx, double dz, out double x, out double z)
    {
        double squared = dx * dx + dz * dz;
        if (!HasSafeSquare(squared))
        {
            DirectionRange.ToUnit(ref dx, ref dz);
            squared = dx * dx + dz * dz;
        }

        double radial = Math.Sqrt(squared), s = radial > 0 ? radius / radial : 0;
        x = s * dx;
        z = s * dz;
    }

    public static int Cylinder(double radius, double halfHeight, in Double3 direction, out Double3 point)
    {
        Disc(radius, direction.X, direction.Z, out double x, out double z);
        Double3.Write(x, direction.Y < 0 ? -halfHeight : halfHeight, z, out point);
        return -1;
    }

    /// <summary>The better of the apex and the base's rim point.</summary>
    public static int Cone(double radius, double halfHeight, in Double3 direction, out Double3 point) =>
        HasSafeSquare(direction.LengthSquared)
            ? SafeCone(radius, halfHeight, direction, out point)
            : SafeCone(radius, halfHeight, DirectionRange.ToUnit(direction), out point);

    private static int SafeCone(double radius, double halfHeight, in Double3 d, out Double3 point)
    {
        Disc(radius, d.X, d.Z, out double x, out double z);
        double apex = d.Y * halfHeight;
        double rim = d.X * x + d.Z * z - apex;
        bool isApex = apex >= rim;
        Double3.Write(isApex ? 0 : x, isApex ? halfHeight : -halfHeight, isApex ? 0 : z, out point);
        return -1;
    }

    /// <summary>The unit ball's support in the direction seen by it, mapped back: D (D d / |D d|) with D =
    /// diag(radii).</summary>
    public static int Ellipsoid(in Double3 radii, in Double3 direction, out Double3 point)
    {
        Double3.Write(radii.X * direction.X, radii.Y * direction.Y, radii.Z * direction.Z, out point);
        double squared = point.LengthSquared;
        if (!HasSafeSquare(squared))
        {
            point = DirectionRange.ToUnit(Double3.Multiply(radii, DirectionRange.ToUnit(direction)));
            squared = point.LengthSquared;
        }

        double length = Math.Sqrt(squared), s = 1 / length;
        if (length > 0) Double3.Write(radii.X * point.X * s, radii.Y * point.Y * s, radii.Z * point.Z * s, out point);
        else point = default;
        return -1;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool HasSafeSquare(double squared) => squared > LeastSquare && squared < MostSquare;

    public static bool Two(in Double3 a, in Double3 b, int id, out Double3 point)
    {
        point = id == 0 ? a : b;
        return (uint)id < 2u;
    }

    public static bool Three(in Double3 a, in Double3 b, in Double3 c, int id, out Double3 point)
    {
        point = id == 0 ? a : id == 1 ? b : c;
        return (uint)id < 3u;
    }
}
