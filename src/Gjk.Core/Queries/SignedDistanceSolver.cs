namespace Gjk.Core;

/// <summary>The signed distance of a pair.</summary>
/// <typeparam name="TTrace">Told of the search for the depth.</typeparam>
internal unsafe struct SignedDistanceSolver<TTrace> : IPairSolver<DistanceResult>
    where TTrace : struct, IPolytopeTrace
{
    /// <summary>Where a warm query begins, and what it stores; null for a cold one.</summary>
    public WarmStart* Warm;

    /// <summary>Gets the simplex, if that is wanted.</summary>
    public FinalSimplex* Simplex;

    /// <summary>Gets where the contact is, if that is wanted; a normal of length 0 where nothing but the result says
    /// it.</summary>
    public ContactPlane* Plane;

    /// <summary>Not wanted of shapes that are further apart, in world units.</summary>
    public float PlaneGap;

    /// <summary>Gets how curved shapes touch, if that is wanted and they only touch.</summary>
    public StartTouch* Touch;

    /// <summary>Told of the search for the depth.</summary>
    public TTrace Trace;

    private bool _arePoints;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    bool IPairSolver<DistanceResult>.TryFormula<TA, TB>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, out DistanceResult result)
    {
        UnsafeRef.SkipInit(out result);
        if (Plane != null) Plane->Normal = default;
        if (!Balls.AreBalls(ref a, ref b) || _arePoints) return false;
        if (Simplex != null) SolveAsPoints(a, poseA, b, poseB);
        Balls.Distance(ref a, poseA, ref b, poseB, float.PositiveInfinity, isSigned: true, out result);
        return true;
    }

    readonly void IPairSolver<DistanceResult>.SolveHalfSpace<T>(
        ref HalfSpacePair pair, ref T other, in RigidPose otherPose, out DistanceResult result)
    {
        result = pair.Result(otherPose, isSigned: true, double.PositiveInfinity);
        if (Plane != null && result.Distance <= PlaneGap) pair.Set(ref *Plane);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    readonly bool IPairSolver<DistanceResult>.TryBegin<TA, TB>(
        ref TA a, ref TB b, in RigidPose poseA, ref PairFrame frame, out DistanceResult result)
    {
        UnsafeRef.SkipInit(out result);
        if (frame.IsValid) return true;
        result = DistanceResult.Invalid(GjkStatus.InvalidInput, 0);
        return false;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    void ICoreSolver.Solve<TA, TB>(ref TA a, ref TB b, ref PairFrame frame, ref SolverState state)
    {
        if (frame.ArePoints)
        {
            GjkDistance.SolvePoints(frame, ref state, isSigned: true);
            return;
        }

        SignedSolver<TA, TB, TTrace>.Solve(ref a, ref b, frame, ref *Warm, Warm != null, ref state, ref Trace);
        if (Touch != null && state.IsCurved && state.Verdict == Verdict.Apart)
            Touch->IsTouch = CastNormal<TA, TB>.TryFindTouch(ref a, ref b, frame, state, out Touch->Found);
    }

    readonly void IPairSolver<DistanceResult>.Finish(
        in SolverState state, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, out DistanceResult result)
    {
        if (Simplex != null) FinalSimplex.Keep(state, frame, Simplex);
        if (Touch != null && Touch->IsTouch) Touch->ToWorld(frame, poseA);
        DistanceFinish.Write(state, frame, poseA, poseB, double.PositiveInfinity, true, out result);
        if (Plane != null && result.Distance <= PlaneGap && state.Simplex.Count > 0) Plane->Set(frame, state);
    }

    /// <summary>Two balls are solved as points, too, for their simplex.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void SolveAsPoints<TA, TB>(in TA a, in RigidPose poseA, in TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        _arePoints = true;
        PairQuery.Run(a, poseA, b, poseB, ref this, out DistanceResult _);
    }
}

/// <summary>How curved shapes touch.</summary>
internal struct StartTouch
{
    public bool IsTouch;
    public CastFinding Found;

    /// <summary>Where they touch, on A, and along which normal from A to B; in the world.</summary>
    public Vector3 Point, Normal;

    public void ToWorld(in PairFrame frame, in RigidPose poseA)
    {
        Point = (Vector3)frame.SurfaceOfA(Found.OnA, Found.Normal, poseA.Position);
        Normal = (Vector3)frame.RotationA.Rotate(Found.Normal);
    }
}
