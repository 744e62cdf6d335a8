namespace Gjk.Core;

/// <summary>The surface's normal where an ellipsoid is nearest a point, by the root of one equation (Eberly, "Distance
/// from a point to an ellipse, an ellipsoid, or a hyperellipsoid", 2013).</summary>
/// <remarks>
/// <para>The nearest point x and the given one p satisfy p = x + t n with n = x / r², for each axis by itself. So x / r
/// = z ρ / (u + ρ - 1) with z = p / r, ρ the squared ratio of the radius to the least one, and one unknown u = 1 + t /
/// r² of that one; and x lies on the surface: the squares add up to 1. Of all roots the largest belongs to the nearest
/// point.</para>
/// <para>Two things differ from the source. The unknown is u, which is 0 and not -1 at the worst, so that nothing
/// cancels there. And Newton's step takes the place of bisection: the sum is convex and falls, so that steps from the
/// left never pass the root, and they end when rounding stops them. Where the point lies in the plane across the
/// shortest axis and the sum is too small even for u = 0, x leaves the plane by as much as is missing.</para>
/// <para>Beyond the centre another point may be the nearest of all around it, never a third one. Its u is the root next
/// to 0 from below, where the sum is convex, too: steps from the right never pass it. Where there is none, some normal
/// comes out.</para>
/// </remarks>
internal static class EllipsoidNormal
{
    /// <summary>Count: far from the root a step grows u by half of it, so that this many reach it from the least
    /// double.</summary>
    private const int MostSteps = 2048;

    /// <summary>The outward normal at the nearest point, of unit length.</summary>
    /// <param name="radii">All above 0.</param>
    /// <param name="point">Measured from the centre, along the axes.</param>
    /// <param name="isOther">Asks for the one on the other side of the centre, across the shortest axis, where no point
    /// around is nearer.</param>
    public static Double3 Nearest(in Double3 radii, in Double3 point, bool isOther = false)
    {
        double least = Math.Min(Math.Min(radii.X, radii.Y), radii.Z);
        double ex = Excess(radii.X, least), ey = Excess(radii.Y, least), ez = Excess(radii.Z, least);
        double zx = (1 + ex) * Math.Abs(point.X / radii.X), zy = (1 + ey) * Math.Abs(point.Y / radii.Y);
        double zz = (1 + ez) * Math.Abs(point.Z / radii.Z);
        double u = isOther ? -(ex == 0 ? zx : ey == 0 ? zy : zz)
            : Math.Max(Math.Max(Math.Max(zx - ex, zy - ey), zz - ez), 0), x, y, z;
        for (int i = 0; ; i++)
        {
            x = Ratio(zx, u + ex);
            y = Ratio(zy, u + ey);
            z = Ratio(zz, u + ez);
            double over = x * x + y * y + z * z - 1;
            double slope = 2 * (Ratio(x * x, u + ex) + Ratio(y * y, u + ey) + Ratio(z * z, u + ez));
            double next = u + over / slope;
            if (!(over > 0 && (isOther ? next < u : next > u)) || i == MostSteps) break;
            u = next;
        }

        double missing = Math.Sqrt(Math.Max(1 - (x * x + y * y + z * z), 0)) * (isOther ? -1 : 1);
        if (u == 0 && ex == 0) x = missing;
        else if (u == 0 && ey == 0) y = missing;
        else if (u == 0) z = missing;
        var normal = new Double3(
            Signed(x / radii.X, point.X), Signed(y / radii.Y, point.Y), Signed(z / radii.Z, point.Z));
        return normal * (1 / normal.Length);
    }

    /// <summary>The same for a line: what an ellipsoid and a line along another direction are, seen along it.</summary>
    /// <param name="radii">All above 0.</param>
    /// <param name="point">A point of the line.</param>
    /// <param name="along">The line's direction, of unit length.</param>
    /// <param name="isOther">As above.</param>
    public static Double3 Nearest(in Double3 radii, in Double3 point, in Double3 along, bool isOther)
    {
        // The shadow is an ellipse; one step of Jacobi's method (1846) finds its axes.
        (Double3 u, Double3 v) = new PlaneBasis(along);
        Double3 onU = Double3.Multiply(radii, u), onV = Double3.Multiply(radii, v);
        double mixed = Double3.Dot(onU, onV), half = 0.5 * (onV.LengthSquared - onU.LengthSquared);
        double tangent = mixed == 0 ? 0
            : mixed / (half + BranchFree.WithSign(Math.Sqrt(half * half + mixed * mixed), half));
        double cosine = 1 / Math.Sqrt(1 + tangent * tangent), sine = tangent * cosine;
        (u, v) = (u * cosine - v * sine, u * sine + v * cosine);
        double x = Double3.Multiply(radii, u).Length, y = Double3.Multiply(radii, v).Length;
        var seen = new Double3(Double3.Dot(point, u), Double3.Dot(point, v), 0);
        Double3 normal = Nearest(new Double3(x, y, Math.Max(x, y)), seen, isOther);
        return u * normal.X + v * normal.Y;
    }

    /// <summary>The squared ratio of a radius to the least one, less 1.</summary>
    private static double Excess(double radius, double least) => (radius - least) / least * ((radius + least) / least);

    private static double Ratio(double a, double b) => a > 0 ? a / b : 0;

    private static double Signed(double size, double sign) => sign < 0 ? -size : size;
}
