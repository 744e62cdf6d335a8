namespace Gjk.Core;

/// <summary>A line against a ball (Ericson 2005, section 5.3.2).</summary>
internal static class RayBall
{
    /// <summary>A ball about the centre, with a ray that is measured from its foot: half the chord is √(r² -
    /// f²).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool TryFind(in LocalRay ray, double radius, out RaySpan span)
    {
        double squared = radius * radius - ray.Foot.LengthSquared;
        double half = Math.Sqrt(Math.Max(squared, 0));
        span.Enter = -half;
        span.Exit = half;
        span.Normal = ray.At(-half);
        span.IsClose = RayGraze.IsTangent(squared, radius * radius);
        return squared >= 0;
    }

    /// <summary>Any line against a ball somewhere: it is measured from the foot on that ball first.</summary>
    /// <param name="toFoot">From the ball's centre to the line's point at the parameter 0.</param>
    /// <param name="direction">Of any length.</param>
    /// <param name="radius">The radius.</param>
    /// <param name="span">The part of the line in the ball.</param>
    /// <returns>False where it misses.</returns>
    public static bool TryFind(in Double3 toFoot, in Double3 direction, double radius, out RaySpan span)
    {
        Double3 foot = toFoot;
        double middle = LocalRay.MoveToFoot(ref foot, direction);
        double squared = radius * radius - foot.LengthSquared;
        double half = Math.Sqrt(Math.Max(squared, 0) / direction.LengthSquared);
        span.Enter = middle - half;
        span.Exit = middle + half;
        span.Normal = foot - direction * half;
        span.IsClose = RayGraze.IsTangent(squared, radius * radius);
        return squared >= 0;
    }
}
