using System.Numerics;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

public static partial class ConvexQuery
{
    /// <summary>
    /// How far apart two convex shapes are, or how deep they overlap: apart, what <c>Distance</c> says, bit for bit;
    /// overlapping, minus the length of the shortest translation that separates them.
    /// </summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <returns>
    /// Overlapping: <see cref="DistanceResult.Distance"/> is minus the depth, the true one rounded to float, and
    /// <see cref="DistanceResult.Normal"/> the direction in which B leaves A: moved along it by the depth, B only
    /// touches A. The points are the deepest ones, and PointB = PointA + Normal · Distance, as it is apart. <see
    /// cref="DistanceResult.LowerBound"/> is at most the true signed distance. Touching, the distance is 0, and there
    /// is a normal too. Of several ways out that are equally short it is always the same one for the same input. On
    /// curved cores (cylinder, cone, ellipsoid) the depth is within 1e-6 of the size. Where the surface that the search
    /// builds outgrows its room (curved shapes that are concentric, hulls of thousands of vertices deep in each other),
    /// the status is <see cref="GjkStatus.IterationLimit"/>, and the true signed distance is between <see
    /// cref="DistanceResult.LowerBound"/> and <see cref="DistanceResult.Distance"/>.
    /// </returns>
    public static DistanceResult SignedDistance<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        var question = new SignedQuestion<NoPolytopeTrace>(default, isWarm: false);
        return AskSigned(a, poseA, b, poseB, ref question);
    }

    /// <summary>As the first, with the simplex that the answer came from.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="simplex">
    /// Apart, as <c>Distance</c> gives it. Overlapping, the face of the Minkowski difference that the way out ends on.
    /// Empty when the input is invalid.
    /// </param>
    /// <returns>See the first overload.</returns>
    public static DistanceResult SignedDistance<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, out FinalSimplex simplex)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        var question = new SignedQuestion<NoPolytopeTrace>(default, isWarm: false, wantsSimplex: true);
        DistanceResult result = AskSigned(a, poseA, b, poseB, ref question);
        simplex = question.Simplex;
        return result;
    }

    /// <summary>
    /// As the first, beginning where the last query of the pair ended: faster for pairs that move little.
    /// </summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="warmStart">
    /// Kept by the caller, one per pair, in the same order of A and B; updated. It may be the one that <c>Distance</c>
    /// uses.
    /// </param>
    /// <returns>See the first overload. Within the accuracy that of the cold query.</returns>
    public static DistanceResult SignedDistance<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, ref WarmStart warmStart)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        var question = new SignedQuestion<NoPolytopeTrace>(warmStart, isWarm: true);
        DistanceResult result = AskSigned(a, poseA, b, poseB, ref question);
        warmStart = question.WarmStart;
        return result;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static DistanceResult AskSigned<TA, TB, TTrace>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, ref SignedQuestion<TTrace> question)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IPolytopeTrace
    {
        TA copyA = default;
        TB copyB = default;
        ref TA shapeA = ref Inward(a, ref copyA);
        ref TB shapeB = ref Inward(b, ref copyB);
        Ask(ref shapeA, poseA, ref shapeB, poseB, ref question);
        return question.Result;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Ask<TA, TB, TQuestion>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, ref TQuestion question)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TQuestion : struct, IPairQuestion =>
#if NET
        PairDispatch.Ask(ref a, poseA, ref b, poseB, ref question);
#else
        question.Ask(ref a, poseA, ref b, poseB);
