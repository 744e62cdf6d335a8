namespace Gjk.Bench.Baseline;

/// <summary>Muratori's cases (2006). The newest vertex, A, is the last of the list. The origin cannot lie behind the
/// older ones. Each case leaves the part of the simplex that faces the origin, and a direction from that part to the
/// origin.</summary>
public static class NextSimplex
{
    /// <summary>True when the simplex encloses the origin.</summary>
    public static bool Update(List<MinkowskiPoint> simplex, ref Vector3 direction) => simplex.Count switch
    {
        2 => Line(simplex, ref direction),
        3 => Triangle(simplex, ref direction),
        _ => Tetrahedron(simplex, ref direction),
    };

    private static bool Line(List<MinkowskiPoint> simplex, ref Vector3 direction)
    {
        MinkowskiPoint a = simplex[1], b = simplex[0];
        Vector3 ab = b.W - a.W, ao = -a.W;
        if (Faces(ab, ao))
        {
            direction = Vector3.Cross(Vector3.Cross(ab, ao), ab);
        }
        else
        {
            Keep(simplex, a);
            direction = ao;
        }

        return false;
    }

    private static bool Triangle(List<MinkowskiPoint> simplex, ref Vector3 direction)
    {
        MinkowskiPoint a = simplex[2], b = simplex[1], c = simplex[0];
        Vector3 ab = b.W - a.W, ac = c.W - a.W, ao = -a.W;
        Vector3 normal = Vector3.Cross(ab, ac);
        if (Faces(Vector3.Cross(normal, ac), ao))
        {
            if (!Faces(ac, ao)) return Edge(simplex, a, b, ref direction);
            Keep(simplex, c, a);
            direction = Vector3.Cross(Vector3.Cross(ac, ao), ac);
            return false;
        }

        if (Faces(Vector3.Cross(ab, normal), ao)) return Edge(simplex, a, b, ref direction);
        if (Faces(normal, ao))
        {
            direction = normal;
        }
        else
        {
            Keep(simplex, b, c, a);
            direction = -normal;
        }

        return false;
    }

    private static bool Tetrahedron(List<MinkowskiPoint> simplex, ref Vector3 direction)
    {
        MinkowskiPoint a = simplex[3], b = simplex[2], c = simplex[1], d = simplex[0];
        Vector3 ab = b.W - a.W, ac = c.W - a.W, ad = d.W - a.W, ao = -a.W;
        if (Faces(Vector3.Cross(ab, ac), ao)) Keep(simplex, c, b, a);
        else if (Faces(Vector3.Cross(ac, ad), ao)) Keep(simplex, d, c, a);
        else if (Faces(Vector3.Cross(ad, ab), ao)) Keep(simplex, b, d, a);
        else return true;
        return Triangle(simplex, ref direction);
    }

    private static bool Edge(
        List<MinkowskiPoint> simplex, in MinkowskiPoint a, in MinkowskiPoint b, ref Vector3 direction)
    {
        Keep(simplex, b, a);
        return Line(simplex, ref direction);
    }

    private static bool Faces(Vector3 direction, Vector3 toOrigin) => Vector3.Dot(direction, toOrigin) > 0;

    private static void Keep(List<MinkowskiPoint> simplex, in MinkowskiPoint only)
    {
        simplex.Clear();
        simplex.Add(only);
    }

    private static void Keep(List<MinkowskiPoint> simplex, in MinkowskiPoint older, in MinkowskiPoint newest)
    {
        simplex.Clear();
        simplex.Add(older);
        simplex.Add(newest);
    }

    private static void Keep(
        List<MinkowskiPoint> simplex, in MinkowskiPoint oldest, in MinkowskiPoint older, in MinkowskiPoint newest)
    {
        simplex.Clear();
        simplex.Add(oldest);
        simplex.Add(older);
        simplex.Add(newest);
    }
}
