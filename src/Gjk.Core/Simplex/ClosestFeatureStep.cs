using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// The step of the distance solver. It reduces a simplex to its feature (vertex, edge or face) nearest the origin and
/// gives that feature's normal, or finds the origin enclosed.
/// </summary>
/// <remarks>
/// The regions are Muratori's (2006), with the tests that he may leave out for the boolean put back (Ericson 2004,
/// section 5.1), because a distance needs the nearest feature and not just a good direction. The way GJK grows a
/// simplex saves the other tests. The old feature was the nearest before and the newest vertex A lies beyond it, so the
/// new nearest feature contains A. The wound triangle BCD has A on the origin's side, so the faces' orientation is
/// known without a determinant that rounding could turn.
/// The normal is built from the feature: for a face the cross product of two edges, for an edge a double cross product,
/// for a vertex the vertex itself. A nearly cancelled vector is never used, so near contact the normal stays
/// perpendicular to the feature to the last bits. <see cref="ExtendedFeatureStep"/> is the same step in extended
/// precision.
/// </remarks>
internal static class ClosestFeatureStep
{
    /// <summary>Reduces the simplex of the last step's feature and the vertex found beyond it.</summary>
    /// <returns>
    /// False when the origin is inside (or on the hidden side of every face of) the tetrahedron; the simplex then keeps
    /// its four vertices.
    /// </returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Reduce(ref Simplex simplex, ref ClosestFeature feature)
    {
        switch (simplex.Count)
        {
            case 1:
                Vertex(ref simplex, ref feature);
                return true;
            case 2:
                Line(ref simplex, ref feature);
                return true;
            case 3:
                Triangle(ref simplex, ref feature);
                return true;
            default:
                return Tetrahedron(ref simplex, ref feature);
        }
    }

    /// <summary>
    /// Reduces a simplex of any origin (a warm start's), about which nothing is known, to its feature nearest the
    /// origin.
    /// </summary>
    /// <returns>False when the origin is inside the tetrahedron, or as near as its weights can tell.</returns>
    public static bool ReduceAny(ref Simplex simplex, ref ClosestFeature feature)
    {
        // A pair that has not moved much: the remembered feature still is the nearest.
        if (simplex.Count < 4 && TryKeepAll(ref simplex, ref feature)) return true;

        Weights w = ClosestPointWeights.Of(simplex);
        int kept = 0;
        for (int i = 0; i < simplex.Count; i++)
        {
            if (!(w[i] > 0)) continue;
            int vertex = simplex[i];
            if (kept == 0) simplex.A = vertex;
            else if (kept == 1) simplex.B = vertex;
            else if (kept == 2) simplex.C = vertex;
            kept++;
        }

        if (kept == 4) return false;
        simplex.Count = kept;
        if (kept == 1) Vertex(ref simplex, ref feature);
        else if (kept == 2) Edge(ref simplex, ref feature, simplex.WA, simplex.WB - simplex.WA);
        else Triangle(ref simplex, ref feature);
        return true;
    }

    /// <summary>
    /// Keeps the whole vertex, edge or triangle when the origin is beside that, not beside a part of it.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool TryKeepAll(ref Simplex simplex, ref ClosestFeature feature)
    {
        if (simplex.Count == 1)
        {
            Vertex(ref simplex, ref feature);
            return true;
        }

        Vector3D a = simplex.WA, b = simplex.WB, ab = b - a;
        if (simplex.Count == 2)
        {
            if (!(Vector3D.Dot(ab, a) < 0 & Vector3D.Dot(ab, b) > 0)) return false;
            Edge(ref simplex, ref feature, a, ab);
            return true;
        }

        Vector3D ac = simplex.WC - a, normal = Vector3D.Cross(ab, ac);
        bool inside = Vector3D.Dot(Vector3D.Cross(ab, normal), a) > 0
            & Vector3D.Dot(Vector3D.Cross(normal, ac), a) > 0
            & Vector3D.Dot(Vector3D.Cross(ac - ab, normal), b) > 0;
        if (!inside) return false;
        Inside(ref simplex, ref feature, a, normal);
        return true;
    }

