using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// Muratori's step ("Implementing GJK", 2006), for the distance and the boolean: given the feature that was nearest the
/// origin and the vertex found beyond it, which vertices make the next one, and what is its normal?
/// </summary>
/// <remarks>
/// <para>
/// A is the newest vertex, as in his drawings. The way GJK grows a simplex saves most of the tests. The old feature was
/// the nearest before and A lies beyond it, so the new one contains A: an edge AB, a face ABC or A alone. And the
/// origin cannot be behind the old face BCD. Tests that he may leave out for the boolean are put back (Ericson 2004,
/// section 5.1), because a distance needs the nearest feature and not just a good direction.
/// </para>
/// <para>
/// Where he winds each triangle away from the origin, the side is kept as a sign (<see
/// cref="FeatureVertices.Winding"/>): no vertex moves, and no branch is taken that no processor could predict.
/// </para>
/// <para>
/// The normal is built from the feature: for a face the cross product of two edges, for an edge a double cross product,
/// for a vertex the vertex itself. A nearly cancelled vector is never used, so near contact the normal stays
/// perpendicular to the feature to the last bits. <see cref="ExtendedFeatureStep"/> is the same step in extended
/// precision.
/// </para>
/// </remarks>
internal static class NextSimplex
{
    /// <summary>Bits of the three faces of a tetrahedron at A.</summary>
    private const int Abc = 1, Acd = 2, Adb = 4;

