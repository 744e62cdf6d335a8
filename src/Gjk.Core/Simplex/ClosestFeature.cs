using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>
/// The step of the distance solver: reduces a simplex to its feature (vertex, edge, face) nearest the origin and gives that feature's
/// normal, or finds the origin enclosed.
/// </summary>
/// <remarks>
/// The regions are Muratori's (2006), with the tests that he may leave out for the boolean put back (Ericson 2004, section 5.1): a distance needs
/// the nearest feature, not just a good direction. Three things follow from how GJK grows a simplex and save the other tests: the old feature was
/// nearest before, the newest vertex A lies beyond it, so the new nearest feature contains A; the wound triangle BCD has A on the origin's side, so
/// the faces' orientation is known without a determinant that rounding could turn.
/// The normal is built from the feature (face: cross product of two edges; edge: perpendicular through the cross product; vertex: the vertex), never
/// by subtracting along a nearly cancelled vector, so near contact it stays perpendicular to the feature to the last bits. Nothing is divided
/// or normalised: a feature's distance is Height / |Normal|.
/// </remarks>
internal struct ClosestFeature
{
    /// <summary>From the origin towards the feature and perpendicular to it, of any length.</summary>
    public Vector3D Normal;

    /// <summary>Normal · x for every x of the feature: at least 0.</summary>
    public double Height;

    /// <summary>|Normal|².</summary>
    public double NormalSquared;

    /// <summary>The squared distance of the feature from the origin.</summary>
    public readonly double DistanceSquared => Height * Height / NormalSquared;

    /// <summary>Reduces a simplex of two to four vertices, the last step's feature and the vertex found beyond it.</summary>
    /// <returns>False when the origin is inside (or on the hidden side of every face of) the tetrahedron; the simplex then keeps its four vertices.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Reduce(ref Simplex simplex)
    {
        switch (simplex.Count)
        {
            case 2:
                Line(ref simplex);
                return true;
            case 3:
                Triangle(ref simplex);
                return true;
            default:
                return Tetrahedron(ref simplex);
        }
    }

    /// <summary>Reduces a simplex of any origin (a warm start's), about which nothing is known, to its feature nearest the origin.</summary>
    /// <returns>False when the origin is inside the tetrahedron, or as near as its weights can tell.</returns>
    public bool ReduceAny(ref Simplex simplex)
    {
        Weights w = ClosestPointWeights.Of(simplex);
        int kept = 0;
        for (int i = 0; i < simplex.Count; i++)
        {
            if (!(w[i] > 0)) continue;
            SimplexVertex vertex = simplex[i];
            if (kept == 0) simplex.A = vertex;
            else if (kept == 1) simplex.B = vertex;
            else if (kept == 2) simplex.C = vertex;
            kept++;
        }

        if (kept == 4) return false;
        simplex.Count = kept;
        if (kept == 1) Vertex(ref simplex);
        else if (kept == 2) Edge(ref simplex, simplex.A.W, simplex.B.W - simplex.A.W);
        else Triangle(ref simplex);
        return true;
    }

    /// <summary>The newest vertex alone.</summary>
    public void Vertex(ref Simplex simplex)
    {
        simplex.Count = 1;
        Normal = simplex.A.W;
        Height = Normal.LengthSquared;
        NormalSquared = Height;
    }

    private void Line(ref Simplex simplex)
    {
        Vector3D a = simplex.A.W;
        Vector3D ab = simplex.B.W - a;
        if (Vector3D.Dot(ab, a) < 0)
            Edge(ref simplex, a, ab);
        else
            Vertex(ref simplex);
    }

    /// <summary>The inside of AB: (ab × a) × ab is perpendicular to AB to the last bits, however near the origin is.</summary>
    private void Edge(ref Simplex simplex, in Vector3D a, in Vector3D ab)
    {
        simplex.Count = 2;
        Vector3D moment = Vector3D.Cross(ab, a);
        Normal = Vector3D.Cross(moment, ab);
        Height = moment.LengthSquared;
        NormalSquared = Normal.LengthSquared;
    }

