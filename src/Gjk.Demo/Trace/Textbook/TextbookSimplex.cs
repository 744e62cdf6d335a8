using Vector3 = System.Numerics.Vector3;

namespace Gjk.Demo.Trace;

/// <summary>A vertex of A - B.</summary>
internal interface ITextbookVertex
{
    Vector3 W { get; }
}

/// <summary>Muratori's cases (2006), in float. The newest vertex, A, is the last of the list, and the origin is taken
/// to lie nowhere behind the older ones. Each case leaves the part of the simplex that faces the origin, and a
/// direction from that part to the origin. The bench's baseline runs this, too.</summary>
internal static class TextbookSimplex<T>
    where T : struct, ITextbookVertex
{
    /// <summary>True when the simplex seems to hold the origin.</summary>
    public static bool Reduce(List<T> simplex, ref Vector3 direction) => simplex.Count switch
    {
        1 => Vertex(simplex, ref direction),
        2 => Line(simplex, ref direction),
        3 => Triangle(simplex, ref direction),
        _ => Tetrahedron(simplex, ref direction),
    };

    private static bool Vertex(List<T> simplex, ref Vector3 direction)
    {
        direction = -simplex[0].W;
        return false;
    }

    private static bool Line(List<T> simplex, ref Vector3 direction)
    {
        T a = simplex[1], b = simplex[0];
        Vector3 ab = b.W - a.W, ao = -a.W;
        if (Faces(ab, ao))
        {
            direction = TextbookMath.Cross(TextbookMath.Cross(ab, ao), ab);
        }
        else
        {
            Keep(simplex, a);
            direction = ao;
        }

        return false;
    }

    private static bool Triangle(List<T> simplex, ref Vector3 direction)
    {
        T a = simplex[2], b = simplex[1], c = simplex[0];
        Vector3 ab = b.W - a.W, ac = c.W - a.W, ao = -a.W;
        Vector3 normal = TextbookMath.Cross(ab, ac);
        if (Faces(TextbookMath.Cross(normal, ac), ao))
        {
            if (!Faces(ac, ao)) return Edge(simplex, a, b, ref direction);
            Keep(simplex, c, a);
            direction = TextbookMath.Cross(TextbookMath.Cross(ac, ao), ac);
            return false;
        }

        if (Faces(TextbookMath.Cross(ab, normal), ao)) return Edge(simplex, a, b, ref direction);
        if (Faces(normal, ao))
        {
            direction = normal;
        }
        else
        {
            // The origin is below: wound the other way, it is above.
            Keep(simplex, b, c, a);
            direction = -normal;
        }

        return false;
    }

    private static bool Tetrahedron(List<T> simplex, ref Vector3 direction)
    {
        T a = simplex[3], b = simplex[2], c = simplex[1], d = simplex[0];
        Vector3 ab = b.W - a.W, ac = c.W - a.W, ad = d.W - a.W, ao = -a.W;
        if (Faces(TextbookMath.Cross(ab, ac), ao)) Keep(simplex, c, b, a);
        else if (Faces(TextbookMath.Cross(ac, ad), ao)) Keep(simplex, d, c, a);
        else if (Faces(TextbookMath.Cross(ad, ab), ao)) Keep(simplex, b, d, a);
        else return true;
        return Triangle(simplex, ref direction);
    }

    private static bool Edge(
        List<T> simplex, in T a, in T b, ref Vector3 direction)
    {
        Keep(simplex, b, a);
        return Line(simplex, ref direction);
    }

    private static bool Faces(Vector3 direction, Vector3 toOrigin) => TextbookMath.Dot(direction, toOrigin) > 0;

    private static void Keep(List<T> simplex, in T only)
    {
        simplex.Clear();
        simplex.Add(only);
    }

    private static void Keep(List<T> simplex, in T older, in T newest)
    {
        simplex.Clear();
        simplex.Add(older);
        simplex.Add(newest);
    }

    private static void Keep(
        List<T> simplex, in T oldest, in T older, in T newest)
    {
        simplex.Clear();
        simplex.Add(oldest);
        simplex.Add(older);
        simplex.Add(newest);
    }
}