    /// <summary>The newest vertex alone.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Vertex(ref Simplex simplex, ref ClosestFeature feature)
    {
        simplex.Count = 1;
        Vector3D a = simplex.WA;
        feature.Normal = a;
        feature.Height = a.LengthSquared;
        feature.NormalSquared = feature.Height;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Line(ref Simplex simplex, ref ClosestFeature feature)
    {
        Vector3D a = simplex.WA;
        Vector3D ab = simplex.WB - a;
        if (Vector3D.Dot(ab, a) < 0)
            Edge(ref simplex, ref feature, a, ab);
        else
            Vertex(ref simplex, ref feature);
    }

    /// <summary>
    /// The inside of AB: (ab × a) × ab is perpendicular to AB to the last bits, however near the origin is.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Edge(ref Simplex simplex, ref ClosestFeature feature, in Vector3D a, in Vector3D ab)
    {
        simplex.Count = 2;
        Vector3D moment = Vector3D.Cross(ab, a);
        Vector3D normal = Vector3D.Cross(moment, ab);
        feature.Normal = normal;
        feature.Height = moment.LengthSquared;
        feature.NormalSquared = normal.LengthSquared;
    }

    private static void Triangle(ref Simplex simplex, ref ClosestFeature feature)
    {
        Vector3D a = simplex.WA, ab = simplex.WB - a, ac = simplex.WC - a;
        Face(ref simplex, ref feature, a, ab, ac, Vector3D.Cross(ab, ac));
    }

    /// <summary>
    /// The face ABC with its normal ab × ac, whichever side the origin is on; BC was tested when A was not there. The
    /// two edge tests do not change when B and C change places, so the winding is settled last, without a branch that
    /// no processor could predict.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Face(
        ref Simplex simplex, ref ClosestFeature feature, in Vector3D a, in Vector3D ab, in Vector3D ac,
        in Vector3D normal)
    {
        bool beyondAB = Vector3D.Dot(Vector3D.Cross(ab, normal), a) < 0;
        bool beyondAC = Vector3D.Dot(Vector3D.Cross(normal, ac), a) < 0;
        if (beyondAB | beyondAC)
        {
            BesideFace(ref simplex, ref feature, a, ab, ac, beyondAB, beyondAC);
            return;
        }

        Inside(ref simplex, ref feature, a, normal);
    }

    /// <summary>The inside of the triangle ABC with the given normal, wound away from the origin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Inside(ref Simplex simplex, ref ClosestFeature feature, in Vector3D a, in Vector3D normal)
    {
        simplex.Count = 3;
        double height = Vector3D.Dot(normal, a), sign = height < 0 ? -1 : 1;
        int b = simplex.B, c = simplex.C;
        simplex.B = height < 0 ? c : b;
        simplex.C = height < 0 ? b : c;
        feature.Normal = normal * sign;
        feature.Height = height * sign;
        feature.NormalSquared = normal.LengthSquared;
    }

    /// <summary>Beside AB or AC, or behind A.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void BesideFace(
        ref Simplex simplex, ref ClosestFeature feature, in Vector3D a, in Vector3D ab, in Vector3D ac, bool beyondAB,
        bool beyondAC)
    {
        bool besideAB = beyondAB & Vector3D.Dot(ab, a) < 0, besideAC = beyondAC & Vector3D.Dot(ac, a) < 0;
        if (!(besideAB | besideAC))
        {
            Vertex(ref simplex, ref feature);
            return;
        }

        simplex.B = besideAB ? simplex.B : simplex.C;
        Edge(ref simplex, ref feature, a, simplex.WB - a);
    }

    /// <summary>The three faces at A; face BCD has the origin behind it, on A's side.</summary>
    private static bool Tetrahedron(ref Simplex simplex, ref ClosestFeature feature)
    {
        Vector3D a = simplex.WA, ab = simplex.WB - a, ac = simplex.WC - a, ad = simplex.WD - a;
        int beyondABC = Vector3D.Dot(Vector3D.Cross(ab, ac), a) > 0 ? 1 : 0;
        int beyondACD = Vector3D.Dot(Vector3D.Cross(ac, ad), a) > 0 ? 1 : 0;
        int beyondADB = Vector3D.Dot(Vector3D.Cross(ad, ab), a) > 0 ? 1 : 0;
        int faces = beyondABC + beyondACD + beyondADB;
        if (faces == 0) return false;
        if (faces > 1) return NearestOfFaces(ref simplex, ref feature, beyondABC != 0, beyondACD != 0, beyondADB != 0);

        // ABC stays, ACD moves up, ADB goes round.
        int b = simplex.B, c = simplex.C, d = simplex.D;
        simplex.B = beyondACD != 0 ? c : beyondADB != 0 ? d : b;
        simplex.C = beyondACD != 0 ? d : beyondADB != 0 ? b : c;
        Triangle(ref simplex, ref feature);
        return true;
    }

    /// <summary>
    /// The origin sees two or three faces: the nearest feature is that of the face whose own is nearest.
    /// </summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static bool NearestOfFaces(
        ref Simplex simplex, ref ClosestFeature feature, bool beyondABC, bool beyondACD, bool beyondADB)
    {
        int b = simplex.B, c = simplex.C, d = simplex.D;
        Vector3D a = simplex.WA;
        ClosestFeature best = default, candidate = default;
        int bestB = b, bestC = c, bestCount = 0;
        for (int face = 0; face < 3; face++)
        {
            if (!(face == 0 ? beyondABC : face == 1 ? beyondACD : beyondADB)) continue;
            simplex.B = face == 0 ? b : face == 1 ? c : d;
            simplex.C = face == 0 ? c : face == 1 ? d : b;
            Vector3D e = simplex.WB - a, f = simplex.WC - a;
            Face(ref simplex, ref candidate, a, e, f, Vector3D.Cross(e, f));
            if (bestCount != 0 && !(candidate.DistanceSquared < best.DistanceSquared)) continue;
            best = candidate;
            bestCount = simplex.Count;
            bestB = simplex.B;
            bestC = simplex.C;
        }

        feature = best;
        simplex.B = bestB;
        simplex.C = bestC;
        simplex.Count = bestCount;
        return true;
    }
}
