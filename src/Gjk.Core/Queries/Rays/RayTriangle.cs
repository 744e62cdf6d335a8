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
    public static bool IsFit(in LocalRay ray, in Double3 a, in Double3 b, in Double3 c, out Double3 normal)
    {
        Double3 ab = b - a, ac = c - a;
        normal = Double3.Cross(ab, ac);
        double square = normal.LengthSquared, longest = Math.Max(ab.LengthSquared, ac.LengthSquared);
        double along = Double3.Dot(normal, ray.Direction);
        return along * along > LeastSine * LeastSine * square && square > LeastSine * LeastSine * longest * longest;
    }

    /// <summary>The line enters and leaves at one point.</summary>
    public static bool TryFind(
        in LocalRay ray, in Double3 a, in Double3 b, in Double3 c, in Double3 normal, out RaySpan span)
    {
        Double3 toA = a - ray.Foot, toB = b - ray.Foot, toC = c - ray.Foot;
        double u = Volume(ray.Direction, toC, toB), v = Volume(ray.Direction, toA, toC);
        double w = Volume(ray.Direction, toB, toA), along = Double3.Dot(normal, ray.Direction);
        span.Enter = span.Exit = Double3.Dot(normal, toA) / along;
        span.Normal = along > 0 ? -normal : normal;
        span.IsClose = false;
        return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    }

    private static double Volume(in Double3 direction, in Double3 p, in Double3 q) =>
        Double3.Dot(direction, Double3.Cross(p, q));
}
