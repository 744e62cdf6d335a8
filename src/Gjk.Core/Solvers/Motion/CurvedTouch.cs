namespace Gjk.Core;

/// <summary>Whether curved shapes that overlap by a trifle only touch. The search for a depth of curved cores ends
/// within 1e-6 of the size, a distance within 1e-9; so B is moved out of A by a known length, and the distance there is
/// held against it.</summary>
/// <remarks>The plane that separates the shapes there bounds the depth where B was, soundly. The bound is sharp where
/// its normal is that of the shortest way out: one that is off by an angle costs half its square of the length. So B is
/// moved out twice: the second time along the normal that was found the first time, which is sharper than that of the
/// depth.</remarks>
internal static class CurvedTouch<TA, TB>
    where TA : struct, ISupportMap
    where TB : struct, ISupportMap
{
    /// <summary>Ratio to the size: how far B is moved out, far above the depth and below the shapes' radii. Four times
    /// more or less changes nothing but how many rounds are enough. Pinned by TouchingStartTests.</summary>
    private const double Retreat = 1e-3;

    /// <summary>Count: how often B is moved out. Once is too few: pinned by RayStartTests. More are only
    /// slower.</summary>
    private const int MaxRounds = 2;

    /// <summary>Ratio to the size: what is deeper is deep, whatever the search leaves open (5e-7 where it has to divide
    /// its surface), and is not looked at. A larger one is only slower; a quarter would do where nothing is
    /// divided.</summary>
    private const double Shallow = 4 * GjkTolerances.DepthNoiseCurved;

    /// <summary>Whether the shapes overlap by no more than counts as touching, and where they touch.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">The pair.</param>
    /// <param name="state">Its signed distance.</param>
    /// <param name="touch">Gets normal and point, as sharp as those of a cast.</param>
    public static bool TryFind(
        ref TA a, ref TB b, in PairFrame frame, in SolverState state, out CastFinding touch)
    {
        touch = default;
        return TryMeasureGap(ref a, ref b, frame, state, ref touch, out double gap)
            && gap >= -GjkTolerances.TouchCurved * state.Size.Value;
    }

    /// <summary>Measures the gap of shapes that overlap by less than the search for a depth can tell.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">The pair.</param>
    /// <param name="state">Its signed distance.</param>
    /// <param name="touch">Gets normal and point, as sharp as those of a cast; the iterations are added.</param>
    /// <param name="gap">The gap between the planes across the normal, in solver units: at most the signed distance,
    /// and sharp where the normal is that of the shortest way out.</param>
    /// <returns>False where they are deeper.</returns>
    public static bool TryMeasureGap(
        ref TA a, ref TB b, in PairFrame frame, in SolverState state, ref CastFinding touch, out double gap)
    {
        gap = double.NegativeInfinity;
        double size = state.Size.Value, scale = 1 / Math.Sqrt(state.Feature.NormalSquared);
        if (frame.Margins - state.Feature.Height * scale > Shallow * size) return false;
        touch.Normal = state.Feature.Normal * -scale;
        PairFrame moved = frame;
        NoTrace trace = default;
        for (int round = 0; round < MaxRounds && !(gap >= -GjkTolerances.TouchCurved * size); round++)
        {
            moved.Translation = frame.Translation + touch.Normal * (Retreat * size);
            SolverState.Make<TA, TB>(moved, out SolverState apart);
            apart.Feature.Normal = moved.FirstNormal;
            GjkDistance.Solve(ref a, ref b, moved, double.PositiveInfinity, ref apart, ref trace);
            GjkExtendedPrecision.Settle(ref a, ref b, moved, double.PositiveInfinity, false, ref apart, ref trace);
            SideNormal<TA, TB, NoTrace>.Sharpen(ref a, ref b, moved, ref apart, ref trace);
            touch.Iterations += apart.Iterations;
            if (apart.Verdict != Verdict.Apart) return false;
            touch.Normal = apart.Plane.Normal * (-1 / Math.Sqrt(apart.Plane.NormalSquared));
            touch.OnA = apart.Simplex.WitnessOnA(apart.Weights);
            CastLine outward = default;
            outward.Axis = -touch.Normal;
            moved.Translation = frame.Translation;
            gap = CastNormal<TA, TB>.Sharpen(ref a, ref b, ref moved, outward, ref apart, ref touch);
        }

        return true;
    }
}
