namespace Gjk.Core;

/// <summary>The road of every question about a pair: compose the frame, refuse invalid input, solve the cores,
/// finish.</summary>
/// <remarks>Cores are unwrapped first: what is read right after it was written waits for it, and the frame takes its
/// time. The frame is that of the cores, in their own axes, so below it nothing knows of placements. Each pair of cores
/// has a method of its own, whose frame holds no more than these two. Ahead-of-time compilers make them all, some
/// megabytes of code; so for netstandard two boxes or two capsules are unwrapped, and others are solved as they are,
/// with the same bits.</remarks>
internal static class PairQuery
{
    /// <summary>The distance, written where it is to be: for arrays of results.</summary>
    public static unsafe void Distance(
        in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB, WarmStart* warm, float maxDistance,
        out DistanceResult result)
    {
        var solver = new DistanceSolver<NoTrace>(maxDistance, warm);
        Run(a, poseA, b, poseB, ref solver, out result);
    }

    /// <summary>The signed distance, written where it is to be.</summary>
    public static void SignedDistance(
        in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB, out DistanceResult result)
    {
        var solver = new SignedDistanceSolver<NoPolytopeTrace>();
        Run(a, poseA, b, poseB, ref solver, out result);
    }

    /// <summary>Asks a solver about two shapes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Run<TA, TB, TSolver, TResult>(
        in TA shapeA, in RigidPose poseA, in TB shapeB, in RigidPose poseB, ref TSolver solver, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TSolver : struct, IPairSolver<TResult>
    {
        ref TA a = ref AsRef(shapeA);
        ref TB b = ref AsRef(shapeB);
        if (solver.TryFormula(ref a, poseA, ref b, poseB, out result)
            || PairQuery<TA, TB, TSolver, TResult>.TryCores(ref a, poseA, ref b, poseB, ref solver, ref result))
        {
            return;
        }

        if (HalfSpacePair.IsHalfSpace(ref a) || HalfSpacePair.IsHalfSpace(ref b))
            HalfSpacePair.Solve(ref a, poseA, ref b, poseB, ref solver, out result);
        else if (CoreOf.IsPlaced(ref a) || CoreOf.IsPlaced(ref b))
            PairQuery<TA, TB, TSolver, TResult>.SolveCopies(ref a, poseA, ref b, poseB, ref solver, out result);
        else
            PairQuery<TA, TB, TSolver, TResult>.SolveAsIs(ref a, poseA, ref b, poseB, ref solver, out result);
    }

    /// <summary>A reference to a readonly argument, so that calls on it make no copies; nothing writes through it but a
    /// shape's own mistakes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ref T AsRef<T>(in T shape)
        where T : struct => ref UnsafeRef.At(shape, 0);
}

