namespace Gjk.Core;

/// <summary>A line against an ellipsoid: divided by the radii it is a line against the unit ball, with the same
/// parameter.</summary>
internal static class RayEllipsoid
{
    public static bool TryFind(in LocalRay ray, in Double3 radii, out RaySpan span)
    {
        var inverse = new Double3(1 / radii.X, 1 / radii.Y, 1 / radii.Z);
        bool found = RayBall.TryFind(
            Double3.Multiply(ray.Foot, inverse), Double3.Multiply(ray.Direction, inverse), 1, out span);
        span.Normal = Double3.Multiply(span.Normal, inverse);
        return found;
    }
}
