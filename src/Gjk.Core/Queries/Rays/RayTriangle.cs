using System;

namespace Gjk.Core;

/// <summary>
/// A line against a triangle: it passes through where the three volumes that it spans with the edges have one sign
/// (Ericson 2005, section 5.3.4).
/// </summary>
internal static class RayTriangle
{
    /// <summary>
    /// Sine: a line that is less steep to the triangle's plane is cast instead, and so is one to a triangle that is
    /// this much thinner than long: there a volume in double has too few digits. Pinned by RayAccuracyTests.
    /// </summary>
    private const double LeastSine = 1e-5;

    /// <summary>Whether the triangle and the line are far enough from flat.</summary>
    public static bool IsFit(in LocalRay ray, in Vector3D a, in Vector3D b, in Vector3D c, out Vector3D normal)
    {
        Vector3D ab = b - a, ac = c - a;
        normal = Vector3D.Cross(ab, ac);
        double square = normal.LengthSquared, longest = Math.Max(ab.LengthSquared, ac.LengthSquared);
        double along = Vector3D.Dot(normal, ray.Direction);
        return along * along > LeastSine * LeastSine * square && square > LeastSine * LeastSine * longest * longest;
    }

    /// <summary>The line enters and leaves at one point.</summary>
    public static bool TryFind(
        in LocalRay ray, in Vector3D a, in Vector3D b, in Vector3D c, in Vector3D normal, out RaySpan span)
    {
        Vector3D toA = a - ray.Foot, toB = b - ray.Foot, toC = c - ray.Foot;
        double u = Volume(ray.Direction, toC, toB), v = Volume(ray.Direction, toA, toC);
        double w = Volume(ray.Direction, toB, toA), along = Vector3D.Dot(normal, ray.Direction);
        span.Enter = span.Exit = Vector3D.Dot(normal, toA) / along;
        span.Normal = along > 0 ? -normal : normal;
        span.IsClose = false;
        return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    }

    private static double Volume(in Vector3D direction, in Vector3D p, in Vector3D q) =>
        Vector3D.Dot(direction, Vector3D.Cross(p, q));
}
