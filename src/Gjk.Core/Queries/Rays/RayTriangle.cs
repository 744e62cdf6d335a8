namespace Gjk.Core;

/// <summary>A line against a triangle: it passes through where the three volumes that it spans with the edges have one
/// sign (Ericson 2005, section 5.3.4).</summary>
internal static class RayTriangle
{
    /// <summary>Sine: a line that is less steep to the triangle's plane is cast instead, and so is one to a triangle
    /// that is this much thinner than long: there a volume in double has too few digits. Pinned by
    /// RayAccuracyTests.</summary>
    private const double LeastSine = 1e-5;

    /// <summary>Ratio to the triangle's width, 2^-32, and to its longest side, 2^-48: a line that passes beside an edge
    /// by less goes through it. So what rounding does to a line through an edge that two triangles share, and to the
    /// place from which each measures it, leaves no hole between them, and the closed triangle is missed by no line
    /// that meets it. To a line that is flat to the edge they allow more, which <see cref="Graze"/> limits. Pinned by
    /// RaySeamTests.</summary>
    private const double BesideWide = 1.0 / (1L << 32), BesideLong = 1.0 / (1L << 48);

    /// <summary>Ratio to the longest side, 2^-31: a line that passes further away from all edges misses. The longest
    /// side is at most the root of 3 times the scale, so this is below the 1e-9 of the scale within which hit and miss
    /// are open. Pinned by TriangleEdgeRayTests, from above; four times less is still more than rounding does to the
    /// volume of the flattest line, 1e-10 of the side.</summary>
    private const double Graze = 1.0 / (1L << 31);

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
        if ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) return true;
        if (!IsOnEdge(ray.Direction, b - c, c - a, a - b, normal, u, v, w, out double least)) return false;

        // A flat line may be between all edges but for rounding, and yet cross the plane far beside the edge that it
        // passes, where another triangle is; or pass a sharp corner far out, between its edges.
        return TryPass(ray.Direction, toB, toC, ref least, ref span)
            | TryPass(ray.Direction, toC, toA, ref least, ref span)
            | TryPass(ray.Direction, toA, toB, ref least, ref span);
    }

    /// <summary>Where a line is nearest to an edge (Ericson 2005, section 5.1.9), if it passes it more closely than all
    /// before.</summary>
    private static bool TryPass(
        in Double3 direction, in Double3 toStart, in Double3 toEnd, ref double least, ref RaySpan span)
    {
        Double3 edge = toEnd - toStart, across = Double3.Cross(direction, edge);
        double along = Double3.Dot(Double3.Cross(toStart, direction), across) / across.LengthSquared;
        Double3 nearest = toStart + edge * Math.Min(Math.Max(along, 0), 1);
        double passed = Double3.Dot(nearest, direction) / direction.LengthSquared;
        double beside = (nearest - direction * passed).Length;
        if (!(beside < least)) return false;
        least = beside;
        span.Enter = span.Exit = passed;
        return true;
    }

    /// <summary>Whether the volumes have one sign but for those of edges that the line passes closely, or flatly: a
    /// volume is the distance from the edge times the sine between line and edge.</summary>
    private static bool IsOnEdge(
        in Double3 direction, in Double3 bc, in Double3 ca, in Double3 ab, in Double3 normal, double u, double v,
        double w, out double graze)
    {
        double p = bc.Length, q = ca.Length, r = ab.Length, longest = Math.Max(Math.Max(p, q), r);
        double beside = direction.Length * (BesideWide * normal.Length / longest + BesideLong * longest);
        (p, q, r) = (p * beside, q * beside, r * beside);
        graze = Graze * longest;
        return (u >= -p && v >= -q && w >= -r) || (u <= p && v <= q && w <= r);
    }

    private static double Volume(in Double3 direction, in Double3 p, in Double3 q) =>
        Double3.Dot(direction, Double3.Cross(p, q));
}
