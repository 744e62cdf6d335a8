using System;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

public static partial class ConvexQuery
{
    /// <summary>
    /// Whether two convex shapes share a point, touching included: exactly when <c>Distance(a, b)</c> says
    /// <see cref="GjkStatus.Overlapping"/>, for supports in double.
    /// </summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <returns>False too when the input is invalid; the other overload tells.</returns>
    public static bool Overlaps<TA, TB>(in TA a, in RigidPose poseA, in TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap =>
        Overlaps(a, poseA, b, poseB, out _);

    /// <summary>As the other, with the status: Separated, Overlapping, or why there is no answer.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="status">Separated or Overlapping; otherwise why the return value is false.</param>
    /// <returns>True when the shapes share a point.</returns>
    public static bool Overlaps<TA, TB>(in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, out GjkStatus status)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        status = StatusOf(ref PairProblem.Inward(a), poseA, ref PairProblem.Inward(b), poseB);
        return status == GjkStatus.Overlapping;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static GjkStatus StatusOf<TA, TB>(ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (AreBalls(ref a, ref b)) return StatusOfBalls(ref a, poseA, ref b, poseB);
        if (AreBallsApart(ref a, poseA, ref b, poseB)) return GjkStatus.Separated;
        OverlapQuestion question = default;
        CoreDispatch.Ask<TA, TB, OverlapQuestion, GjkStatus>(
            ref a, poseA, ref b, poseB, ref question, out GjkStatus status);
        return status;
    }

    /// <summary>
    /// Whether valid shapes are so far apart that their balls show it, wherever their centres are turned to: by more
    /// than rounding could close. No rotation is looked at.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static bool AreBallsApart<TA, TB>(ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        double radiusA = a.BoundingRadius + a.Center.SumOfMagnitudes;
        double radiusB = b.BoundingRadius + b.Center.SumOfMagnitudes;
        double reach = (radiusA + radiusB) * (1 + GjkTolerances.SeparatedBandCurved);
        double distanceSquared = Double3.Between(poseA.Position, poseB.Position).LengthSquared;
        return distanceSquared > reach * reach & a.Margin >= 0 & b.Margin >= 0 & radiusA >= 0 & radiusB >= 0
            && PairFrame.IsOrdinarySize(distanceSquared) && poseA.IsValid && poseB.IsValid;
    }

    /// <summary>Whether two cores overlap.</summary>
    private struct OverlapQuestion : IPairProblem<GjkStatus, GjkStatus>
    {
        public readonly bool IsValid => true;

        public readonly void Refuse(out GjkStatus result) =>
            result = GjkStatus.InvalidInput;

        [MethodImpl(MethodImplOptions.NoInlining)]
        void IPairQuestion<GjkStatus>.Ask<TA, TB>(
            ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, in PairPlacement placement,
            out GjkStatus result) =>
            PairProblem.Answer<TA, TB, OverlapQuestion, GjkStatus, GjkStatus>(
                ref a, poseA, ref b, poseB, placement, ref this, out result);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly void Solve<TA, TB>(ref TA a, ref TB b, ref PairFrame frame, out GjkStatus status)
            where TA : struct, ISupportMap
            where TB : struct, ISupportMap
        {
            Verdict verdict = QuickVerdict(ref a, ref b, frame);
            status = verdict == Verdict.Apart ? GjkStatus.Separated
                : verdict == Verdict.Enclosed ? GjkStatus.Overlapping : StatusByDistance(ref a, ref b, frame);
        }

        readonly void IPairProblem<GjkStatus, GjkStatus>.Finish(
            in GjkStatus status, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, out GjkStatus result) =>
            result = status;
    }

    /// <summary>Apart or Enclosed where rounding cannot change the answer.</summary>
    private static Verdict QuickVerdict<TA, TB>(ref TA a, ref TB b, in PairFrame frame)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        // The balls around the shapes are apart by more than rounding could close, and so are the shapes.
        double reach = frame.Radius * (1 + GjkTolerances.SeparatedBandCurved);
        if (frame.Translation.LengthSquared > reach * reach) return Verdict.Apart;
        return frame.Margins == 0 ? GjkOverlap.Solve(ref a, ref b, frame) : Verdict.Undecided;
    }

    /// <summary>What the distance query says, which need not go further than to see the shapes apart.</summary>
    private static GjkStatus StatusByDistance<TA, TB>(ref TA a, ref TB b, in PairFrame frame)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        NoTrace trace = default;
        WarmStart unused = default;
        SolverState.Begin<TA, TB>(frame, out SolverState state);
        ProvedDistance.SolveCores(ref a, ref b, frame, 0, ref unused, false, ref state, ref trace);
        if (state.Verdict == Verdict.Apart)
        {
            double distance = Proofs.DistanceOf(state, frame, 1 / Math.Sqrt(state.Feature.NormalSquared));
            return Proofs.IsTouching(state, distance) ? GjkStatus.Overlapping : GjkStatus.Separated;
        }

        return state.Verdict switch
        {
            Verdict.Enclosed => GjkStatus.Overlapping,
            Verdict.Beyond => GjkStatus.Separated,
            Verdict.Contradiction => GjkStatus.InvalidShape,
            _ => GjkStatus.IterationLimit,
        };
    }
}
