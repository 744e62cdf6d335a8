namespace Gjk.Core;

/// <summary>GJK's boolean algorithm (Muratori 2006): do two cores without margins share a point? It answers only what
/// rounding cannot change, and leaves the rest open.</summary>
/// <remarks>
/// <para>Each round asks for the vertex that is furthest against the last normal. If even that one lies beyond the
/// origin, the plane through it separates. Otherwise the vertex joins the simplex, and <see cref="NextSimplex"/> says
/// where to search next.</para>
/// <para>It differs from the textbook in what it calls certain. Cores are apart only when the plane's gap exceeds all
/// rounding, and the origin is enclosed only when four determinants are certain. Contact within some 1e-14 of the size
/// is Undecided and goes to the distance solver, so the two never disagree for supports in double.</para>
/// <para>Muratori's step can cycle on degenerate input, which is the endless loop of implementations that trust it.
/// MaxRounds ends it as Undecided, which costs time and nothing else.</para>
/// </remarks>
internal static class GjkOverlap
{
    /// <summary>Count: more than hulls of thousands of vertices need; reached by cycles only. Pinned by
    /// CostGuardTests.</summary>
    private const int MaxRounds = 40;

    /// <summary>Apart, Enclosed or Undecided.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static Verdict Solve<TA, TB>(ref TA a, ref TB b, in PairFrame frame)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        FeatureVertices.Make(out FeatureVertices vertices);
        ClosestFeature feature = default;
        Double3 first = frame.FirstNormal;
        feature.Normal = new Double3(first.X, first.Y, first.Z);
        for (int round = 0; round < MaxRounds; round++)
        {
            int ids = MinkowskiDifference.Support(ref a, ref b, frame, feature.Normal, out Double3 w);
            double plane = Double3.Dot(feature.Normal, w);
            bool curved = ids < 0;
            if (plane > 0)
            {
                double band = (curved ? GjkTolerances.SeparatedBandCurved : GjkTolerances.SeparatedBand) * frame.Radius;
                return plane * plane > band * band * feature.Normal.LengthSquared ? Verdict.Apart : Verdict.Undecided;
            }

            var newest = new MinkowskiVertex(w, 0);
            if (!NextSimplex.TryAdvance(ref vertices, newest, ref feature, nearest: false))
            {
                // The distance solver may have ended on a curved core within its tolerance of contact, before the
                // origin was enclosed: let it say.
                return !curved && Proofs.IsCertainlyInside(w, vertices.A.W, vertices.B.W, vertices.C.W)
                    ? Verdict.Enclosed
                    : Verdict.Undecided;
            }

            // The origin is on the feature, as far as double can tell, and there is no direction to search in.
            if (!(feature.NormalSquared > 0)) return Verdict.Undecided;
        }

        return Verdict.Undecided;
    }
}
