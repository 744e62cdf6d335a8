namespace Gjk.Bench.Baseline;

/// <summary>Finds the point of a vertex, line or triangle that is closest to the origin, by barycentric weights (Catto
/// 2010; Ericson 2004, 5.1.5). The same weights give the points of both colliders.</summary>
public static class ClosestPoint
{
    public static Vector3 Find(List<MinkowskiPoint> simplex, out Vector3 pointA, out Vector3 pointB)
    {
        if (simplex.Count == 1)
        {
            pointA = simplex[0].OnA;
            pointB = simplex[0].OnB;
            return simplex[0].W;
        }

        Vector3 weights = simplex.Count == 2
            ? Segment(simplex[0].W, simplex[1].W)
            : Triangle(simplex[0].W, simplex[1].W, simplex[2].W);
        MinkowskiPoint a = simplex[0], b = simplex[1], c = simplex[simplex.Count - 1];
        pointA = weights.X * a.OnA + weights.Y * b.OnA + weights.Z * c.OnA;
        pointB = weights.X * a.OnB + weights.Y * b.OnB + weights.Z * c.OnB;
        return weights.X * a.W + weights.Y * b.W + weights.Z * c.W;
    }

    private static Vector3 Segment(Vector3 a, Vector3 b)
    {
        Vector3 ab = b - a;
        float t = Math.Min(Math.Max(Vector3.Dot(-a, ab) / Vector3.Dot(ab, ab), 0), 1);
        return new Vector3(1 - t, t, 0);
    }

    private static Vector3 Triangle(Vector3 a, Vector3 b, Vector3 c)
    {
        Vector3 ab = b - a, ac = c - a;
        float d1 = Vector3.Dot(ab, -a), d2 = Vector3.Dot(ac, -a);
        if (d1 <= 0 && d2 <= 0) return new Vector3(1, 0, 0);

        float d3 = Vector3.Dot(ab, -b), d4 = Vector3.Dot(ac, -b);
        if (d3 >= 0 && d4 <= d3) return new Vector3(0, 1, 0);

        float vc = d1 * d4 - d3 * d2;
        if (vc <= 0 && d1 >= 0 && d3 <= 0)
        {
            float v = d1 / (d1 - d3);
            return new Vector3(1 - v, v, 0);
        }

        float d5 = Vector3.Dot(ab, -c), d6 = Vector3.Dot(ac, -c);
        if (d6 >= 0 && d5 <= d6) return new Vector3(0, 0, 1);

        float vb = d5 * d2 - d1 * d6;
        if (vb <= 0 && d2 >= 0 && d6 <= 0)
        {
            float w = d2 / (d2 - d6);
            return new Vector3(1 - w, 0, w);
        }

        float va = d3 * d6 - d5 * d4;
        if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
        {
            float w = (d4 - d3) / (d4 - d3 + (d5 - d6));
            return new Vector3(0, 1 - w, w);
        }

        float scale = 1 / (va + vb + vc);
        return new Vector3(va * scale, vb * scale, vc * scale);
    }
}
