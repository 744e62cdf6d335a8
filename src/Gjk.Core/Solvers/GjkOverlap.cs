namespace Gjk.Core;

/// <summary>
/// GJK's boolean algorithm (Muratori 2006): do two cores without margins share a point? It answers only what rounding cannot change, and says so
/// when it cannot.
/// </summary>
/// <remarks>
/// Each round asks for the vertex furthest against the last normal. If even that one lies on the far side of the origin's plane, the plane separates; otherwise the
/// vertex joins and <see cref="NextSimplex"/> moves on. Deviation: separation is called only when the plane's gap is larger than all rounding, enclosure
/// only when the four determinants are certain; the rest, contact within some 1e-14 of the size, is Undecided and goes to the distance solver, so that the two never
/// disagree. Termination: Muratori's step can cycle on degenerate input (that is the endless loop of implementations that trust it); MaxRounds
/// ends it as Undecided, which costs time and nothing else.
/// </remarks>
internal static class GjkOverlap
{
    /// <summary>Count: more than hulls of thousands of vertices need; reached by cycles only. Pinned by CostGuardTests.</summary>
    private const int MaxRounds = 40;

    /// <summary>Apart, Enclosed or Undecided.</summary>
    public static Verdict Solve<TA, TB>(ref TA a, ref TB b, in PairFrame frame)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Simplex.Begin(out Simplex simplex);
        Vector3D normal = frame.FirstNormal;
        for (int round = 0; round < MaxRounds; round++)
        {
            MinkowskiDifference.Support(ref a, ref b, frame, normal, out int idA, out int idB, out Vector3D onA, out Vector3D onB, out Vector3D w);
            double plane = Vector3D.Dot(normal, w);
            bool curved = (idA | idB) < 0;
            if (plane > 0)
            {
                double band = (curved ? GjkTolerances.SeparatedBandCurved : GjkTolerances.SeparatedBand) * frame.Radius;
                return plane * plane > band * band * normal.LengthSquared ? Verdict.Apart : Verdict.Undecided;
            }

            simplex.Push(w, onA, onB, idA, idB);
            if (simplex.Count == 1)
                normal = w;
            else if (NextSimplex.Advance(ref simplex, ref normal))
            {
                // The distance solver may have ended on a curved core within its tolerance of contact, before the origin was enclosed: let it say.
                return !curved && Proofs.IsCertainlyInside(simplex) ? Verdict.Enclosed : Verdict.Undecided;
            }
        }

        return Verdict.Undecided;
    }
}
