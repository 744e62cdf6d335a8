namespace Gjk.Core;

/// <summary>The support function of the Minkowski difference: the two shapes intersect exactly when A - B holds the
/// origin, and its point nearest the origin is the vector between the closest points (Gilbert, Johnson and Keerthi
/// 1988).</summary>
internal static partial class MinkowskiDifference
{
    /// <summary>The vertex of A - B that lies furthest against <paramref name="normal"/>, that is nearest the origin
    /// along it: A's furthest point against the normal less B's furthest point along it.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="frame">Where B is, seen from A.</param>
    /// <param name="normal">In A's frame, of any length.</param>
    /// <param name="simplex">Gets the vertex, with the support points that it is made from and their ids.</param>
    /// <param name="slot">Where in the simplex.</param>
    /// <param name="w">The vertex: A's support point less B's, in A's frame.</param>
    /// <returns>Both ids in one: negative where a support point has none.</returns>
    [MethodImpl(Jit.Step)]
    public static int Support<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in Double3 normal, ref Simplex simplex, int slot, out Double3 w)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
#if NET
        if (HaveLanes<TA, TB>()) return SupportInLanes(ref a, ref b, frame, normal, ref simplex, slot, out w);
#endif
        Double3.Write(-normal.X, -normal.Y, -normal.Z, out Double3 direction);
        int idA = a.Support(direction, out Double3 onA);
        frame.Rotation.InverseRotate(normal, out direction);
        int idB = b.Support(direction, out Double3 onB);
        SetVertex(frame, onA, onB, out w);
        simplex.Fill(slot, w, onA, onB, idA, idB);
        return idA | idB;
    }

    /// <summary>The same for a search that needs no support points.</summary>
    [MethodImpl(Jit.Step)]
    public static int Support<TA, TB>(ref TA a, ref TB b, in PairFrame frame, in Double3 normal, out Double3 w)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
#if NET
        if (HaveLanes<TA, TB>()) return SupportInLanes(ref a, ref b, frame, normal, out w);
#endif
        Double3.Write(-normal.X, -normal.Y, -normal.Z, out Double3 direction);
        int ids = a.Support(direction, out Double3 onA);
        frame.Rotation.InverseRotate(normal, out direction);
        ids |= b.Support(direction, out Double3 onB);
        SetVertex(frame, onA, onB, out w);
        return ids;
    }

    /// <summary>The vertex that is furthest along a direction, for a polytope.</summary>
    [MethodImpl(Jit.Step)]
    public static unsafe void Support<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in Double3 direction, PolytopeVertex* vertex)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
#if NET
        if (HaveLanes<TA, TB>())
        {
            SupportInLanes(ref a, ref b, frame, direction, vertex);
            return;
        }
#endif
        Double3.Write(-direction.X, -direction.Y, -direction.Z, out Double3 normal);
        vertex->IdA = a.Support(direction, out vertex->OnA);
        frame.Rotation.InverseRotate(normal, out normal);
        vertex->IdB = b.Support(normal, out vertex->OnB);
        SetVertex(frame, vertex->OnA, vertex->OnB, out vertex->W);
    }

    /// <summary>Puts the vertex made of two support points, where they are now, into a slot.</summary>
    /// <returns>False when a shape has no vertex with the id.</returns>
    [MethodImpl(Jit.Step)]
    public static bool TryPlace<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, int idA, int idB, ref Simplex simplex, int slot)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
#if NET
        if (HaveLanes<TA, TB>()) return TryPlaceLanes(ref a, ref b, frame, idA, idB, ref simplex, slot);
#endif
        if (!a.TryGetVertex(idA, out Double3 onA) | !b.TryGetVertex(idB, out Double3 onB)) return false;
        SetVertex(frame, onA, onB, out Double3 w);
        simplex.Fill(slot, w, onA, onB, idA, idB);
        return true;
    }

    /// <summary>Brings the vertices of a simplex to where the frame's translation has them now.</summary>
    public static void Move(in PairFrame frame, ref Simplex simplex)
    {
        for (int i = 0; i < simplex.Count; i++)
        {
            int slot = simplex[i];
            Double3 onA = simplex.OnA(slot), onB = simplex.OnB(slot);
            SetVertex(frame, onA, onB, out Double3 w);
            simplex.Fill(slot, w, onA, onB, simplex.IdA(slot), simplex.IdB(slot));
        }
    }

    /// <summary>The vertex made of a point of each shape, measured from its centre in its own axes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void SetVertex(in PairFrame frame, in Double3 onA, in Double3 onB, out Double3 w)
    {
        frame.Rotation.Rotate(onB, out double x, out double y, out double z);
        Double3.Write(
            onA.X - (x + frame.Translation.X), onA.Y - (y + frame.Translation.Y), onA.Z - (z + frame.Translation.Z),
            out w);
    }
}
