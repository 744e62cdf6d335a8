namespace Gjk.Core;

/// <summary>The support function of the Minkowski difference: the two shapes intersect exactly when A - B holds the
/// origin, and its point nearest the origin is the vector between the closest points (Gilbert, Johnson and Keerthi
/// 1988).</summary>
internal static class MinkowskiDifference
{
    /// <summary>The vertex of A - B that lies furthest against <paramref name="normal"/>, that is nearest the origin
    /// along it: A's furthest point against the normal less B's furthest point along it.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="frame">Where B is, seen from A.</param>
    /// <param name="normal">In A's frame, of any length.</param>
    /// <param name="vertex">Gets the vertex, with the support points that it is made from and their ids.</param>
    /// <param name="w">The vertex: A's support point less B's, in A's frame.</param>
    /// <returns>Both ids in one: negative where a support point has none.</returns>
    [MethodImpl(Jit.Step)]
    public static int Support<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in Double3 normal, ref DifferenceVertex vertex, out Double3 w)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        normal.Opposite(out Xyz direction);
        int idA = XyzSupport.Furthest(ref a, direction, out Xyz onA);
        frame.Inverse.Rotate(normal, out direction);
        int idB = XyzSupport.Furthest(ref b, direction, out Xyz onB);
        frame.Between(onA, onB, out w);
        vertex.Set(w, onA, onB, idA, idB);
        return idA | idB;
    }

    /// <summary>The same for a search that needs no support points.</summary>
    [MethodImpl(Jit.Step)]
    public static int Support<TA, TB>(ref TA a, ref TB b, in PairFrame frame, in Double3 normal, out Double3 w)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        normal.Opposite(out Xyz direction);
        int idA = XyzSupport.Furthest(ref a, direction, out Xyz onA);
        frame.Inverse.Rotate(normal, out direction);
        int idB = XyzSupport.Furthest(ref b, direction, out Xyz onB);
        frame.Between(onA, onB, out w);
        return idA | idB;
    }

    /// <summary>Makes the vertex of two shape vertices, given by their ids, at the present frame.</summary>
    /// <returns>False when a shape has no vertex with the id.</returns>
    [MethodImpl(Jit.Step)]
    public static bool TryMakeVertex<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, int idA, int idB, ref DifferenceVertex vertex)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        bool found = XyzSupport.TryGet(ref a, idA, out Xyz onA) & XyzSupport.TryGet(ref b, idB, out Xyz onB);
        frame.Between(onA, onB, out Double3 w);
        vertex.Set(w, onA, onB, idA, idB);
        return found;
    }

    /// <summary>Computes the vertices of a simplex anew for the frame's translation.</summary>
    public static void Retranslate(in PairFrame frame, ref Simplex simplex)
    {
        for (int i = 0; i < simplex.Count; i++)
        {
            ref DifferenceVertex vertex = ref simplex.At(simplex[i]);
            frame.Between(vertex.OnA.ToXyz(), vertex.OnB.ToXyz(), out vertex.W);
        }
    }
}
