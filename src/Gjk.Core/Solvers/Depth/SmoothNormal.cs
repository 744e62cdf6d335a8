namespace Gjk.Core;

/// <summary>The direction of the shortest way out where it ends on a smooth point of A - B, by Newton's method from
/// where a search for the depth has met its bounds: that search knows the depth to within a length, which leaves the
/// direction open by its root.</summary>
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
            double height = Double3.Dot(normal, w), slopeU = Double3.Dot(u, w), slopeV = Double3.Dot(v, w);
            double bendU = Double3.Dot(u, alongU) - height, bendV = Double3.Dot(v, alongV) - height;
            double twist = (Double3.Dot(u, alongV) + Double3.Dot(v, alongU)) / 2;
            double determinant = bendU * bendV - twist * twist;
            if (!(bendU > 0 && determinant > LeastBend * size * (bendU + bendV))) return false;
            Double3 step = u * ((twist * slopeV - bendV * slopeU) / determinant)
                + v * ((twist * slopeU - bendU * slopeV) / determinant);
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
