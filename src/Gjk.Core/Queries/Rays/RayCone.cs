namespace Gjk.Core;

/// <summary>A line against a cone about the y axis, its apex at the top: the infinite cone, cut by the plane of its
/// base and the one through the apex (Eberly, "Intersection of a Line and a Cone", 2000).</summary>
/// <remarks>With y counted down from the apex, and stretched by the radius over the height, the double cone is x² + z²
/// ≤ y²: a quadratic form of the line's point f + d t. Its discriminant is written by the minors of f and d, which do
/// not change when the line is measured from another of its points: mxy² + mzy² - mxz². Where the quadratic coefficient
/// is positive, the line is flatter than the side, and in the double cone between the roots; the cut by y ≥ 0 leaves
/// that of the lower one. Where it is negative, the line is steeper and passes through both: in the lower one from the
/// greater root on when it goes down, up to the lesser when it goes up. Where it is nothing, the line is parallel to a
/// side and cuts one of the two cones in a parabola: it stays inside from its only root on, or up to it.</remarks>
internal static class RayCone
{
    /// <summary>Ratio of the quadratic coefficient to its parts: 16 roundings, twice the most (proofs/cone-parallel.g).
    /// Below it, its sign says nothing, and what it adds within the cone is rounding. Pinned by RayConeTests.</summary>
    private const double Parallel = 16 * RoundOff.Unit;

    /// <summary>The line need not be measured from its foot, nor be of unit direction.</summary>
    /// <param name="foot">The line's point at the parameter 0, from the middle of the axis.</param>
    /// <param name="direction">Its direction.</param>
    /// <param name="radius">Of the base, above 0.</param>
    /// <param name="halfHeight">Above 0.</param>
    /// <param name="span">The part of the line in the cone.</param>
    /// <returns>False where it misses.</returns>
    public static bool TryFind(
        in Double3 foot, in Double3 direction, double radius, double halfHeight, out RaySpan span)
    {
        double k = radius / (2 * halfHeight);
        var f = new Double3(foot.X, k * (halfHeight - foot.Y), foot.Z);
        var d = new Double3(direction.X, -k * direction.Y, direction.Z);

        // From the point nearest to the apex, where the constant is as small as it can be.
        double shift = LocalRay.MoveToFoot(ref f, d);
        double mxy = f.X * d.Y - f.Y * d.X, mzy = f.Z * d.Y - f.Y * d.Z, mxz = f.X * d.Z - f.Z * d.X;
        double across = mxy * mxy + mzy * mzy, discriminant = across - mxz * mxz;
        double a = d.X * d.X + d.Z * d.Z - d.Y * d.Y, b = f.X * d.X + f.Z * d.Z - f.Y * d.Y;
        double c = f.X * f.X + f.Z * f.Z - f.Y * f.Y;
        span = RaySpan.Everything;
        span.IsClose = RayGraze.IsTangent(discriminant, across) || IsAlongSide(a, f, d, radius);
        if (Math.Abs(a) <= Parallel * (d.Y * d.Y))
        {
            if (b == 0 && c > 0) return false;
            if (b < 0) span.Enter = -c / (2 * b);
            if (b > 0) span.Exit = -c / (2 * b);
        }
        else
        {
            if (discriminant < 0 && a > 0) return false;
            RayQuadratic.TrySolve(a, b, c, Math.Max(discriminant, 0), out double least, out double most);
            if (a > 0) (span.Enter, span.Exit) = (least, most);
            else if (d.Y > 0) span.Enter = most;
            else span.Exit = least;
        }

        span.Normal = new Double3(f.X + d.X * span.Enter, k * (f.Y + d.Y * span.Enter), f.Z + d.Z * span.Enter);

        double apex = RoundOff.Unit * radius;
        if (!(span.Normal.LengthSquared > apex * apex)) span.Normal = ApexNormal(d, k);
        double middle = radius * 0.5;
        bool isLeft = span.Clip(middle, middle - f.Y, -d.Y, new Double3(0, 1, 0));
        span.Move(shift);
        return isLeft;
    }

    /// <summary>Of all directions that are normals at the apex, one that the line comes against: from above the axis,
    /// from below that of the side it comes from.</summary>
    private static Double3 ApexNormal(in Double3 d, double k)
    {
        double across = Math.Sqrt(d.X * d.X + d.Z * d.Z);
        return d.Y > 0 || across == 0
            ? new Double3(0, 1, 0)
            : new Double3(-d.X / across, k, -d.Z / across);
    }

    /// <summary>Whether the line runs along a side: such a line passes the apex closely.</summary>
    private static bool IsAlongSide(double a, in Double3 f, in Double3 d, double radius)
    {
        double slope = RayGraze.LeastSlope * d.LengthSquared;
        return Math.Abs(a) <= slope && f.LengthSquared <= RayGraze.LeastSlope * RayGraze.LeastSlope * radius * radius;
    }
}
