namespace Gjk.Core;

/// <summary>A line against a capsule (Ericson 2005, section 5.3.7): where it crosses the infinite side beside the
/// segment, there it crosses the capsule; where it crosses the side beyond an end, it does so in the ball about that
/// end.</summary>
internal static class RayCapsule
{
    /// <summary>The line need not be measured from its foot, nor be of unit direction.</summary>
    /// <param name="foot">The line's point at the parameter 0, from the segment's middle.</param>
    /// <param name="direction">Its direction.</param>
    /// <param name="first">One end, from the middle.</param>
    /// <param name="second">The other end.</param>
    /// <param name="radius">Above 0.</param>
    /// <param name="span">The part of the line in the capsule.</param>
    /// <returns>False where it misses.</returns>
    public static bool TryFind(
        in Double3 foot, in Double3 direction, in Double3 first, in Double3 second, double radius,
        out RaySpan span)
    {
        Double3 toFirst = first - second;
        double length = toFirst.Length, half = length * 0.5;
        if (!(length > 0)) return RayBall.TryFind(foot, direction, radius, out span);
        var axis = new Double3(toFirst.X / length, toFirst.Y / length, toFirst.Z / length);
        if (!TryFindSide(foot, direction, axis, radius, half, out span)) return false;
        double footAlong = Double3.Dot(foot, axis), along = Double3.Dot(direction, axis);
        double enterAlong = At(span.Enter), exitAlong = At(span.Exit);
        if (Math.Abs(enterAlong) <= half)
        {
            Double3 entry = foot + direction * span.Enter;
            span.Normal = entry - axis * Double3.Dot(entry, axis);
        }
        else
        {
            if (!RayBall.TryFind(foot - (enterAlong > 0 ? first : second), direction, radius, out RaySpan ball))
                return false;
            span.Enter = ball.Enter;
            span.Normal = ball.Normal;
            span.IsClose |= ball.IsClose;
        }

        if (Math.Abs(exitAlong) <= half) return true;
        bool found = RayBall.TryFind(foot - (exitAlong > 0 ? first : second), direction, radius, out RaySpan end);
        span.Exit = Math.Max(end.Exit, span.Enter);
        return found;

        double At(double t) => footAlong + along * t;
    }

    /// <summary>The infinite cylinder about an axis.</summary>
    private static bool TryFindSide(
        in Double3 foot, in Double3 direction, in Double3 axis, double radius, double half, out RaySpan span)
    {
        Double3 f = foot - axis * Double3.Dot(foot, axis), d = direction - axis * Double3.Dot(direction, axis);
        double a = d.LengthSquared, c = f.LengthSquared - radius * radius;
        double cross = Double3.Dot(axis, Double3.Cross(foot, direction));
        span = RaySpan.Everything;
        if (!RayCylinder.TryCutSide(a, Double3.Dot(f, d), c, cross, radius, ref span)) return false;
        span.IsClose |= RayGraze.IsAlongSide(a, c, direction, radius, radius + half);
        return true;
    }
}
