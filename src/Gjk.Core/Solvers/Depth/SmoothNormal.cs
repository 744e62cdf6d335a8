namespace Gjk.Core;

/// <summary>The direction of the shortest way out where it ends on a smooth point of A - B, by Newton's method from
/// where a search has met its bounds: it knows the depth of the cores, or the distance that their margins overlap by,
/// to within a length, which leaves the direction open by its root.</summary>
/// <remarks>
/// <para>The way out along n costs h(n) = n·w, where w is the support point of A - B along n. Across n its slope is w's
/// part across it, and its second derivative is how w moves as n turns, less h; differences of supports give
/// that.</para>
/// <para>Nothing is assumed. The direction is taken if its way out costs no more than the known one and ends on its own
/// support point. Where w jumps from one end of an edge of A - B to the other it does not, and the search goes
/// on.</para>
/// </remarks>
internal static class SmoothNormal<TA, TB>
    where TA : struct, ISupportMap
    where TB : struct, ISupportMap
{
    /// <summary>Radians: half of what the normal is turned by for a difference. Its square is what the difference may
    /// be off by, and what rounding does to supports is a part of 1e-11 of it. Four times more or less takes as many
    /// steps.</summary>
    private const double DifferenceAngle = 1e-5;

    /// <summary>Length: a way out that bends less has no sharp direction; rounding would turn it by more than is
    /// promised. Four times more or less changes which search ends it.</summary>
    private const double LeastBend = 1e-3;

    /// <summary>Length: how far the end of the way may be from the support point; over the least bend it is what is
    /// promised of the direction. Pinned by SmoothNormalTests.</summary>
    private const double Beside = 1e-9;

    /// <summary>Radians: a search is never off by more, and after a step below the second no further one is
    /// needed.</summary>
    private const double MostStep = 0.03, LastStep = 1e-7;

    /// <summary>Length: how far the support point is from the end of the way where cores are apart, at most. A distance
    /// that is known within 1e-10 leaves the root of 2e-10 times the bend: more is the jump of an edge, for which a
    /// larger one would only cost time.</summary>
    private const double Jump = 1e-3;

    /// <summary>Ratio: what a step by a bend that was found nearby leaves at most: far less on a smooth surface, and
    /// more about an edge. So steps end.</summary>
    private const double Left = 0.1;

    /// <summary>Count: Newton's steps double the digits from 1e-3 on. More are seldom needed.</summary>
    private const int MostSteps = 5;

    /// <summary>Ends a search whose bounds have met.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">Where B is.</param>
    /// <param name="known">The shortest way out that is known.</param>
    /// <param name="state">Gets the way out and its end.</param>
    /// <returns>Whether it ends on a smooth point.</returns>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static bool TryEnd(ref TA a, ref TB b, in PairFrame frame, in DepthBounds known, ref SolverState state)
    {
        double size = state.Size.Value, length = 1;
        Double3 normal = known.Normal;
        UnsafeRef.SkipInit(out DifferenceVertex end);
        Double3 w = Support(ref a, ref b, frame, normal, ref state, ref end);
        for (int steps = 0; length > LastStep; steps++)
        {
            if (steps == MostSteps) return false;
            (Double3 u, Double3 v) = new PlaneBasis(normal);
            Double3 alongU = Slope(ref a, ref b, frame, normal, u, ref state, ref end);
            Double3 alongV = Slope(ref a, ref b, frame, normal, v, ref state, ref end);
            var bend = new WayBend(u, v, Double3.Dot(normal, w), alongU, alongV);
            if (!bend.IsMoreThan(LeastBend * size)) return false;
            Double3 step = bend.Step(w);
            length = step.Length;
            if (!(length <= MostStep)) return false;
            normal += step;
            normal *= 1 / normal.Length;
            w = Support(ref a, ref b, frame, normal, ref state, ref end);
        }

        double cost = Double3.Dot(normal, w);
        if (!(cost <= known.Upper + GjkTolerances.Noise * size)) return false;
        if (!((w - normal * cost).Length <= Beside * size)) return false;
        state.Simplex.At(0) = end;
        state.Simplex.Select(1, 0, 0, 0, 0);
        new DepthBounds(normal, cost, 0).Store(ref state, cost);
        return true;
    }

    /// <summary>Makes normal and points sharper of curved cores that are apart while their margins overlap. The
    /// distance stays as it is, so that all queries agree.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">Where B is.</param>
    /// <param name="state">Of cores that are apart or overlap.</param>
    /// <returns>Whether the shapes are such, and the way out ends on a smooth point.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool TrySharpen(ref TA a, ref TB b, in PairFrame frame, ref SolverState state) =>
        state.IsCurved && frame.Margins > 0 && state.Verdict == Verdict.Apart
        && TrySharpenMargins(ref a, ref b, frame, ref state);

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static bool TrySharpenMargins(ref TA a, ref TB b, in PairFrame frame, ref SolverState state)
    {
        double scale = 1 / Math.Sqrt(state.Feature.NormalSquared), distance = state.Feature.Height * scale;
        if (!(distance > 0 && distance < frame.Margins)) return false;
        Double3 normal = state.Feature.Normal * -scale;
        UnsafeRef.SkipInit(out DifferenceVertex end);
        if (!TryStepNear(ref a, ref b, frame, ref normal, ref state, ref end, out double cost)) return false;
        if (!(cost <= GjkTolerances.Noise * state.Size.Value - state.Plane.Distance)) return false;
        state.Simplex.At(0) = end;
        state.Simplex.Select(1, 0, 0, 0, 0);
        state.Weights = new Weights(1, 0, 0, 0);
        new DepthBounds(normal, cost, 0).Store(ref state, -distance);
        state.Plane.Set(state.Feature, Math.Min(-cost, distance));
        return true;
    }

    /// <summary>Newton's method from a normal that a distance solver has found. That is off by some 1e-5, and by 5e-4
    /// where the way hardly bends: so the bend there is that of all steps, and differences to one side are
    /// enough.</summary>
    private static bool TryStepNear(
        ref TA a, ref TB b, in PairFrame frame, ref Double3 normal, ref SolverState state, ref DifferenceVertex end,
        out double cost)
    {
        double size = state.Size.Value;
        Double3 w = Support(ref a, ref b, frame, normal, ref state, ref end);
        cost = Double3.Dot(normal, w);
        Double3 aside = w - normal * cost;
        double length = aside.Length;
        if (!(length <= Jump * size)) return false;
        if (length <= Beside * size) return true;
        (Double3 u, Double3 v) = new PlaneBasis(normal);
        Double3 toU = Support(ref a, ref b, frame, normal + u * DifferenceAngle, ref state, ref end) - w;
        Double3 toV = Support(ref a, ref b, frame, normal + v * DifferenceAngle, ref state, ref end) - w;
        var bend = new WayBend(u, v, cost, toU * (1 / DifferenceAngle), toV * (1 / DifferenceAngle));
        if (!bend.IsMoreThan(LeastBend * size)) return false;
        while (length > Beside * size)
        {
            double before = length;
            normal += bend.Step(aside);
            normal *= 1 / normal.Length;
            w = Support(ref a, ref b, frame, normal, ref state, ref end);
            cost = Double3.Dot(normal, w);
            aside = w - normal * cost;
            length = aside.Length;
            if (!(length <= Left * before)) return false;
        }

        return true;
    }

    /// <summary>How fast the support moves as the normal turns.</summary>
    private static Double3 Slope(
        ref TA a, ref TB b, in PairFrame frame, in Double3 normal, in Double3 across, ref SolverState state,
        ref DifferenceVertex end)
    {
        Double3 step = across * DifferenceAngle;
        Double3 after = Support(ref a, ref b, frame, normal + step, ref state, ref end);
        return (after - Support(ref a, ref b, frame, normal - step, ref state, ref end)) * (0.5 / DifferenceAngle);
    }

    private static Double3 Support(
        ref TA a, ref TB b, in PairFrame frame, in Double3 normal, ref SolverState state, ref DifferenceVertex end)
    {
        state.Iterations++;
        MinkowskiDifference.Support(ref a, ref b, frame, -normal, ref end, out Double3 w);
        return w;
    }
}
