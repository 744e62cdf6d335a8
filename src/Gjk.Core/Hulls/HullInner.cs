namespace Gjk.Core;

/// <summary>How large a ball about its centre a hull holds.</summary>
internal static class HullInner
{
    /// <summary>Ratio: more than the rounding of a plane takes away.</summary>
    private const double RoundingDown = 1 - 16 * RoundOff.Unit;

    /// <summary>The least distance of a facet's plane from the centre, rounded down; negative where the centre is
    /// outside, 0 for a flat hull.</summary>
    public static double Radius(ConvexHull hull)
    {
        if (hull.Dimension < 3) return 0;
        double least = hull.BoundingRadius, unit = 1 / PowerOfTwo.AtMost(least);
        for (int i = 0; i < hull.TriangleCount; i++)
        {
            hull.GetTriangle(i, out int a, out int b, out int c);
            hull.GetVertex(a, out Double3 origin);
            hull.GetVertex(b, out Double3 second);
            hull.GetVertex(c, out Double3 third);
            Double3 normal = VectorDD.Normal(origin * unit, second * unit, third * unit);
            least = Math.Min(least, Double3.Dot(normal, origin - hull.Center) / normal.Length);
        }

        return least * (least > 0 ? RoundingDown : 2 - RoundingDown);
    }
}