    /// <summary>The nearest feature of the last one and the newest vertex.</summary>
    /// <param name="simplex">The last feature's vertices, none to three; then the new one's.</param>
    /// <param name="newest">Found beyond it.</param>
    /// <param name="feature">Gets the new feature's normal and height.</param>
    /// <param name="nearest">
    /// Whether to compare, where the origin sees several faces of a tetrahedron; otherwise the first will do.
    /// </param>
    /// <returns>
    /// False when the origin is inside (or on the hidden side of every face of) the tetrahedron; the vertices then stay
    /// as they were.
    /// </returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool TryAdvance(
        ref FeatureVertices simplex, in MinkowskiVertex newest, ref ClosestFeature feature, bool nearest)
    {
        if (simplex.Count == 3)
        {
            if (!TryTakeFace(ref simplex, newest.W, nearest)) return false;
        }
        else
        {
            simplex.C.Set(simplex.B);
            simplex.B.Set(simplex.A);
        }

        simplex.A.Set(newest);
        if (simplex.Count >= 2) Triangle(ref simplex, ref feature);
        else if (simplex.Count == 1) Line(ref simplex, ref feature);
        else KeepVertex(ref simplex, ref feature, newest.W);
        return true;
    }

    /// <summary>
    /// Keeps the whole vertex, edge or triangle when the origin is beside that, not beside a part of it: for a simplex
    /// that was the nearest feature of a pair before the pair moved.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool TryKeepAll(ref FeatureVertices simplex, ref ClosestFeature feature)
    {
        Double3 a = simplex.A.W;
        if (simplex.Count == 1)
        {
            KeepVertex(ref simplex, ref feature, a);
            return true;
        }

        Double3 b = simplex.B.W, ab = b - a;
        if (simplex.Count == 2)
        {
            if (!(Double3.Dot(ab, a) < 0 & Double3.Dot(ab, b) > 0)) return false;
            KeepEdge(ref simplex, ref feature, a, ab);
            return true;
        }

        Double3 ac = simplex.C.W - a, normal = Double3.Cross(ab, ac);
        bool inside = Double3.Dot(Double3.Cross(ab, normal), a) > 0
            & Double3.Dot(Double3.Cross(normal, ac), a) > 0
            & Double3.Dot(Double3.Cross(ac - ab, normal), b) > 0;
        if (!inside) return false;
        KeepFace(ref simplex, ref feature, a, normal);
        return true;
    }

    /// <summary>The nearest feature of one to three vertices, of which the first is known to be part of it.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Reduce(ref FeatureVertices simplex, ref ClosestFeature feature)
    {
        if (simplex.Count == 3) Triangle(ref simplex, ref feature);
        else if (simplex.Count == 2) KeepEdge(ref simplex, ref feature, simplex.A.W, simplex.B.W - simplex.A.W);
        else KeepVertex(ref simplex, ref feature, simplex.A.W);
    }

    /// <summary>The vertex A alone.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void KeepVertex(ref FeatureVertices simplex, ref ClosestFeature feature, in Double3 a)
    {
        simplex.Count = 1;
        feature.Normal = a;
        feature.Height = a.LengthSquared;
        feature.NormalSquared = feature.Height;
    }

    /// <summary>The origin is beside AB, or behind A.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Line(ref FeatureVertices simplex, ref ClosestFeature feature)
    {
        Double3 a = simplex.A.W, ab = simplex.B.W - a;
        if (Double3.Dot(ab, a) < 0) KeepEdge(ref simplex, ref feature, a, ab);
        else KeepVertex(ref simplex, ref feature, a);
    }

    /// <summary>
    /// The origin is above or below ABC, beside AB or AC, or behind A; BC was tested when A was not there.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Triangle(ref FeatureVertices simplex, ref ClosestFeature feature)
    {
        Double3 a = simplex.A.W, ab = simplex.B.W - a, ac = simplex.C.W - a, normal = Double3.Cross(ab, ac);
        bool beyondAB = Double3.Dot(Double3.Cross(ab, normal), a) < 0;
        bool beyondAC = Double3.Dot(Double3.Cross(normal, ac), a) < 0;
        if (!(beyondAB | beyondAC))
        {
            KeepFace(ref simplex, ref feature, a, normal);
            return;
        }

        bool besideAB = beyondAB & Double3.Dot(ab, a) < 0, besideAC = beyondAC & Double3.Dot(ac, a) < 0;
        if (!(besideAB | besideAC))
        {
            KeepVertex(ref simplex, ref feature, a);
            return;
        }

        if (!besideAB) simplex.B.Set(simplex.C);
        KeepEdge(ref simplex, ref feature, a, simplex.B.W - a);
    }

    /// <summary>
    /// The inside of AB: (ab × a) × ab is perpendicular to AB to the last bits, however near the origin is.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void KeepEdge(
        ref FeatureVertices simplex, ref ClosestFeature feature, in Double3 a, in Double3 ab)
    {
        simplex.Count = 2;
        Double3 moment = Double3.Cross(ab, a), normal = Double3.Cross(moment, ab);
        feature.Normal = normal;
        feature.Height = moment.LengthSquared;
        feature.NormalSquared = normal.LengthSquared;
    }

    /// <summary>The inside of ABC, whose normal ab × ac is turned away from the origin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void KeepFace(
        ref FeatureVertices simplex, ref ClosestFeature feature, in Double3 a, in Double3 normal)
    {
        simplex.Count = 3;
        double height = Double3.Dot(normal, a), winding = BranchFree.WithSign(1, height);
        simplex.Winding = winding;
        feature.Normal = normal * winding;
        feature.Height = height * winding;
        feature.NormalSquared = normal.LengthSquared;
    }

    /// <summary>
    /// The face of the tetrahedron that the origin is beyond: its corners other than the newest become B and C. False
    /// when it is beyond none.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool TryTakeFace(ref FeatureVertices simplex, in Double3 a, bool nearest)
    {
        Double3 ab = simplex.A.W - a, ac = simplex.B.W - a, ad = simplex.C.W - a;
        double winding = simplex.Winding;
        int faces = (Double3.Dot(Double3.Cross(ab, ac), a) * winding > 0 ? Abc : 0)
            | (Double3.Dot(Double3.Cross(ac, ad), a) * winding > 0 ? Acd : 0)
            | (Double3.Dot(Double3.Cross(ad, ab), a) * winding > 0 ? Adb : 0);
        if (faces == 0) return false;
        if ((faces & (faces - 1)) != 0)
            faces = nearest ? Nearest(faces, a, simplex.A.W, simplex.B.W, simplex.C.W) : faces & -faces;
        if (faces == Abc)
        {
            simplex.C.Set(simplex.B);
            simplex.B.Set(simplex.A);
        }
        else if (faces == Adb)
        {
            simplex.B.Set(simplex.C);
            simplex.C.Set(simplex.A);
        }

        return true;
    }

    /// <summary>Of several faces the one whose own nearest feature is nearest; the first of equals.</summary>
    /// <remarks>The vertices come by value: the caller's are to stay in registers.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static int Nearest(int faces, Double3 a, Double3 b, Double3 c, Double3 d)
    {
        double abc = (faces & Abc) != 0 ? DistanceSquared(a, b, c) : double.PositiveInfinity;
        double acd = (faces & Acd) != 0 ? DistanceSquared(a, c, d) : double.PositiveInfinity;
        double adb = (faces & Adb) != 0 ? DistanceSquared(a, d, b) : double.PositiveInfinity;
        if ((faces & Abc) != 0 && !(acd < abc) && !(adb < abc)) return Abc;
        return (faces & Acd) != 0 && !(adb < acd) ? Acd : Adb;
    }

    private static double DistanceSquared(in Double3 a, in Double3 b, in Double3 c)
    {
        FeatureVertices simplex = default;
        ClosestFeature feature = default;
        simplex.A = new MinkowskiVertex(a, 0);
        simplex.B = new MinkowskiVertex(b, 0);
        simplex.C = new MinkowskiVertex(c, 0);
        Triangle(ref simplex, ref feature);
        return feature.DistanceSquared;
    }
}
