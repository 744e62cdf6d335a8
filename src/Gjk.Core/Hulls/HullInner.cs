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
        double least = hull.BoundingRadius;
        for (int i = 0; i < hull.TriangleCount; i++)
        {
            Double3 normal = HullPlanes.Normal(hull, i, out Double3 corner);
            least = Math.Min(least, Double3.Dot(normal, corner) / normal.Length);
        }

        return least * (least > 0 ? RoundingDown : 2 - RoundingDown);
    }
}
