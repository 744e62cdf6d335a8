using System;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <summary>The verbs: do two convex shapes overlap, how far apart are they, where are the closest points.</summary>
/// <remarks>
/// Every method is thread-safe, allocates nothing, never throws (exceptions of a shape of your own pass through) and
/// ends on any input. One pipeline serves all of them: compose the frame, refuse invalid input, solve the cores, finish
/// with the margins.
/// </remarks>
public static partial class ConvexQuery
{
    /// <summary>
    /// A reference to a readonly argument, so that calls on it make no copies; nothing writes through it but a shape's
    /// own mistakes.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static ref T Inward<T>(in T shape, ref T copy)
        where T : struct
    {
#if NET
        return ref Unsafe.AsRef(in shape);
#else
        copy = shape;
        return ref copy;
#endif
    }

    /// <summary>The whole pipeline: boxes and meshes are unwrapped first, so that supports need not switch.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static DistanceResult Ask<TA, TB, TTrace>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, float maxDistance, ref WarmStart warmStart,
        bool isWarm, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        TA copyA = default;
        TB copyB = default;
        ref TA shapeA = ref Inward(a, ref copyA);
        ref TB shapeB = ref Inward(b, ref copyB);
        if (!trace.IsOn && AreBalls(ref shapeA, ref shapeB))
            return AskBalls(ref shapeA, poseA, ref shapeB, poseB, maxDistance);
#if NET
        return AskByKind(ref shapeA, poseA, ref shapeB, poseB, maxDistance, ref warmStart, isWarm, ref trace);
#else
        return AskCores(ref shapeA, poseA, ref shapeB, poseB, maxDistance, ref warmStart, isWarm, ref trace);
#endif
    }

    /// <summary>The pipeline.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="maxDistance">Ends early beyond it; NaN is invalid input.</param>
    /// <param name="warmStart">
    /// Where a warm query begins, and what it stores; neither read nor written by a cold one.
    /// </param>
    /// <param name="isWarm">Whether this is a warm query.</param>
    /// <param name="trace">Told what the solvers do.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static DistanceResult AskCores<TA, TB, TTrace>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, float maxDistance, ref WarmStart warmStart,
        bool isWarm, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        Solve(
            ref a, poseA, ref b, poseB, maxDistance, ref warmStart, isWarm, ref trace, out PairFrame frame,
            out SolverState state);
        return trace.IsOn && frame.ArePoints
            ? AskBalls(ref a, poseA, ref b, poseB, maxDistance)
            : Finish(state, frame, poseA, poseB, maxDistance);
    }

    /// <summary>
    /// The pipeline up to the margins. A verdict of Contradiction without iterations stands for invalid input.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Solve<TA, TB, TTrace>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, float maxDistance, ref WarmStart warmStart,
        bool isWarm, ref TTrace trace, out PairFrame frame, out SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        PairFrame.Compose(ref a, poseA, ref b, poseB, out frame);
        SolverState.Begin<TA, TB>(frame, out state);
        if (!frame.IsValid || float.IsNaN(maxDistance)) state.Verdict = Verdict.Contradiction;
        else SolveFrame(ref a, ref b, ref frame, maxDistance, ref warmStart, isWarm, ref state, ref trace);
    }

    /// <summary>The pipeline from a valid frame on.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void SolveFrame<TA, TB, TTrace>(
        ref TA a, ref TB b, ref PairFrame frame, float maxDistance, ref WarmStart warmStart, bool isWarm,
        ref SolverState state, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        if (frame.ArePoints)
        {
            GjkDistance.SolvePoints(frame, ref state);
            if (trace.IsOn) TellPoints(frame, state, ref trace);
        }
        else if (frame.IsOrdinary)
        {
            SolveCores(ref a, ref b, frame, maxDistance, ref warmStart, isWarm, ref state, ref trace);
        }
        else
        {
            SolveInUnitSize(ref a, ref b, ref frame, maxDistance, ref warmStart, isWarm, ref state, ref trace);
        }
    }

    /// <summary>Solves the cores, from the warm start if there is one.</summary>
    internal static void SolveCores<TA, TB, TTrace>(
        ref TA a, ref TB b, in PairFrame frame, float maxDistance, ref WarmStart warmStart, bool isWarm,
        ref SolverState state, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        double reach = CoreReach(maxDistance, frame);
        if (isWarm) warmStart.Begin(ref a, ref b, frame, ref state);
        else state.Feature.Normal = frame.FirstNormal;
        ProvedDistance.Solve(ref a, ref b, frame, reach, isWarm, ref state, ref trace);
        if (isWarm) warmStart.Keep(state);
        SideNormal.Sharpen(ref a, ref b, frame, ref state, ref trace);
    }

    /// <summary>The same for pairs whose lengths would leave the range of double when they are multiplied.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void SolveInUnitSize<TA, TB, TTrace>(
        ref TA a, ref TB b, ref PairFrame frame, float maxDistance, ref WarmStart warmStart, bool isWarm,
        ref SolverState state, ref TTrace trace)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        ToUnitSize(ref a, ref b, ref frame, ref state, out UnitSized<TA> unitA, out UnitSized<TB> unitB);
        SolveCores(ref unitA, ref unitB, frame, maxDistance, ref warmStart, isWarm, ref state, ref trace);
    }

    /// <summary>Brings the pair and its frame to unit size.</summary>
    private static void ToUnitSize<TA, TB>(
        ref TA a, ref TB b, ref PairFrame frame, ref SolverState state, out UnitSized<TA> unitA,
        out UnitSized<TB> unitB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        frame.TightenRadii(ref a, ref b);
        double factor = frame.UnitFactor;
        frame.ToUnitSize(factor);
        unitA = new UnitSized<TA>(a, factor);
        unitB = new UnitSized<TB>(b, factor);
        PairSize.Begin<TA, TB>(frame, out state.Size);
    }

    /// <summary>
    /// How far apart the cores may be before the query may end early; the bands keep its answer that of the full query.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double CoreReach(float maxDistance, in PairFrame frame) =>
        ShapeReach(maxDistance) / frame.Unit + frame.Margins + GjkTolerances.SeparatedBandCurved * frame.Radius;

    /// <summary>How far apart the shapes may be, in world units.</summary>
    internal static double ShapeReach(float maxDistance) =>
        Math.Max(maxDistance, 0.0) * (1 + GjkTolerances.FloatBand) + float.Epsilon;

    /// <summary>The closed form of two points, told as the loop's only round.</summary>
    private static void TellPoints<TTrace>(in PairFrame frame, in SolverState state, ref TTrace trace)
        where TTrace : struct, IGjkTrace
    {
        trace.OnSupport(
            new TracedSupport(frame, frame.FirstNormal, state.Simplex, state.Simplex.A, isExtended: false));
        trace.OnReduced(new TracedSimplex(state.Simplex, frame.Unit, isExtended: false));
    }
}
