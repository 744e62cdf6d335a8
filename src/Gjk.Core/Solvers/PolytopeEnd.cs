namespace Gjk.Core;

/// <summary>What an expanded polytope says about the end of the way out.</summary>
internal static class PolytopeEnd
{
    /// <summary>
    /// The face that holds a point of the surface: where the way out ends. Of a facet of many triangles it is the one
    /// whose nearest point to the origin is that point.
    /// </summary>
    /// <param name="polytope">Of which a face has about the height of the point.</param>
    /// <param name="point">The end of the way out, from the origin and perpendicular to the facet.</param>
    /// <param name="noise">Length: what rounding leaves open.</param>
    public static int FaceUnder(in Polytope polytope, in Vector3D point, double noise)
    {
        int best = polytope.Lowest(out _);
        double least = DistanceSquared(polytope, best, point);
        for (int i = 0; i < polytope.FaceCount && least > noise * noise; i++)
        {
            if (!polytope.IsThere(i) || !IsLevel(polytope, i, point)) continue;
            double squared = DistanceSquared(polytope, i, point);
            if (!(squared < least)) continue;
            least = squared;
            best = i;
        }

        return best;
    }

    /// <summary>Makes a simplex of a face's vertices.</summary>
    public static unsafe void Copy(in Polytope polytope, int face, ref Simplex simplex)
    {
        for (int k = 0; k < 3; k++)
        {
            ref PolytopeVertex vertex = ref polytope.Vertex(polytope.Face(face).Vertices[k]);
            simplex.Fill(k, vertex.W, vertex.OnA, vertex.OnB, vertex.IdA, vertex.IdB);
        }

        simplex.Select(3, 0, 1, 2, 0);
    }

    /// <summary>Whether a face may lie in the plane through the point: within some degrees.</summary>
    private static bool IsLevel(in Polytope polytope, int face, in Vector3D point)
    {
        double along = Vector3D.Dot(polytope.Face(face).Normal, point);
        return along > 0 && along * along > 0.99 * point.LengthSquared;
    }

    /// <summary>From the point to the face, squared.</summary>
    private static unsafe double DistanceSquared(in Polytope polytope, int face, in Vector3D point)
    {
        ref PolytopeFace f = ref polytope.Face(face);
        Vector3D p = polytope.Vertex(f.Vertices[0]).W - point, q = polytope.Vertex(f.Vertices[1]).W - point;
        Vector3D r = polytope.Vertex(f.Vertices[2]).W - point;
        return ClosestPointWeights.Triangle(p, q, r).PointOf(p, q, r, default).LengthSquared;
    }
}
