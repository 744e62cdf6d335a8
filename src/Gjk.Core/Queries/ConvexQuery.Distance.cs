using System.Runtime.CompilerServices;

namespace Gjk.Core;

public static unsafe partial class ConvexQuery
{
    /// <summary>The distance between two convex shapes, with the closest points, or that they overlap.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="maxDistance">
    /// In world units. When the distance, rounded to float, is larger, the query ends early with
    /// <see cref="GjkStatus.BeyondMaxDistance"/>. Below 0 counts as 0; NaN gives <see cref="GjkStatus.InvalidInput"/>.
    /// </param>
    /// <returns>
    /// The true distance of the shapes as given, rounded to float; on curved cores (cylinder, cone, ellipsoid) within
    /// 1e-6 of the larger of size and distance. A <c>default</c> pose or shape, or a NaN, gives
    /// <see cref="GjkStatus.InvalidInput"/>. See <see cref="DistanceResult"/>.
    /// </returns>
    public static DistanceResult Distance<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, float maxDistance = float.PositiveInfinity)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        var question = new DistanceQuestion<NoTrace>(maxDistance);
        AskDistance(a, poseA, b, poseB, ref question, out DistanceResult result);
        return result;
    }

    /// <summary>As the first, with the simplex that the answer came from.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="simplex">
    /// The support points of the nearest feature with their weights; empty when the input is invalid. When the shapes
    /// are further apart than asked, the last feature, if there was one.
    /// </param>
    /// <param name="maxDistance">As in the first overload.</param>
    /// <returns>See <see cref="DistanceResult"/>.</returns>
    public static DistanceResult Distance<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, out FinalSimplex simplex,
        float maxDistance = float.PositiveInfinity)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        simplex = default;
        fixed (FinalSimplex* end = &simplex)
        {
            var question = new DistanceQuestion<NoTrace>(maxDistance, null, end);
            AskDistance(a, poseA, b, poseB, ref question, out DistanceResult result);
            return result;
        }
    }

    /// <summary>
    /// As the first, beginning where the last query of the pair ended: much faster for pairs that move little.
    /// </summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="warmStart">Kept by the caller, one per pair, in the same order of A and B; updated.</param>
    /// <param name="maxDistance">As in the first overload.</param>
    /// <returns>
    /// See <see cref="DistanceResult"/>. It agrees with the cold query's within the accuracy, not always to the last
    /// bit.
    /// </returns>
    public static DistanceResult Distance<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, ref WarmStart warmStart,
        float maxDistance = float.PositiveInfinity)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        fixed (WarmStart* warm = &warmStart)
        {
            var question = new DistanceQuestion<NoTrace>(maxDistance, warm);
            AskDistance(a, poseA, b, poseB, ref question, out DistanceResult result);
            return result;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void AskDistance<TA, TB, TTrace>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, ref DistanceQuestion<TTrace> question,
        out DistanceResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IGjkTrace
    {
        ref TA shapeA = ref PairProblem.Inward(a);
        ref TB shapeB = ref PairProblem.Inward(b);
        if (AreBalls(ref shapeA, ref shapeB))
        {
            if (question.WantsPoints)
                PairProblem.Ask<TA, TB, DistanceQuestion<TTrace>, DistanceResult>(
                    ref shapeA, poseA, ref shapeB, poseB, ref question);
            DistanceOfBalls(
                ref shapeA, poseA, ref shapeB, poseB, question.MaxDistance, isSigned: false, out result);
            return;
        }

        CoreDispatch.Ask<TA, TB, DistanceQuestion<TTrace>, DistanceResult>(
            ref shapeA, poseA, ref shapeB, poseB, ref question, out result);
    }

    /// <summary>The distance of two cores.</summary>
    private struct DistanceQuestion<TTrace> : IPairProblem<SolverState, DistanceResult>
        where TTrace : struct, IGjkTrace
    {
        public readonly float MaxDistance;

        /// <summary>Told of the walk.</summary>
        public TTrace Trace;

        private readonly WarmStart* _warm;
        private readonly FinalSimplex* _simplex;

        /// <summary>Null stands for a cold query, and for one whose simplex nobody wants.</summary>
        public DistanceQuestion(float maxDistance, WarmStart* warm = null, FinalSimplex* simplex = null)
        {
            MaxDistance = maxDistance;
            Trace = default;
            _warm = warm;
            _simplex = simplex;
        }

        /// <summary>Whether two balls are to be solved as points, too, for what is told of it.</summary>
        public readonly bool WantsPoints => Trace.IsOn || _simplex != null;

        public readonly bool IsValid => !float.IsNaN(MaxDistance);

        public readonly void Refuse(out DistanceResult result) =>
            result = DistanceResult.Invalid(GjkStatus.InvalidInput, 0);

        [MethodImpl(MethodImplOptions.NoInlining)]
        void IPairQuestion<DistanceResult>.Ask<TA, TB>(
            ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, in PairPlacement placement,
            out DistanceResult result) =>
            PairProblem.Answer<TA, TB, DistanceQuestion<TTrace>, SolverState, DistanceResult>(
                ref a, poseA, ref b, poseB, placement, ref this, out result);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Solve<TA, TB>(ref TA a, ref TB b, ref PairFrame frame, out SolverState state)
            where TA : struct, ISupportMap
            where TB : struct, ISupportMap
        {
            SolverState.Begin<TA, TB>(frame, out state);
            if (frame.ArePoints) SolvePoints(frame, ref state);
            else
                ProvedDistance.SolveCores(
                ref a, ref b, frame, MaxDistance, ref *_warm, _warm != null, ref state, ref Trace);
        }

        readonly void IPairProblem<SolverState, DistanceResult>.Finish(
            in SolverState state, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, out DistanceResult result)
        {
            if (_simplex != null) Keep(state, frame, _simplex);
            ConvexQuery.Finish(state, frame, poseA, poseB, MaxDistance, false, out result);
        }

        /// <summary>The closed form of two points, told as the loop's only round.</summary>
        [MethodImpl(MethodImplOptions.NoInlining)]
        private void SolvePoints(in PairFrame frame, ref SolverState state)
        {
            GjkDistance.SolvePoints(frame, ref state);
            if (!Trace.IsOn) return;
            Trace.OnSupport(
                new TracedSupport(frame, frame.FirstNormal, state.Simplex, state.Simplex.A, isExtended: false));
            Trace.OnReduced(new TracedSimplex(state.Simplex, frame, isExtended: false));
        }
    }

    /// <summary>Keeps the simplex of a query that ended with one.</summary>
    private static void Keep(in SolverState state, in PairFrame frame, FinalSimplex* simplex)
    {
        if (state.Verdict != Verdict.Contradiction && state.Simplex.Count > 0)
            *simplex = new FinalSimplex(state.Simplex, frame);
    }
}
