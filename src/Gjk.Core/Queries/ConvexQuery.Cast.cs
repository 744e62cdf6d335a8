namespace Gjk.Core;

public static unsafe partial class ConvexQuery
{
    /// <summary>When two shapes that move without turning first touch: both are translated over the fractions from 0 to
    /// 1.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A at the start.</param>
    /// <param name="translationA">Its motion, in world units, any finite vector.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B at the start.</param>
    /// <param name="translationB">Its motion.</param>
    /// <param name="maxFraction">How much of the motion is looked at: 1 for all of it, more for the same motion
    /// continued; less than 0 counts as 0.</param>
    /// <param name="options">Which contacts are passed; by default none.</param>
    /// <returns>The first fraction at which the closed shapes share a point, the point, and the normal. The fraction is
    /// the true one, rounded to float; along the motion it is exact to 1e-7 of the size or the way, whichever is
    /// larger. On curved cores (those that <c>Distance</c> names) shapes touch when they are within 1e-9 of
    /// the size. Shapes that overlap at the start give <see cref="CastStatus.OverlappingAtStart"/> with normal and
    /// depth, those of <c>SignedDistance</c>. Shapes that only touch there, whose signed distance is 0, are a hit at 0
    /// if the motion takes them into each other (curved cores by more than counts as touching), and a miss if they
    /// slide or part. A point that is cast is a ray, with what <c>RayCast</c> says of those that pass the surface
    /// closely.</returns>
    public static CastResult Cast<TA, TB>(
        in TA a, in RigidPose poseA, Vector3 translationA, in TB b, in RigidPose poseB, Vector3 translationB,
        float maxFraction = 1, in CastOptions options = default)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        WarmStart unused = default;
        return Cast(a, poseA, translationA, b, poseB, translationB, ref unused, maxFraction, options);
    }

    /// <summary>As the first, beginning where the last query of the pair ended: faster for pairs that move
    /// little.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A at the start.</param>
    /// <param name="translationA">Its motion, in world units, any finite vector.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B at the start.</param>
    /// <param name="translationB">Its motion.</param>
    /// <param name="warmStart">Kept by the caller, one per pair, in the same order of A and B; updated. It may be the
    /// one that <c>Distance</c> uses.</param>
    /// <param name="maxFraction">See the first overload.</param>
    /// <param name="options">See the first overload.</param>
    /// <returns>See the first overload. Within the accuracy that of the cold query.</returns>
    public static CastResult Cast<TA, TB>(
        in TA a, in RigidPose poseA, Vector3 translationA, in TB b, in RigidPose poseB, Vector3 translationB,
        ref WarmStart warmStart, float maxFraction = 1, in CastOptions options = default)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        fixed (WarmStart* warm = &warmStart)
        {
            var solver = new CastQuestion(translationA, translationB, maxFraction, warm);
            PairQuery.Run(a, poseA, b, poseB, ref solver, out CastResult found);
            if (options.Settles(found.Status)) return found;
            var contact = new SettledContact(found);
            Settle(
                ref PairQuery.AsRef(a), poseA, ref PairQuery.AsRef(b), poseB, (Double3)translationB - translationA,
                found.Fraction, Math.Max(maxFraction, 0), options, ref contact);
            return contact.Apply(found, maxFraction);
        }
    }

    /// <summary>When two bodies that do not turn touch. A contact at the start has the status OverlappingAtStart and no
    /// normal, touching included.</summary>
    private struct CastQuestion(Vector3 translationA, Vector3 translationB, float maxFraction, WarmStart* warm)
        : IPairSolver<CastResult>
    {
        private readonly WarmStart* _warm = warm;
        private readonly Vector3 _translationA = translationA, _translationB = translationB;
        private readonly Double3 _motion = (Double3)translationB - translationA;
        private readonly float _maxFraction = maxFraction < 0 ? 0 : maxFraction;
        private CastFinding _cast;

        readonly bool IPairSolver<CastResult>.TryFormula<TA, TB>(
            ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, out CastResult result)
        {
            if (!Balls.AreBalls(ref a, ref b))
                return TryCastPoint(ref a, poseA, _translationA, ref b, poseB, _translationB, _maxFraction, out result);
            result = CastBalls(ref a, poseA, _translationA, ref b, poseB, _translationB, _maxFraction);
            return true;
        }

        readonly void IPairSolver<CastResult>.SolveHalfSpace<T>(
            ref HalfSpacePair pair, ref T other, in RigidPose otherPose, out CastResult result)
        {
            bool isInvalid = !(_motion + _translationA).IsFinite || float.IsNaN(_maxFraction);
            CastStatus status = pair.Meet(
                pair.IsSwapped ? -_motion : _motion, isInvalid ? float.NaN : _maxFraction, out double fraction);
            if (status is not (CastStatus.Hit or CastStatus.OverlappingAtStart))
            {
                result = CastResult.Nothing(status, FractionOf(status, double.NaN, _maxFraction), 1);
                return;
            }

            Double3 moved = (Double3)(pair.IsSwapped ? _translationA : _translationB) * fraction;
            result = new CastResult(
                status, fraction, (Vector3)(pair.OnOtherInWorld(otherPose) + moved),
                status == CastStatus.Hit ? pair.FromAToB : default, 1);
        }

        readonly bool IPairSolver<CastResult>.TryBegin<TA, TB>(
            ref TA a, ref TB b, in RigidPose poseA, ref PairFrame frame, out CastResult result)
        {
            result = CastResult.Nothing(CastStatus.InvalidInput, float.NaN, 0);
            if (!frame.IsValid || !(_motion + _translationA).IsFinite || float.IsNaN(_maxFraction)) return false;
            frame.TightenRadii(ref a, ref b);
            return true;
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        void ICoreSolver.Solve<TA, TB>(ref TA a, ref TB b, ref PairFrame frame, ref SolverState state)
        {
            Double3 motion = frame.RotationA.InverseRotate(_motion) * (1 / frame.Unit);
            CastSolver.Solve(ref a, ref b, ref frame, motion, _maxFraction, ref *_warm, out _cast);
        }

        /// <summary>Where A's surface is met, with A as it has moved.</summary>
        readonly void IPairSolver<CastResult>.Finish(
            in SolverState state, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, out CastResult result)
        {
            CastStatus status = StatusOf(_cast.Outcome, _cast.Fraction);
            if (status is not (CastStatus.Hit or CastStatus.OverlappingAtStart))
            {
                result = CastResult.Nothing(status, FractionOf(status, _cast.Fraction, _maxFraction), _cast.Iterations);
                return;
            }

            Double3 world = frame.SurfaceOfA(_cast.OnA, _cast.Normal, poseA.Position);
            result = new CastResult(
                status, _cast.Fraction, (Vector3)(world + (Double3)_translationA * _cast.Fraction),
                (Vector3)frame.RotationA.Rotate(_cast.Normal), _cast.Iterations);
        }
    }

    /// <summary>What a solver's verdict on a motion means.</summary>
    /// <param name="verdict">The verdict.</param>
    /// <param name="fraction">Where it ended; 0 for a contact at the start.</param>
    private static CastStatus StatusOf(MotionVerdict verdict, double fraction) => verdict switch
    {
        MotionVerdict.Contradiction => CastStatus.InvalidShape,
        MotionVerdict.Miss => CastStatus.Miss,
        MotionVerdict.Undecided => CastStatus.IterationLimit,
        _ => fraction > 0 ? CastStatus.Hit : CastStatus.OverlappingAtStart,
    };

    /// <summary>Up to where a motion without a contact is known to be free of one.</summary>
    private static float FractionOf(CastStatus status, double reached, float most) =>
        status == CastStatus.Miss ? most
            : status == CastStatus.IterationLimit ? RoundOff.Down(reached) : float.NaN;
}
