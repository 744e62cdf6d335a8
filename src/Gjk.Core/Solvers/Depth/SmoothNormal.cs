namespace Gjk.Core;

/// <summary>The direction of the shortest way out of curved shapes, by Newton's method from where a search for the
/// depth ended: that search knows the depth to within a length, which leaves the direction open by its root.</summary>
/// <remarks>
/// <para>The way out along n costs h(n) = n·w, where w is the support point of A - B along n. Across n its slope is
/// w's part across it, and its second derivative is how w moves as n turns, less h; differences of supports give that. Where
/// w jumps, from one end of a line of A - B to the other, the shortest way is across that line, and only the other
/// direction is searched.</para>
/// <para>Nothing is assumed. The direction is taken if its way out costs no more than the known one and ends on the
/// support point, or on the line. Where w jumps in both directions, n is the normal of a facet, which the search knows;
/// where h hardly bends, as about a common axis, all directions are as good, and the known one stays.</para>
/// </remarks>
internal static class SmoothNormal
{
    /// <summary>Radians: half of what the normal is turned by for a difference. Its square is what the difference may
    /// be off by, and what rounding does to supports is a part of 1e-11 of it. Pinned by SmoothNormalTests.</summary>
    private const double Turn = 1e-5;

    /// <summary>Radians: as far to both sides of a line's normal are its ends; above rounding, and so little that the
    /// ends are those along the normal to 1e-7. Four times more or less changes nothing.</summary>
    private const double TurnToEnds = 1e-8;

    /// <summary>Length: a support that moves further in a turn jumps. A curve of a radius of 50 sizes moves it as far.
    /// Four times more or less changes which lines are too short to be seen.</summary>
    private const double Jump = 1e-3;

    /// <summary>Length: a way out that bends less has no sharp direction. Pinned by CoaxialDepthTests.</summary>
    private const double LeastBend = 1e-3;

    /// <summary>Length: how near the end of the way is to the support point or the line; a rounding to float. Four times
    /// more takes directions that are off by as much.</summary>
    private const double Beside = 1.0 / (1 << 23);

    /// <summary>Radians: a search is never off by more, and steps below the second need no further one.</summary>
    private const double MostStep = 0.03, LastStep = 1e-7;

    /// <summary>Count: Newton's steps double the digits from 1e-3 on.</summary>
    private const int MostSteps = 5;

    /// <summary>Makes normal, depth and points sharper where curved shapes overlap.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Sharpen<TA, TB>(ref TA a, ref TB b, in PairFrame frame, ref SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (state.IsCurved && state.Verdict == Verdict.Apart && state.Feature.Height < 0)
            Descend(ref a, ref b, frame, ref state);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Descend<TA, TB>(ref TA a, ref TB b, in PairFrame frame, ref SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        double size = state.Size.Value, length = 1;
        Double3 normal = state.Feature.Normal * (-1 / Math.Sqrt(state.Feature.NormalSquared)), v;
        (Double3 u, _) = new PlaneBasis(normal);
        Simplex.Begin(out Simplex ends);
        bool isLine = false;
        for (int steps = 0; length > LastStep; steps++)
        {
            if (steps == MostSteps) return;
            v = Double3.Cross(normal, u);
            Double3 alongU = Difference(ref a, ref b, frame, normal, u, Turn, ref state, ref ends);
            Double3 alongV = Difference(ref a, ref b, frame, normal, v, Turn, ref state, ref ends);
            Double3 line = alongU.LengthSquared >= alongV.LengthSquared ? alongU : alongV;
            isLine = line.Length > Jump * size;
            if (isLine)
            {
                u = line * (1 / line.Length);
                normal -= u * Double3.Dot(u, normal);
                normal *= 1 / normal.Length;
                v = Double3.Cross(normal, u);
                alongV = Difference(ref a, ref b, frame, normal, v, Turn, ref state, ref ends);
            }

            Double3 w = Support(ref a, ref b, frame, normal, ref state, ref ends, 0);
            double height = Double3.Dot(normal, w), slopeU = isLine ? 0 : Double3.Dot(u, w);
            double slopeV = Double3.Dot(v, w), bendV = Double3.Dot(v, alongV) / (2 * Turn) - height;
            double bendU = isLine ? bendV : Double3.Dot(u, alongU) / (2 * Turn) - height;
            double twist = isLine ? 0 : (Double3.Dot(u, alongV) + Double3.Dot(v, alongU)) / (4 * Turn);
            double determinant = bendU * bendV - twist * twist;
            bool isSharp = bendU > 0 && determinant > LeastBend * size * (bendU + bendV);
            if (!isSharp || bendV > Jump * size / (2 * Turn)) return;
            Double3 step = u * ((twist * slopeV - bendV * slopeU) / determinant)
                + v * ((twist * slopeU - bendU * slopeV) / determinant);
            length = step.Length;
            if (!(length <= MostStep)) return;
            normal += step;
            normal *= 1 / normal.Length;
            if (!isLine) u = new PlaneBasis(normal).U;
            else u -= normal * Double3.Dot(u, normal);
        }

        if (isLine) Difference(ref a, ref b, frame, normal, u, TurnToEnds, ref state, ref ends);
        else Support(ref a, ref b, frame, normal, ref state, ref ends, 0);
        ends.Select(isLine ? 2 : 1, 0, 1, 0, 0);
        Take(normal, ends, ref state);
    }

    /// <summary>Takes the normal if its way out ends on what it touches, and costs no more than the known one.</summary>
    private static void Take(in Double3 normal, in Simplex ends, ref SolverState state)
    {
        Weights weights = ClosestPointWeights.Of(ends);
        Double3 end = ends.PointOf(weights);
        double height = Double3.Dot(normal, end), size = state.Size.Value;
        if (!(height <= GjkTolerances.Noise * size - state.Plane.Distance)) return;
        if (!((end - normal * height).Length <= Beside * size)) return;
        state.Simplex = ends;
        state.Weights = weights;
        new DepthBounds { Normal = normal, Above = height }.Store(ref state, height);
    }

    /// <summary>How far the support moves as the normal turns, from the second slot to the first.</summary>
    private static Double3 Difference<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in Double3 normal, in Double3 across, double turn,
        ref SolverState state, ref Simplex ends)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        Support(ref a, ref b, frame, normal + across * turn, ref state, ref ends, 0)
            - Support(ref a, ref b, frame, normal - across * turn, ref state, ref ends, 1);

    private static Double3 Support<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, in Double3 normal, ref SolverState state, ref Simplex ends, int slot)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        state.Iterations++;
        MinkowskiDifference.Support(ref a, ref b, frame, -normal, ref ends, slot, out Double3 w);
        return w;
    }
}