/// <summary>The road of one kind of pair, after the formulas.</summary>
internal static class PairQuery<TA, TB, TSolver, TResult>
    where TA : struct, ISupportMap
    where TB : struct, ISupportMap
    where TSolver : struct, IPairSolver<TResult>
{
    /// <summary>Solves a pair of two cores, if both have one.</summary>
    [MethodImpl(Jit.Step)]
    public static bool TryCores(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TSolver solver, ref TResult result)
#if NET
        => CoreOf.Kind<TA, TB>(ref a) switch
        {
            FormKind.Box => TryCores<BoxCore>(ref a, poseA, ref b, poseB, ref solver, ref result),
            FormKind.Hull => TryCores<HullCore>(ref a, poseA, ref b, poseB, ref solver, ref result),
            FormKind.Segment => TryCores<SegmentCore>(ref a, poseA, ref b, poseB, ref solver, ref result),
            FormKind.Triangle => TryCores<TriangleCore>(ref a, poseA, ref b, poseB, ref solver, ref result),
            _ => false,
        };

    /// <summary>Solves a pair whose first core is known, if there is a second.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool TryCores<TCoreA>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TSolver solver, ref TResult result)
        where TCoreA : struct, ISupportMap => CoreOf.Kind<TB, TA>(ref b) switch
        {
            FormKind.Box => SolveCores<TCoreA, BoxCore>(ref a, poseA, ref b, poseB, ref solver, out result),
            FormKind.Hull => SolveCores<TCoreA, HullCore>(ref a, poseA, ref b, poseB, ref solver, out result),
            FormKind.Segment => SolveCores<TCoreA, SegmentCore>(ref a, poseA, ref b, poseB, ref solver, out result),
            FormKind.Triangle => SolveCores<TCoreA, TriangleCore>(ref a, poseA, ref b, poseB, ref solver, out result),
            _ => false,
        };

#else
    {
        FormKind kind = CoreOf.Kind<TA, TB>(ref a);
        if (kind == FormKind.None || kind != CoreOf.Kind<TB, TA>(ref b)) return false;
        return kind switch
        {
            FormKind.Box => SolveCores<BoxCore, BoxCore>(ref a, poseA, ref b, poseB, ref solver, out result),
            FormKind.Segment =>
                SolveCores<SegmentCore, SegmentCore>(ref a, poseA, ref b, poseB, ref solver, out result),
            _ => false,
        };
    }
#endif

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static unsafe bool SolveCores<TCoreA, TCoreB>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TSolver solver, out TResult result)
        where TCoreA : struct, ISupportMap
        where TCoreB : struct, ISupportMap
    {
#if NET
        UnsafeRef.SkipInit(out TCoreA coreA);
        UnsafeRef.SkipInit(out TCoreB coreB);
        UnsafeRef.SkipInit(out PairMemory memory);
#else
#pragma warning disable CS8500 // These cores hold no references.
        // Mono clears locals one by one, by a call for each large one; this at once.
        byte* room = stackalloc byte[sizeof(TCoreA) + sizeof(TCoreB) + sizeof(PairMemory)];
        ref TCoreA coreA = ref *(TCoreA*)room;
        ref TCoreB coreB = ref *(TCoreB*)(room + sizeof(TCoreA));
        ref PairMemory memory = ref *(PairMemory*)(room + sizeof(TCoreA) + sizeof(TCoreB));
#pragma warning restore CS8500
#endif
        CoreOf.Get(ref a, out coreA);
        CoreOf.Get(ref b, out coreB);
        Solve(ref a, ref coreA, poseA, ref b, ref coreB, poseB, ref memory, ref solver, out result);
        return true;
    }

    /// <summary>Solves shapes without their placements.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static unsafe void SolveCopies(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TSolver solver, out TResult result)
    {
#if NET
        UnsafeRef.SkipInit(out PairMemory memory);
#else
        byte* room = stackalloc byte[sizeof(PairMemory)];
        ref PairMemory memory = ref *(PairMemory*)room;
#endif
        TA coreA = ShapeTraits<TA>.Instance.InCoreAxes(a);
        TB coreB = ShapeTraits<TB>.Instance.InCoreAxes(b);
        Solve(ref a, ref coreA, poseA, ref b, ref coreB, poseB, ref memory, ref solver, out result);
    }

    /// <summary>Solves shapes as they are.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static unsafe void SolveAsIs(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TSolver solver, out TResult result)
    {
#if NET
        UnsafeRef.SkipInit(out PairMemory memory);
#else
        byte* room = stackalloc byte[sizeof(PairMemory)];
        ref PairMemory memory = ref *(PairMemory*)room;
#endif
        Solve(ref a, ref a, poseA, ref b, ref b, poseB, ref memory, ref solver, out result);
    }

    /// <summary>Composes, refuses, solves and finishes, in memory that the caller has for it: Mono inlines no method
    /// that takes some from the stack.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Solve<TCoreA, TCoreB>(
        ref TA a, ref TCoreA coreA, in RigidPose poseA, ref TB b, ref TCoreB coreB, in RigidPose poseB,
        ref PairMemory memory, ref TSolver solver, out TResult result)
        where TCoreA : struct, ISupportMap
        where TCoreB : struct, ISupportMap
    {
        ref PairFrame frame = ref memory.Frame;
        ref SolverState state = ref memory.State;
        if (CoreOf.IsPlaced(ref a) || CoreOf.IsPlaced(ref b))
            PairFrame.ComposePlaced(
                ref coreA, poseA, ShapeTraits<TA>.Instance.PlacementOf(ref a), ref coreB, poseB,
                ShapeTraits<TB>.Instance.PlacementOf(ref b), out frame);
        else
            PairFrame.Compose(ref coreA, poseA, ref coreB, poseB, out frame);
        if (!solver.TryBegin(ref a, ref b, poseA, ref frame, out result)) return;
        SolverState.Make<TCoreA, TCoreB>(frame, out state);
        if (frame.IsOrdinary) solver.Solve(ref coreA, ref coreB, ref frame, ref state);
        else SolveInUnitSize(ref coreA, ref coreB, ref frame, ref solver, ref state);
        solver.Finish(state, frame, poseA, poseB, out result);
    }

    /// <summary>Solves a pair whose products would leave the range of double in its own units.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void SolveInUnitSize<TCoreA, TCoreB>(
        ref TCoreA a, ref TCoreB b, ref PairFrame frame, ref TSolver solver, ref SolverState state)
        where TCoreA : struct, ISupportMap
        where TCoreB : struct, ISupportMap
    {
        frame.TightenRadii(ref a, ref b);
        double factor = frame.UnitFactor;
        frame.ToUnitSize(factor);
        var unitA = new UnitSized<TCoreA>(a, factor);
        var unitB = new UnitSized<TCoreB>(b, factor);
        SolverState.Make<TCoreA, TCoreB>(frame, out state);
        solver.Solve(ref unitA, ref unitB, ref frame, ref state);
    }
}

/// <summary>The memory that a pair is solved in.</summary>
internal struct PairMemory
{
    public PairFrame Frame;
    public SolverState State;
}

/// <summary>One of the questions about a pair of shapes: what <see cref="PairQuery"/> runs.</summary>
/// <typeparam name="TResult">The answer's type.</typeparam>
internal interface IPairSolver<TResult> : ICoreSolver
{
    /// <summary>Answers pairs of which a formula knows the answer, before anything is composed.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Its pose in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Its pose.</param>
    /// <param name="result">Written where it is to be: each copy of it costs Mono as much as a support.</param>
    bool TryFormula<TA, TB>(ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap;

    /// <summary>Answers a pair of which one shape is a half-space.</summary>
    /// <param name="pair">The pair, measured.</param>
    /// <param name="other">The other shape, in the axes of its core.</param>
    /// <param name="otherPose">Its pose.</param>
    /// <param name="result">In the order of the query.</param>
    void SolveHalfSpace<T>(ref HalfSpacePair pair, ref T other, in RigidPose otherPose, out TResult result)
        where T : struct, ISupportMap;

    /// <summary>Refuses invalid input, and pairs of which the frame tells all.</summary>
    bool TryBegin<TA, TB>(ref TA a, ref TB b, in RigidPose poseA, ref PairFrame frame, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap;

    /// <summary>Makes the answer of what the solver found.</summary>
    void Finish(in SolverState state, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, out TResult result);
}

/// <summary>What is solved for two cores.</summary>
internal interface ICoreSolver
{
    /// <summary>Runs in the frame's units, which are ordinary.</summary>
    void Solve<TA, TB>(ref TA a, ref TB b, ref PairFrame frame, ref SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap;
}
