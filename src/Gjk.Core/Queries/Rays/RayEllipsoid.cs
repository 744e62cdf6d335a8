namespace Gjk.Core;

/// <summary>
/// A line against an ellipsoid: divided by the radii it is a line against the unit ball, with the same parameter.
/// </summary>
internal static class RayEllipsoid
{
    public static bool TryFind(in LocalRay ray, in Vector3D radii, out RaySpan span)
    {
        var inverse = new Vector3D(1 / radii.X, 1 / radii.Y, 1 / radii.Z);
        bool found = RayBall.TryFind(
            Vector3D.Multiply(ray.Foot, inverse), Vector3D.Multiply(ray.Direction, inverse), 1, out span);
        span.Normal = Vector3D.Multiply(span.Normal, inverse);
        return found;
    }
}
