namespace Gjk.Core;

/// <summary>What the solvers call proved: bounds that meet, an origin that is certainly inside, a point near enough to
/// touch. Each is a comparison with a named tolerance of <see cref="GjkTolerances"/>.</summary>
internal static class Proofs
{
    /// <summary>The gap between the feature and the plane is nothing beside the distance, or beside what rounding does.
    /// For curved cores that of the shapes is meant: beside long margins, more than counts as touching would be
    /// nothing.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsClosed(double gap, in ClosestFeature feature, bool curved, double noise, double margins)
    {
        double ratio = curved ? GjkTolerances.RelativeGapCurved : GjkTolerances.RelativeGap;
        double least = ratio * feature.Height;
        if (curved) least -= ratio * margins * Math.Sqrt(feature.NormalSquared);
        return Math.Abs(gap) <= least || gap * gap <= noise * noise * feature.NormalSquared;
    }

    /// <summary>The balls around the shapes are apart by more than rounding could close, and so are the
    /// shapes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool AreBallsApart(in PairFrame frame)
    {
        double reach = frame.Radius * (1 + GjkTolerances.SeparatedBandCurved);
        return frame.Translation.LengthSquared > reach * reach;
    }

    /// <summary>The other two corners of a triangle lie no further above the plane than the bounds may be
    /// apart.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsLevel(in FeatureVertices vertices, in ClosestFeature feature, double plane, double level)
    {
        double b = Double3.Dot(feature.Normal, vertices.B.W) - plane;
        double c = Double3.Dot(feature.Normal, vertices.C.W) - plane;
        return IsClosed(b, feature, false, level, 0) && IsClosed(c, feature, false, level, 0);
    }

    /// <summary>The origin lies inside each of the three faces at A, and BCD's plane beyond it, by more than rounding
    /// could turn; either way round.</summary>
    public static bool IsCertainlyInside(Double3 a, Double3 b, Double3 c, Double3 d)
    {
        if (ClosestPointWeights.IsInside(a, b, c, d)) return true;
        if (Double3.Triple(b - a, c - a, a) > 0) (b, c) = (c, b);
        return IsCertain(a, b - a, c - a) && IsCertain(a, c - a, d - a)
            && IsCertain(a, d - a, b - a) && IsCertain(-b, c - b, d - b);
    }

    /// <summary>The verdict on a tetrahedron that seems to hold the origin. Signs that rounding could turn decide
    /// nothing, but a point of the simplex near enough does.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Enclose(ref SolverState state, double touchSquared)
    {
        if (TryEncloseClearly(ref state)) return;
        ref Simplex s = ref state.Simplex;
        bool isProved = IsCertainlyInside(s.WA, s.WB, s.WC, s.WD) | HoldsPointNear(ref state, touchSquared);
        state.Verdict = isProved ? Verdict.Enclosed : Verdict.Undecided;
    }

    /// <summary>The verdict Enclosed where the volumes that the weights are made of leave no doubt.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool TryEncloseClearly(ref SolverState state)
    {
        if (!ClosestPointWeights.TryInside(state.Simplex, out state.Weights)) return false;
        state.Verdict = Verdict.Enclosed;
        return true;
    }

    /// <summary>The verdict on a feature that seems no further than rounding can tell from contact. The normal of a
    /// needle of a triangle may be rounding itself, and then its height says nothing, so a point of the feature must
    /// prove it. A distance that is NaN for another reason than a height of 0 over 0 comes from a shape.</summary>
    public static void Touch(ref SolverState state, double distanceSquared, double touchSquared)
    {
        if (!(state.Feature.Height == 0 || distanceSquared >= 0)) state.Verdict = Verdict.Contradiction;
        else state.Verdict = HoldsPointNear(ref state, touchSquared) ? Verdict.Enclosed : Verdict.Undecided;
    }

    /// <summary>The feature itself, and not only its line or plane, has a point where its height says. Rounding may
    /// choose an edge of a needle that has another corner between it and the origin; then the bounds meet, but the
    /// points would be that edge's end.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool HoldsItsPoint(in SolverState state) =>
        state.Weights.AreAll(state.Simplex.Count) || IsNear(state);

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static bool IsNear(in SolverState state)
    {
        Double3 foot = state.Feature.Normal * (state.Feature.Height / state.Feature.NormalSquared);
        Double3 point = state.Simplex.PointOf(state.Weights);
        double size = state.Size.Value, distance = foot.Length, most = GjkTolerances.Beside * (size + distance);
        distance += GjkTolerances.RelativeGap * distance + GjkTolerances.TouchOf(state.IsCurved) * size;
        return !((point - foot).LengthSquared > most * most || point.Length > distance);
    }

    /// <summary>The shapes' supports disagree by the gap. A small gap is the support's own rounding (one that computes
    /// in float, say): the feature stands, and the plane says how far to trust it. A large one, or NaN, is no convex
    /// shape.</summary>
    public static void SettleStall(ref SolverState state, double plane, double gap)
    {
        double limit = GjkTolerances.Contradiction * state.Size.Value;
        bool small = gap * gap <= limit * limit * state.Feature.NormalSquared;
        state.Verdict = small ? Verdict.Apart : Verdict.Contradiction;
        state.Weights = ClosestPointWeights.OfFeature(state.Simplex, state.Feature);
        state.Plane.Set(state.Feature, Math.Min(plane, state.Feature.Height));
    }

    /// <summary>The signed gap between the shapes: that of the cores less the margins, in solver units. What is at the
    /// very edge of touching is there in every query only if all of them round it alike.</summary>
    /// <param name="state">With its nearest feature.</param>
    /// <param name="frame">With the margins.</param>
    /// <param name="scale">One over the length of the feature's normal.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double DistanceOf(in SolverState state, in PairFrame frame, double scale) =>
        state.Feature.Height * scale - frame.MarginA - frame.MarginB;

    /// <summary>Whether shapes that are so far apart touch. Every walk ends with this, so that all queries agree;
    /// balls, half-spaces and the lanes of <c>WideFinish</c> compare with the same tolerance.</summary>
    /// <param name="state">With the size and the verdict.</param>
    /// <param name="distance">As <see cref="DistanceOf"/> says.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsTouching(in SolverState state, double distance) =>
        state.Verdict == Verdict.Apart && distance <= GjkTolerances.TouchOf(state.IsCurved) * state.Size.Value;

    private static bool IsCertain(in Double3 a, in Double3 e, in Double3 f)
    {
        double determinant = -Double3.Triple(e, f, a);
        double error = GjkTolerances.DeterminantError;
        return determinant > 0
            && determinant * determinant > error * error * a.LengthSquared * e.LengthSquared * f.LengthSquared;
    }

    /// <summary>True if the simplex's nearest point lies within the touch tolerance. Decides flush faces, where the
    /// signs of determinants are uncertain.</summary>
    private static bool HoldsPointNear(ref SolverState state, double touchSquared)
    {
        state.Weights = ClosestPointWeights.Of(state.Simplex);
        return state.Simplex.PointOf(state.Weights).LengthSquared <= touchSquared;
    }
}
