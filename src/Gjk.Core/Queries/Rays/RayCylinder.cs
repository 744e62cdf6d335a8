namespace Gjk.Core;

/// <summary>A line against a cylinder about the y axis: its infinite side, cut by a slab (Ericson 2005, section 5.3.7;
/// Eberly, "Intersection of a Line and a Cylinder", 2014).</summary>
internal static class RayCylinder
{
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
        double fx = foot.X, fz = foot.Z, dx = direction.X, dz = direction.Z;
        double a = dx * dx + dz * dz, b = fx * dx + fz * dz, cross = fx * dz - fz * dx;
        double c = fx * fx + fz * fz - radius * radius;
        span = RaySpan.Everything;
        if (!TryCutSide(a, b, c, cross, radius, ref span)) return false;
        span.IsClose |= RayGraze.IsAlongSide(a, c, direction, radius, radius + halfHeight);
        Double3 entry = foot + direction * span.Enter;
        span.Normal = new Double3(entry.X, 0, entry.Z);
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
