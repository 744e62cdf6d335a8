namespace Gjk.Core;

/// <summary>What an expanded polytope says about the end of the way out.</summary>
internal static class PolytopeEnd
{
    /// <summary>The face that holds a point of the surface: where the way out ends, or the one that is nearest to it.
    /// Any may be: those of a facet are turned against each other where needles are among them, and where margins are
    /// deep and a core is thinner than they are rounded by, both of its sides cost the same.</summary>
    /// <param name="polytope">The surface.</param>
    /// <param name="best">A face in the plane of the facet, or near it.</param>
    /// <param name="normal">The direction of the way out, of unit length.</param>
    /// <param name="height">Its length.</param>
    /// <param name="noise">Length: what rounding leaves open.</param>
    public static int FaceUnder(in Polytope polytope, int best, in Double3 normal, double height, double noise)
    {
        Double3 point = normal * height;
        double least = DistanceSquared(polytope, best, point);
        for (int i = 0; i < polytope.FaceCount && least > noise * noise; i++)
        {
            if (!polytope.IsThere(i)) continue;
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

    /// <summary>From the point to the face, squared.</summary>
    private static unsafe double DistanceSquared(in Polytope polytope, int face, in Double3 point)
    {
        ref PolytopeFace f = ref polytope.Face(face);
        Double3 p = polytope.Vertex(f.Vertices[0]).W - point, q = polytope.Vertex(f.Vertices[1]).W - point;
        Double3 r = polytope.Vertex(f.Vertices[2]).W - point;
        return ClosestPointWeights.Triangle(p, q, r).PointOf(p, q, r, default).LengthSquared;
    }
}
