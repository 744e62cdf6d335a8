namespace Gjk.Core;

/// <summary>A line against a cylinder about the y axis: its infinite side, cut by a slab (Ericson 2005, section 5.3.7;
/// Eberly, "Intersection of a Line and a Cylinder", 2014).</summary>
internal static class RayCylinder
{
    /// <summary>Ratio of the foot's distance from the axis to the radius, 2^16: further away, the line is measured from
    /// its point nearest to the axis. Up to it rounding moves the entry by 2^-37 of the radius, which is below 1e-6 of
    /// the shortest half chord that is no tangent: that is what turns the normal of a flattened cylinder. Less only
    /// costs time, and four times more is seen by the shortest chords alone. Pinned by FlatCylinderRayTests.</summary>
    private const double FarFoot = 1 << 16;

    /// <summary>The line need not be measured from its foot, nor be of unit direction.</summary>
    /// <param name="foot">The line's point at the parameter 0, from the centre.</param>
    /// <param name="direction">Its direction.</param>
    /// <param name="radius">Above 0.</param>
    /// <param name="halfHeight">At least 0.</param>
    /// <param name="span">The part of the line in the cylinder.</param>
    /// <returns>False where it misses.</returns>
    public static bool TryFind(
        in Double3 foot, in Double3 direction, double radius, double halfHeight, out RaySpan span)
    {
        Double3 f = new(foot.X, 0, foot.Z), d = new(direction.X, 0, direction.Z);
        double a = d.LengthSquared, shift = 0;
        if (a > 0 && f.LengthSquared > FarFoot * FarFoot * radius * radius) shift = LocalRay.MoveToFoot(ref f, d);
        double b = f.X * d.X + f.Z * d.Z, cross = f.X * d.Z - f.Z * d.X;
        double c = f.X * f.X + f.Z * f.Z - radius * radius;
        span = RaySpan.Everything;
        if (!TryCutSide(a, b, c, cross, radius, ref span)) return false;
        span.IsClose |= RayGraze.IsAlongSide(a, c, direction, radius, radius + halfHeight);
        span.Normal = new Double3(f.X + d.X * span.Enter, 0, f.Z + d.Z * span.Enter);
        span.Move(shift);
        return span.Clip(halfHeight, foot.Y, direction.Y, new Double3(0, 1, 0));
    }

    /// <summary>The infinite cylinder: a circle in the plane across its axis. With f the foot and d the direction
    /// there, the discriminant is d² r² - (f × d)²: the line misses where its distance from the axis, |f × d| / |d|,
    /// exceeds r.</summary>
    /// <param name="a">d².</param>
    /// <param name="b">f · d.</param>
    /// <param name="c">f² - r².</param>
    /// <param name="cross">|f × d|, of either sign.</param>
    /// <param name="radius">r.</param>
    /// <param name="span">The whole line; cut.</param>
    public static bool TryCutSide(double a, double b, double c, double cross, double radius, ref RaySpan span)
    {
        double most = a * radius * radius, discriminant = most - cross * cross;
        span.IsClose = RayGraze.IsTangent(discriminant, most);
        if (!(discriminant >= 0)) return false;
        if (!RayQuadratic.TrySolve(a, b, c, discriminant, out double enter, out double exit)) return c <= 0;
        span.Enter = enter;
        span.Exit = exit;
        return true;
    }
}
