using System.Numerics;

namespace Gjk.Demo.Trace;

/// <summary>Muratori's cases (2006), in float. The newest vertex, A, is the last of the list, and the origin is taken
/// to lie nowhere behind the older ones. Each case leaves the part of the simplex that faces the origin.</summary>
internal static class TextbookSimplex
{
    /// <summary>True when the simplex seems to hold the origin.</summary>
    public static bool Reduce(List<TextbookVertex> simplex)
    {
        switch (simplex.Count)
        {
            case 2:
                Line(simplex);
                return false;
            case 3:
                Triangle(simplex);
                return false;
            case 4:
                return Tetrahedron(simplex);
            default:
                return false;
        }
    }

    private static void Line(List<TextbookVertex> simplex)
    {
        TextbookVertex a = simplex[1];
        if (!Faces(simplex[0].W - a.W, -a.W)) Keep(simplex, a);
    }

    private static void Triangle(List<TextbookVertex> simplex)
    {
        TextbookVertex a = simplex[2], b = simplex[1], c = simplex[0];
        Vector3 ab = b.W - a.W, ac = c.W - a.W, toOrigin = -a.W, normal = TextbookMath.Cross(ab, ac);
        bool beyondAC = Faces(TextbookMath.Cross(normal, ac), toOrigin);
        bool beyondAB = Faces(TextbookMath.Cross(ab, normal), toOrigin);
        if (beyondAC && Faces(ac, toOrigin))
        {
            Keep(simplex, c, a);
        }
        else if (beyondAC || beyondAB)
        {
            Keep(simplex, b, a);
            Line(simplex);
        }
        else if (!Faces(normal, toOrigin))
        {
            // The origin is below: wound the other way, it is above.
            Keep(simplex, b, c, a);
        }
    }

    private static bool Tetrahedron(List<TextbookVertex> simplex)
    {
        TextbookVertex a = simplex[3], b = simplex[2], c = simplex[1], d = simplex[0];
        Vector3 ab = b.W - a.W, ac = c.W - a.W, ad = d.W - a.W, toOrigin = -a.W;
        if (Faces(TextbookMath.Cross(ab, ac), toOrigin)) Keep(simplex, c, b, a);
        else if (Faces(TextbookMath.Cross(ac, ad), toOrigin)) Keep(simplex, d, c, a);
        else if (Faces(TextbookMath.Cross(ad, ab), toOrigin)) Keep(simplex, b, d, a);
        else return true;
        Triangle(simplex);
        return false;
    }

    private static bool Faces(Vector3 direction, Vector3 toOrigin) => TextbookMath.Dot(direction, toOrigin) > 0;

    private static void Keep(List<TextbookVertex> simplex, params TextbookVertex[] kept)
    {
        simplex.Clear();
        simplex.AddRange(kept);
    }
}
