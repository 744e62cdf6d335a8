namespace Gjk.Core;

/// <summary>The signed distance of two cores: apart, that of the distance solvers; overlapping, the depth, as a feature
/// of negative height.</summary>
/// <remarks>
/// <para>Without margins the depth is asked first, unless the balls around the shapes are apart: shapes that are worth
/// the question mostly overlap, and a plane that separates them is found on the way; two boxes have a search of their
/// own, which all shapes that are boxes share.
/// Within the band where rounding could turn the answer, the distance decides whether the shapes touch, so that both
/// queries agree. With margins the distance of the cores is asked first: most rounded shapes overlap by their margins
/// alone, and then it is all that is needed.</para>
/// <para>Verdicts: those of <see cref="GjkDistance"/> without Enclosed. Apart holds for overlapping shapes too, whose
/// feature has a height of 0 or less; Undecided means that there was no room, and the feature and the plane are the
/// bounds.</para>
/// </remarks>
internal static class SignedSolver<TA, TB, TTrace>
    where TA : struct, ISupportMap
    where TB : struct, ISupportMap
    where TTrace : struct, IPolytopeTrace
{
    /// <summary>Solves from the warm start, if there is one, and keeps where it ended.</summary>
    /// <remarks>The trace is told of the search for the depth alone; <c>Explain</c> tells of the distance.</remarks>
    public static void Solve(
        ref TA a, ref TB b, in PairFrame frame, ref WarmStart warmStart, bool isWarm,
        ref SolverState state, ref TTrace trace)
    {
        Begin(ref a, ref b, frame, warmStart, isWarm, ref state);
        if (frame.Margins == 0 && (trace.IsOn || !Proofs.AreBallsApart(frame)))
            SolveDepthFirst(ref a, ref b, frame, warmStart, isWarm, ref state, ref trace);
        else SolveDistanceFirst(ref a, ref b, frame, warmStart, isWarm, ref state, ref trace);
        if (isWarm) warmStart.Save(state);
        if (SmoothNormal<TA, TB>.TrySharpen(ref a, ref b, frame, ref state)) return;
        NoTrace untold = default;
        SideNormal<TA, TB, NoTrace>.Sharpen(ref a, ref b, frame, ref state, ref untold);
    }

    private static void SolveDepthFirst(
        ref TA a, ref TB b, in PairFrame frame, in WarmStart warmStart, bool isWarm,
        ref SolverState state, ref TTrace trace)
    {
        PairSize size = state.Size;
        Verdict depth = SolveDepth(ref a, ref b, frame, ref state, ref trace);

        // Within the band either answer could be rounding.
        double band = GjkTolerances.SeparatedBandOf(state.IsCurved) * state.Size.Value + 2 * state.DepthNoise;
        bool isKnown = depth == Verdict.Enclosed || depth == Verdict.Undecided;
        state.Verdict = Signed(depth);
        if (depth == Verdict.Contradiction || (isKnown && -state.Feature.Height > band)) return;

        // As if nothing had been asked before: the answer is that of the distance, bit for bit.
        ClosestFeature across = state.Feature;
        double above = -state.Plane.Value;
        state.Size = size;
        state.IsCurved = false;
        state.Iterations = 0;
        Begin(ref a, ref b, frame, warmStart, isWarm, ref state);
        NoTrace untold = default;
        GjkDistance.Solve(ref a, ref b, frame, double.PositiveInfinity, ref state, ref untold);
        GjkExtendedPrecision.Settle(ref a, ref b, frame, double.PositiveInfinity, isWarm, ref state, ref untold);
        if (state.Verdict != Verdict.Enclosed) return;
        Touch(ref state, across, above);
        if (depth == Verdict.Undecided && above > band) state.Verdict = Verdict.Undecided;
    }

    private static void SolveDistanceFirst(
        ref TA a, ref TB b, in PairFrame frame, in WarmStart warmStart, bool isWarm,
        ref SolverState state, ref TTrace trace)
    {
        NoTrace untold = default;
        GjkDistance.Solve(ref a, ref b, frame, double.PositiveInfinity, ref state, ref untold);
        GjkExtendedPrecision.Settle(ref a, ref b, frame, double.PositiveInfinity, isWarm, ref state, ref untold);
        if (state.Verdict == Verdict.Enclosed) SolveDepthLast(ref a, ref b, frame, ref state, ref trace);
    }

    /// <summary>The depth of cores that overlap or touch.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void SolveDepthLast(
        ref TA a, ref TB b, in PairFrame frame, ref SolverState state, ref TTrace trace)
    {
        Simplex common = state.Simplex;
        Weights weights = state.Weights;
        state.Feature.Normal = frame.FirstNormal;
        Verdict depth = SolveDepth(ref a, ref b, frame, ref state, ref trace);
        state.Verdict = Signed(depth);
        if (depth != Verdict.Flat && depth != Verdict.Apart) return;

        // The cores are flat, or only touch: all of the depth is that of the margins, across them.
        state.Simplex = common;
        state.Weights = weights;
        state.Feature.Height = 0;
        state.Plane.Value = Math.Min(state.Plane.Value, 0);
        state.Verdict = Verdict.Apart;
    }

    /// <summary>Asks the search that is made for the pair, or else the general one. The state gets the weights of the
    /// way's end where the depth is known.</summary>
    private static Verdict SolveDepth(
        ref TA a, ref TB b, in PairFrame frame, ref SolverState state, ref TTrace trace)
    {
        var verdict = Verdict.Undecided;
        if (frame.Margins == 0 && ShapeTraits<TA>.Instance.GetPlain(ref a, out Double3 halfA) == FormKind.Box
            && ShapeTraits<TB>.Instance.GetPlain(ref b, out Double3 halfB) == FormKind.Box)
        {
            if (trace.IsOn) TraceSearch(ref a, ref b, frame, state, ref trace);
            verdict = BoxDepth.Solve(halfA, halfB, frame, ref state);
        }
        else if (MayBeRound(ref a) && MayBeRound(ref b))
        {
            verdict = SolveRound(ref a, ref b, frame, ref state, ref trace);
            if (verdict != Verdict.Undecided) return verdict;
        }

        if (verdict == Verdict.Undecided)
            verdict = GjkDepth<TA, TB, TTrace>.Solve(ref a, ref b, frame, ref state, ref trace);
        if (verdict == Verdict.Undecided) return SolveLarge(ref a, ref b, frame, ref state);
        if (verdict == Verdict.Enclosed) state.Weights = ClosestPointWeights.Of(state.Simplex);
        return verdict;
    }

    /// <summary>Round bodies with a known way out, or a plane that it lies in; Undecided for all others.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static Verdict SolveRound(
        ref TA a, ref TB b, in PairFrame frame, ref SolverState state, ref TTrace trace)
    {
        PairForm.Classify(ref a, ref b, frame, out PairForm form);
        return trace.IsOn
            ? TraceRound(ref a, ref b, frame, form, ref state, ref trace)
            : SolveRound(ref a, ref b, frame, form, ref state);
    }

    private static Verdict SolveRound(
        ref TA a, ref TB b, in PairFrame frame, in PairForm form, ref SolverState state) =>
        form.Way.IsKnown && form.Way.Slope == 0
            ? AxialDepth<TA, TB>.Solve(ref a, ref b, frame, form.Way, ref state)
            : CylinderDepth<TA, TB>.Solve(ref a, ref b, frame, form, ref state);

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static Verdict TraceRound(
        ref TA a, ref TB b, in PairFrame frame, in PairForm form, ref SolverState state, ref TTrace trace)
    {
        SolverState before = state;
        Verdict verdict = SolveRound(ref a, ref b, frame, form, ref state);
        if (verdict != Verdict.Undecided) TraceSearch(ref a, ref b, frame, before, ref trace);
        return verdict;
    }

    /// <summary>What the general search has no room for.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static Verdict SolveLarge(ref TA a, ref TB b, in PairFrame frame, ref SolverState state)
    {
        PairForm.Classify(ref a, ref b, frame, out PairForm form);
        if (form.AreFaceted) return HullDepth<TA, TB>.Solve(ref a, ref b, frame, form, ref state);
        if (form.Way.Slope > 0)
        {
            Verdict leaning = AxialDepth<TA, TB>.Solve(ref a, ref b, frame, form.Way, ref state);
            if (leaning != Verdict.Undecided) return leaning;
        }

        Verdict verdict = CornerDepth<TA, TB>.Solve(ref a, ref b, frame, form, ref state);
        if (verdict == Verdict.Undecided) verdict = DepthCells<TA, TB>.Solve(ref a, ref b, frame, ref state);
        if (state.IsCurved && verdict == Verdict.Enclosed
            && SmoothNormal<TA, TB>.TryEnd(ref a, ref b, frame, DepthBounds.FromState(state), ref state))
            state.Weights = ClosestPointWeights.Of(state.Simplex);
        return verdict;
    }

    /// <summary>Whether a shape may be a round body; the core of a mesh is not, and its form need not be
    /// read.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool MayBeRound<T>(ref T shape)
        where T : struct, ISupportMap =>
        typeof(T) != typeof(HullCore) && typeof(T) != typeof(BoxCore)
        && ShapeTraits<T>.Instance.GetPlain(ref shape, out _) is not (FormKind.Hull or FormKind.Box);

    /// <summary>Other searches have no surface to tell of, so one is grown for the trace alone.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void TraceSearch(ref TA a, ref TB b, in PairFrame frame, in SolverState begin, ref TTrace trace)
    {
        SolverState state = begin;
        GjkDepth<TA, TB, TTrace>.Solve(ref a, ref b, frame, ref state, ref trace);
    }

    /// <summary>Puts the warm start's simplex and normal, or the cold query's, into the state.</summary>
    private static void Begin(
        ref TA a, ref TB b, in PairFrame frame, in WarmStart warmStart, bool isWarm, ref SolverState state)
    {
        state.Simplex.Clear();
        if (isWarm) warmStart.Seed(ref a, ref b, frame, ref state);
        else state.Feature.Normal = frame.FirstNormal;
    }

    /// <summary>The search for the depth has said all that there is to say: a known depth is a feature of negative
    /// height.</summary>
    private static Verdict Signed(Verdict depth) => depth == Verdict.Enclosed ? Verdict.Apart : depth;

    /// <summary>Shapes that the distance calls touching get the direction that the search for the depth found; their
    /// depth is less than rounding can tell.</summary>
    private static void Touch(ref SolverState state, in ClosestFeature across, double above)
    {
        state.Feature = across;
        state.Feature.Height = Math.Min(across.Height, 0);
        state.Plane.Set(across, Math.Min(-above, 0));
        state.Verdict = Verdict.Apart;
    }
}
