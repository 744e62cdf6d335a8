namespace Gjk.Core;

/// <summary>The vertex of a hull that is furthest in a direction: the lowest index among those whose dot product, in double, is largest.</summary>
internal static class HullSupport
{
    public static int Find(ConvexHull hull, in Vector3D direction, int hint) => Scan(hull, direction);

    /// <summary>The definition that every faster way must agree with.</summary>
    public static int Scan(ConvexHull hull, in Vector3D direction)
    {
        float[] xs = hull.X, ys = hull.Y, zs = hull.Z;
        double dx = direction.X, dy = direction.Y, dz = direction.Z;
        int best = 0;
        double bestDot = double.NegativeInfinity;
        for (int i = 0; i < hull.VertexCount; i++)
        {
            double dot = dx * xs[i] + dy * ys[i] + dz * zs[i];
            if (dot > bestDot)
            {
                bestDot = dot;
                best = i;
            }
        }

        return best;
    }
}
