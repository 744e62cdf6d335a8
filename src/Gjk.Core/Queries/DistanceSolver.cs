namespace Gjk.Core;

/// <summary>The distance of a pair.</summary>
/// <typeparam name="TTrace">Told of the walk.</typeparam>
internal unsafe struct DistanceSolver<TTrace>(
    float maxDistance, WarmStart* warm = null, FinalSimplex* simplex = null) : IPairSolver<DistanceResult>
    where TTrace : struct, IGjkTrace
{
    /// <summary>Told of the walk.</summary>
    public TTrace Trace = default;

    private readonly float _maxDistance = maxDistance;
    private readonly WarmStart* _warm = warm;
    private readonly FinalSimplex* _simplex = simplex;
    private bool _arePoints = false;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    bool IPairSolver<DistanceResult>.TryFormula<TA, TB>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, out DistanceResult result)
    {
        UnsafeRef.SkipInit(out result);
        if (!Balls.AreBalls(ref a, ref b) || _arePoints) return false;
        if (Trace.IsOn || _simplex != null) SolveAsPoints(a, poseA, b, poseB);
        Balls.Distance(ref a, poseA, ref b, poseB, _maxDistance, isSigned: false, out result);
        return true;
    }

    readonly void IPairSolver<DistanceResult>.SolveHalfSpace<T>(
        ref HalfSpacePair pair, ref T other, in RigidPose otherPose, out DistanceResult result) =>
        result = pair.Result(otherPose, isSigned: false, _maxDistance);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    readonly bool IPairSolver<DistanceResult>.TryBegin<TA, TB>(
        ref TA a, ref TB b, in RigidPose poseA, ref PairFrame frame, out DistanceResult result)
    {
        UnsafeRef.SkipInit(out result);
        if (frame.IsValid && !float.IsNaN(_maxDistance)) return true;
        result = DistanceResult.Invalid(GjkStatus.InvalidInput, 0);
        return false;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    void ICoreSolver.Solve<TA, TB>(ref TA a, ref TB b, ref PairFrame frame, ref SolverState state)
    {
        if (frame.ArePoints)
        {
            SolvePoints(frame, ref state);
            return;
        }

        double reach = GjkDistance.CoreReach(_maxDistance, frame);
        if (_warm != null) _warm->Seed(ref a, ref b, frame, ref state);
        else state.Feature.Normal = frame.FirstNormal;
        GjkDistance.Solve(ref a, ref b, frame, reach, ref state, ref Trace);
        GjkExtendedPrecision.Settle(ref a, ref b, frame, reach, _warm != null, ref state, ref Trace);
        if (_warm != null) _warm->Save(state);
        SideNormal<TA, TB, TTrace>.Sharpen(ref a, ref b, frame, ref state, ref Trace);
    }

    readonly void IPairSolver<DistanceResult>.Finish(
        in SolverState state, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, out DistanceResult result)
    {
        if (_simplex != null) FinalSimplex.Keep(state, frame, _simplex);
        DistanceFinish.Write(state, frame, poseA, poseB, _maxDistance, false, out result);
    }

    /// <summary>Two balls are solved as points, too, for what is told of it.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void SolveAsPoints<TA, TB>(in TA a, in RigidPose poseA, in TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        _arePoints = true;
        PairQuery.Run(a, poseA, b, poseB, ref this, out DistanceResult _);
    }

    /// <summary>The closed form of two points, told as the loop's only round.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void SolvePoints(in PairFrame frame, ref SolverState state)
    {
        GjkDistance.SolvePoints(frame, ref state);
        if (!Trace.IsOn) return;
        Trace.OnSupport(new TracedSupport(frame, frame.FirstNormal, state.Simplex.At(state.Simplex.A)));
        Trace.OnReduced(new TracedSimplex(state.Simplex, frame, isExtended: false));
    }
}
