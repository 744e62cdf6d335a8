namespace Gjk.Core;

/// <summary>Whether a pair overlaps.</summary>
internal struct OverlapSolver : IPairSolver<GjkStatus>
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    readonly bool IPairSolver<GjkStatus>.TryFormula<TA, TB>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, out GjkStatus result)
    {
        result = GjkStatus.Separated;
        if (!Balls.AreBalls(ref a, ref b)) return AreBallsApart(ref a, poseA, ref b, poseB);
        result = Balls.Status(ref a, poseA, ref b, poseB);
        return true;
    }

    readonly void IPairSolver<GjkStatus>.SolveHalfSpace<T>(
        ref HalfSpacePair pair, ref T other, in RigidPose otherPose, out GjkStatus result) => result = pair.Status;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    readonly bool IPairSolver<GjkStatus>.TryBegin<TA, TB>(
        ref TA a, ref TB b, in RigidPose poseA, ref PairFrame frame, out GjkStatus result)
    {
        result = GjkStatus.InvalidInput;
        return frame.IsValid;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    readonly void ICoreSolver.Solve<TA, TB>(ref TA a, ref TB b, ref PairFrame frame, ref SolverState state)
    {
        // Apart or Enclosed where rounding cannot change the answer.
        state.Verdict = Proofs.AreBallsApart(frame) ? Verdict.Apart
            : frame.Margins == 0 ? GjkOverlap.Solve(ref a, ref b, frame) : Verdict.Undecided;
        if (state.Verdict == Verdict.Undecided) SolveDistance(ref a, ref b, frame, ref state);
    }

    readonly void IPairSolver<GjkStatus>.Finish(
        in SolverState state, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, out GjkStatus result) =>
        result = state.Verdict switch
        {
            Verdict.Enclosed => GjkStatus.Overlapping,
            Verdict.Apart or Verdict.Beyond => GjkStatus.Separated,
            Verdict.Contradiction => GjkStatus.InvalidShape,
            _ => GjkStatus.IterationLimit,
        };

    /// <summary>Whether valid shapes are so far apart that their balls show it, wherever their centres are turned to:
    /// by more than rounding could close. No rotation is looked at.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool AreBallsApart<TA, TB>(ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        double radiusA = a.BoundingRadius + a.Center.SumOfMagnitudes;
        double radiusB = b.BoundingRadius + b.Center.SumOfMagnitudes;
        double reach = (radiusA + radiusB) * (1 + GjkTolerances.SeparatedBandCurved);
        Double3.Between(poseA.Position, poseB.Position, out Double3 between);
        double distanceSquared = between.LengthSquared;
        return distanceSquared > reach * reach & a.Margin >= 0 & b.Margin >= 0 & radiusA >= 0 & radiusB >= 0
            && PairFrame.IsOrdinarySize(distanceSquared) && poseA.IsValid && poseB.IsValid;
    }

    /// <summary>What the distance query says, which need not go further than to see the shapes apart.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void SolveDistance<TA, TB>(ref TA a, ref TB b, in PairFrame frame, ref SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        NoTrace trace = default;
        double reach = GjkDistance.CoreReach(0, frame);
        state.Feature.Normal = frame.FirstNormal;
        GjkDistance.Solve(ref a, ref b, frame, reach, ref state, ref trace);
        GjkExtendedPrecision.Settle(ref a, ref b, frame, reach, false, ref state, ref trace);
        SideNormal<TA, TB, NoTrace>.Sharpen(ref a, ref b, frame, ref state, ref trace);
        if (state.Verdict != Verdict.Apart) return;
        double distance = Proofs.DistanceOf(state, frame, 1 / Math.Sqrt(state.Feature.NormalSquared));
        if (Proofs.IsTouching(state, distance)) state.Verdict = Verdict.Enclosed;
    }
}