    private void Triangle(ref Simplex simplex)
    {
        Vector3D a = simplex.A.W;
        Vector3D ab = simplex.B.W - a, ac = simplex.C.W - a;
        Vector3D normal = Vector3D.Cross(ab, ac);
        if (Vector3D.Dot(normal, a) >= 0)
        {
            Face(ref simplex, a, ab, ac, normal);
            return;
        }

        (simplex.B, simplex.C) = (simplex.C, simplex.B);
        Face(ref simplex, a, ac, ab, -normal);
    }

    /// <summary>The face ABC, wound so that its normal points away from the origin; BC was tested when A was not there.</summary>
    private void Face(ref Simplex simplex, in Vector3D a, in Vector3D ab, in Vector3D ac, in Vector3D normal)
    {
        bool beyondAB = Vector3D.Dot(Vector3D.Cross(ab, normal), a) < 0;
        bool beyondAC = Vector3D.Dot(Vector3D.Cross(normal, ac), a) < 0;
        if (beyondAB | beyondAC)
        {
            if (beyondAB && Vector3D.Dot(ab, a) < 0)
            {
                Edge(ref simplex, a, ab);
            }
            else if (beyondAC && Vector3D.Dot(ac, a) < 0)
            {
                simplex.B = simplex.C;
                Edge(ref simplex, a, ac);
            }
            else
            {
                Vertex(ref simplex);
            }

            return;
        }

        simplex.Count = 3;
        Normal = normal;
        Height = Vector3D.Dot(normal, a);
        NormalSquared = normal.LengthSquared;
    }

    /// <summary>The three faces at A; face BCD has the origin behind it, on A's side.</summary>
    private bool Tetrahedron(ref Simplex simplex)
    {
        Vector3D a = simplex.A.W;
        Vector3D ab = simplex.B.W - a, ac = simplex.C.W - a, ad = simplex.D.W - a;
        Vector3D abc = Vector3D.Cross(ab, ac), acd = Vector3D.Cross(ac, ad), adb = Vector3D.Cross(ad, ab);
        bool beyondABC = Vector3D.Dot(abc, a) > 0, beyondACD = Vector3D.Dot(acd, a) > 0, beyondADB = Vector3D.Dot(adb, a) > 0;
        int faces = (beyondABC ? 1 : 0) + (beyondACD ? 1 : 0) + (beyondADB ? 1 : 0);
        if (faces == 0) return false;
        if (faces > 1) return NearestOfFaces(ref simplex, beyondABC, beyondACD, beyondADB);

        if (beyondABC)
        {
            Face(ref simplex, a, ab, ac, abc);
        }
        else if (beyondACD)
        {
            simplex.B = simplex.C;
            simplex.C = simplex.D;
            Face(ref simplex, a, ac, ad, acd);
        }
        else
        {
            simplex.C = simplex.B;
            simplex.B = simplex.D;
            Face(ref simplex, a, ad, ab, adb);
        }

        return true;
    }

    /// <summary>The origin sees two or three faces: the nearest feature is that of the face whose own is nearest.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private bool NearestOfFaces(ref Simplex simplex, bool beyondABC, bool beyondACD, bool beyondADB)
    {
        SimplexVertex a = simplex.A, b = simplex.B, c = simplex.C, d = simplex.D;
        ClosestFeature best = default, candidate = default;
        SimplexVertex bestB = b, bestC = c;
        int bestCount = 0;
        for (int face = 0; face < 3; face++)
        {
            if (!(face == 0 ? beyondABC : face == 1 ? beyondACD : beyondADB)) continue;
            simplex.B = face == 0 ? b : face == 1 ? c : d;
            simplex.C = face == 0 ? c : face == 1 ? d : b;
            simplex.A = a;
            Vector3D e = simplex.B.W - a.W, f = simplex.C.W - a.W;
            candidate.Face(ref simplex, a.W, e, f, Vector3D.Cross(e, f));
            if (bestCount != 0 && !(candidate.DistanceSquared < best.DistanceSquared)) continue;
            best = candidate;
            bestCount = simplex.Count;
            bestB = simplex.B;
            bestC = simplex.C;
        }

        this = best;
        simplex.B = bestB;
        simplex.C = bestC;
        simplex.Count = bestCount;
        return true;
    }
}
