using Vector3 = System.Numerics.Vector3;

namespace Gjk.Demo.Trace;

/// <summary>The point of a vertex, an edge or a triangle nearest the origin, by barycentric weights (Ericson 2004,
/// section 5.1.5), in float.</summary>
internal static class TextbookClosestPoint
{
    /// <summary>The weights of the simplex's vertices, in their order. Those of vertices that it lacks are 0.</summary>
    public static Vector3 Weights<T>(List<T> simplex)
        where T : struct, ITextbookVertex => simplex.Count switch
        {
            1 => Vector3.UnitX,
            2 => OfEdge(simplex[0].W, simplex[1].W),
            _ => OfTriangle(simplex[0].W, simplex[1].W, simplex[2].W),
        };

    private static Vector3 OfEdge(Vector3 a, Vector3 b)
    {
        Vector3 ab = b - a;
        float t = Math.Min(Math.Max(TextbookMath.Dot(-a, ab) / TextbookMath.Dot(ab, ab), 0), 1);
        return new(1 - t, t, 0);
    }

    private static Vector3 OfTriangle(Vector3 a, Vector3 b, Vector3 c)
    {
        Vector3 ab = b - a, ac = c - a;
        float d1 = TextbookMath.Dot(ab, -a), d2 = TextbookMath.Dot(ac, -a);
        if (d1 <= 0 && d2 <= 0) return new(1, 0, 0);
        float d3 = TextbookMath.Dot(ab, -b), d4 = TextbookMath.Dot(ac, -b);
        if (d3 >= 0 && d4 <= d3) return new(0, 1, 0);
        float vc = d1 * d4 - d3 * d2;
        if (vc <= 0 && d1 >= 0 && d3 <= 0) return new(1 - d1 / (d1 - d3), d1 / (d1 - d3), 0);
        float d5 = TextbookMath.Dot(ab, -c), d6 = TextbookMath.Dot(ac, -c);
        if (d6 >= 0 && d5 <= d6) return new(0, 0, 1);
        float vb = d5 * d2 - d1 * d6;
        if (vb <= 0 && d2 >= 0 && d6 <= 0) return new(1 - d2 / (d2 - d6), 0, d2 / (d2 - d6));
        float va = d3 * d6 - d5 * d4, alongB = d4 - d3, alongC = d5 - d6;
        if (va <= 0 && alongB >= 0 && alongC >= 0)
            return new(0, alongC / (alongB + alongC), alongB / (alongB + alongC));
        float scale = 1 / (va + vb + vc);
        return new(va * scale, vb * scale, vc * scale);
    }
}
