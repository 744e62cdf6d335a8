namespace Gjk.Core;

/// <summary>The road of every question about a pair: compose the frame, refuse invalid input, solve the cores,
/// finish.</summary>
/// <remarks>Cores are unwrapped first: what is read right after it was written waits for it, and the frame takes its
/// time. The frame is that of the cores, in their own axes, so below it nothing knows of placements. Each pair of cores
/// has a method of its own, whose frame holds no more than these two. Ahead-of-time compilers would make all of them,
/// so for netstandard shapes are solved as they are; the bits are the same.</remarks>
internal static class PairQuery
{
    /// <summary>The distance, written where it is to be: for arrays of results.</summary>
    public static unsafe void Distance(
        in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB, float maxDistance,
        out DistanceResult result)
    {
        var solver = new DistanceSolver<NoTrace>(maxDistance);
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
        ref TA a = ref Inward(shapeA);
        ref TB b = ref Inward(shapeB);
        if (solver.TryFormula(ref a, poseA, ref b, poseB, out result)) return;
#if NET
        bool haveCores = CoreOf.Kind<TA, TB>(ref a) switch
        {
            CoreKind.Box => TryCores<TA, TB, BoxCore, TSolver, TResult>(
                ref a, poseA, ref b, poseB, ref solver, ref result),
            CoreKind.Hull => TryCores<TA, TB, HullCore, TSolver, TResult>(
                ref a, poseA, ref b, poseB, ref solver, ref result),
            CoreKind.Segment => TryCores<TA, TB, SegmentCore, TSolver, TResult>(
                ref a, poseA, ref b, poseB, ref solver, ref result),
            CoreKind.Triangle => TryCores<TA, TB, TriangleCore, TSolver, TResult>(
                ref a, poseA, ref b, poseB, ref solver, ref result),
            _ => false,
        };
        if (haveCores) return;
#endif
        if (CoreOf.IsPlaced(ref a) || CoreOf.IsPlaced(ref b))
            SolveCopies(ref a, poseA, ref b, poseB, ref solver, out result);
        else Solve(ref a, ref a, poseA, ref b, ref b, poseB, ref solver, out result);
    }

#if NET
    /// <summary>Solves a pair whose first core is known, if there is a second.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool TryCores<TA, TB, TCoreA, TSolver, TResult>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TSolver solver, ref TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TCoreA : struct, ISupportMap
        where TSolver : struct, IPairSolver<TResult> => CoreOf.Kind<TB, TA>(ref b) switch
        {
            CoreKind.Box => SolveCores<TA, TB, TCoreA, BoxCore, TSolver, TResult>(
                ref a, poseA, ref b, poseB, ref solver, out result),
            CoreKind.Hull => SolveCores<TA, TB, TCoreA, HullCore, TSolver, TResult>(
                ref a, poseA, ref b, poseB, ref solver, out result),
            CoreKind.Segment => SolveCores<TA, TB, TCoreA, SegmentCore, TSolver, TResult>(
                ref a, poseA, ref b, poseB, ref solver, out result),
            CoreKind.Triangle => SolveCores<TA, TB, TCoreA, TriangleCore, TSolver, TResult>(
                ref a, poseA, ref b, poseB, ref solver, out result),
            _ => false,
        };

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static bool SolveCores<TA, TB, TCoreA, TCoreB, TSolver, TResult>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TSolver solver, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TCoreA : struct, ISupportMap
        where TCoreB : struct, ISupportMap
        where TSolver : struct, IPairSolver<TResult>
    {
        CoreOf.Get(ref a, out TCoreA coreA);
        CoreOf.Get(ref b, out TCoreB coreB);
        Solve(ref a, ref coreA, poseA, ref b, ref coreB, poseB, ref solver, out result);
        return true;
    }
#endif

    /// <summary>Solves shapes without their placements.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void SolveCopies<TA, TB, TSolver, TResult>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TSolver solver, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TSolver : struct, IPairSolver<TResult>
    {
        TA coreA = ShapeTraits<TA>.Of.InCoreAxes(a, out _);
        TB coreB = ShapeTraits<TB>.Of.InCoreAxes(b, out _);
        Solve(ref a, ref coreA, poseA, ref b, ref coreB, poseB, ref solver, out result);
    }

    /// <summary>Composes, refuses, solves and finishes.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static unsafe void Solve<TA, TB, TCoreA, TCoreB, TSolver, TResult>(
        ref TA a, ref TCoreA coreA, in RigidPose poseA, ref TB b, ref TCoreB coreB, in RigidPose poseB,
        ref TSolver solver, out TResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TCoreA : struct, ISupportMap
        where TCoreB : struct, ISupportMap
        where TSolver : struct, IPairSolver<TResult>
    {
#if NET
        Uncleared.Begin(out PairFrame frame);
        Uncleared.Begin(out SolverState state);
#else
        // Mono clears locals, a kilobyte of them, but not what is allocated.
        byte* memory = stackalloc byte[sizeof(PairFrame) + sizeof(SolverState)];
        ref PairFrame frame = ref *(PairFrame*)memory;
        ref SolverState state = ref *(SolverState*)(memory + sizeof(PairFrame));
#endif
        if (CoreOf.IsPlaced(ref a) || CoreOf.IsPlaced(ref b))
            PairFrame.ComposePlaced(a, poseA, b, poseB, out frame);
        else PairFrame.Compose(ref coreA, poseA, ref coreB, poseB, out frame);
        if (!solver.TryBegin(ref a, ref b, poseA, ref frame, out result)) return;
        SolverState.Begin<TCoreA, TCoreB>(frame, out state);
        if (frame.IsOrdinary) solver.Solve(ref coreA, ref coreB, ref frame, ref state);
        else SolveInUnitSize(ref coreA, ref coreB, ref frame, ref solver, ref state);
        solver.Finish(state, frame, poseA, poseB, out result);
    }

    /// <summary>Solves a pair whose products would leave the range of double in its own units.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void SolveInUnitSize<TA, TB, TSolver>(
        ref TA a, ref TB b, ref PairFrame frame, ref TSolver solver, ref SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TSolver : struct, ICoreSolver
    {
        frame.TightenRadii(ref a, ref b);
        double factor = frame.UnitFactor;
        frame.ToUnitSize(factor);
        var unitA = new UnitSized<TA>(a, factor);
        var unitB = new UnitSized<TB>(b, factor);
        SolverState.Begin<TA, TB>(frame, out state);
        solver.Solve(ref unitA, ref unitB, ref frame, ref state);
    }

    /// <summary>A reference to a readonly argument, so that calls on it make no copies; nothing writes through it but a
    /// shape's own mistakes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
#if NET
    public static ref T Inward<T>(in T shape)
        where T : struct =>
        ref Unsafe.AsRef(in shape);
#else
    public static unsafe ref T Inward<T>(in T shape)
        where T : struct
    {
#pragma warning disable CS8500 // The pointer is a reference again before the garbage collector may move the shape.
        fixed (T* same = &shape) return ref *same;
#pragma warning restore CS8500
    }
#endif
}