#endif

    /// <summary>The pipeline of the signed distance, for any two cores.</summary>
    private struct SignedQuestion<TTrace> : IPairQuestion
        where TTrace : struct, IPolytopeTrace
    {
        public WarmStart WarmStart;
        public FinalSimplex Simplex;
        public DistanceResult Result;

        /// <summary>Where the contact is, with a normal of length 0 where nothing but the result says it.</summary>
        public ContactPlane Plane;

        /// <summary>Told of the search for the depth.</summary>
        public TTrace Trace;

        /// <summary>Whether curved shapes only touch, where that was asked for.</summary>
        public bool IsTouch;

        /// <summary>Where they touch then, on A, and along which normal from A to B; in the world.</summary>
        public Vector3 TouchPoint, TouchNormal;

        private readonly bool _isWarm, _wantsSimplex, _wantsPlane, _wantsTouch;

        /// <summary>What is not wanted is not cleared where the runtime lets it be: it is half a kilobyte.</summary>
        public SignedQuestion(
            in WarmStart warmStart, bool isWarm, bool wantsSimplex = false, bool wantsPlane = false,
            bool wantsTouch = false)
        {
#if NET
            Unsafe.SkipInit(out this);
#else
            this = default;
#endif
            WarmStart = warmStart;
            if (wantsSimplex) Simplex = default;
            if (wantsPlane) Plane.Normal = default;
            Trace = default;
            _isWarm = isWarm;
            _wantsSimplex = wantsSimplex;
            _wantsPlane = wantsPlane;
            _wantsTouch = wantsTouch;
            IsTouch = false;
            TouchPoint = TouchNormal = default;
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        public void Ask<TA, TB>(ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB)
            where TA : struct, ISupportMap
            where TB : struct, ISupportMap
        {
            PairFrame.Compose(ref a, poseA, ref b, poseB, out PairFrame frame);
            SolverState.Begin<TA, TB>(frame, out SolverState state);
            if (!frame.IsValid)
            {
                state.Verdict = Verdict.Contradiction;
            }
            else if (frame.ArePoints)
            {
                GjkDistance.SolvePoints(frame, ref state);
            }
            else if (frame.IsOrdinary)
            {
                Solve(ref a, ref b, frame, PairForm.Unknown, poseA, ref state);
            }
            else
            {
                ToUnitSize(ref a, ref b, ref frame, ref state, out UnitSized<TA> unitA, out UnitSized<TB> unitB);
                PairForm.Look(ref a, ref b, frame, out PairForm form);
                Solve(ref unitA, ref unitB, frame, form, poseA, ref state);
            }

            bool isEmpty = state.Verdict == Verdict.Contradiction || state.Simplex.Count == 0;
            if (_wantsSimplex && !isEmpty) Simplex = new FinalSimplex(state.Simplex, frame);
            if (_wantsPlane && !isEmpty && !frame.ArePoints) Plane.Set(frame, state);
            Result = frame.ArePoints
                ? AskBalls(ref a, poseA, ref b, poseB, float.PositiveInfinity, isSigned: true)
                : Finish(state, frame, poseA, poseB, double.PositiveInfinity, isSigned: true);
        }

        private void Solve<TA, TB>(
            ref TA a, ref TB b, in PairFrame frame, in PairForm form, in RigidPose poseA, ref SolverState state)
            where TA : struct, ISupportMap
            where TB : struct, ISupportMap
        {
            SignedSolver.Solve(ref a, ref b, frame, form, ref WarmStart, _isWarm, ref state, ref Trace);
            if (_wantsTouch && state.IsCurved && state.Verdict == Verdict.Apart)
                Touch(ref a, ref b, frame, poseA, state);
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        private void Touch<TA, TB>(
            ref TA a, ref TB b, in PairFrame frame, in RigidPose poseA, in SolverState state)
            where TA : struct, ISupportMap
            where TB : struct, ISupportMap
        {
            IsTouch = CurvedTouch.TryFind(ref a, ref b, frame, state, out CastFinding touch);
            if (!IsTouch) return;
            Vector3D onA = (touch.OnA + touch.Normal * frame.MarginA + frame.CenterA) * frame.Unit;
            TouchPoint = (Vector3)(frame.RotationA.Rotate(onA) + poseA.Position);
            TouchNormal = (Vector3)frame.RotationA.Rotate(touch.Normal);
        }
    }
}
