using System;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// The closed-form support functions, each written once for the shape struct and for <see cref="ConvexShape"/>. Ties go
/// to the lowest id. Corners are compared by their differences, so that a shape far from its local origin is asked as
/// exactly as one at it. Ericson, Real-Time Collision Detection (2004), section 9.5, has them all but the cone, which
/// is in van den Bergen (2003), section 4.3.4.
/// </summary>
internal static class PrimitiveSupport
{
    /// <summary>
    /// Squares of lengths between which no square has lost digits or overflowed. Outside, the direction is brought to
    /// unit size first. Pinned by DirectionLengthTests.
    /// </summary>
    private const double LeastSquare = 1e-270, MostSquare = 1e300;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Segment(in Vector3D a, in Vector3D b, in Vector3D direction, out Vector3D point)
    {
        bool first = SegmentCore.FurthestEnd(a - b, direction) == 0;
        point = first ? a : b;
        return first ? 0 : 1;
    }

    public static int Triangle(in Vector3D a, in Vector3D b, in Vector3D c, in Vector3D direction, out Vector3D point)
    {
        int id = TriangleCore.Furthest(b - a, c - a, direction);
        point = id == 0 ? a : id == 1 ? b : c;
        return id;
    }

    /// <summary>
    /// The disc of the given radius about the y axis: the rim point in the direction, the centre where the direction
    /// has no radial part.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Disc(double radius, double dx, double dz, out double x, out double z)
    {
        double squared = dx * dx + dz * dz;
        if (!(squared > LeastSquare && squared < MostSquare))
        {
            DirectionRange.ToUnit(ref dx, ref dz);
            squared = dx * dx + dz * dz;
        }

        double radial = Math.Sqrt(squared), s = radial > 0 ? radius / radial : 0;
        x = s * dx;
        z = s * dz;
    }

    public static Vector3D Cylinder(double radius, double halfHeight, in Vector3D direction)
    {
        Disc(radius, direction.X, direction.Z, out double x, out double z);
        return new Vector3D(x, direction.Y < 0 ? -halfHeight : halfHeight, z);
    }

    /// <summary>The better of the apex and the base's rim point.</summary>
    public static Vector3D Cone(double radius, double halfHeight, in Vector3D direction)
    {
        Vector3D d = direction;
        double squared = d.LengthSquared;
        if (!(squared > LeastSquare && squared < MostSquare)) d = DirectionRange.ToUnit(d);
        Disc(radius, d.X, d.Z, out double x, out double z);
        double apex = d.Y * halfHeight;
        double rim = d.X * x + d.Z * z - apex;
        return apex >= rim ? new Vector3D(0, halfHeight, 0) : new Vector3D(x, -halfHeight, z);
    }

    /// <summary>
    /// The unit ball's support in the direction seen by it, mapped back: D (D d / |D d|) with D = diag(radii).
    /// </summary>
    public static Vector3D Ellipsoid(in Vector3D radii, in Vector3D direction)
    {
        Vector3D scaled = Vector3D.Multiply(radii, direction);
        double squared = scaled.LengthSquared;
        if (!(squared > LeastSquare && squared < MostSquare))
        {
            scaled = DirectionRange.ToUnit(Vector3D.Multiply(radii, DirectionRange.ToUnit(direction)));
            squared = scaled.LengthSquared;
        }

        double length = Math.Sqrt(squared);
        return length > 0 ? Vector3D.Multiply(radii, scaled) * (1 / length) : default;
    }

    public static bool Two(in Vector3D a, in Vector3D b, int id, out Vector3D point)
    {
        point = id == 0 ? a : b;
        return (uint)id < 2u;
    }
}
