using System.Numerics;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

public static unsafe partial class ConvexQuery
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
        SignedQuestion<NoPolytopeTrace> question = default;
        AskSigned(a, poseA, b, poseB, ref question, out DistanceResult result);
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
    /// Apart, as <c>Distance</c> gives it. Overlapping, the face of the Minkowski difference that the way out ends on.
    /// Empty when the input is invalid.
    /// </param>
    /// <returns>See the first overload.</returns>
    public static DistanceResult SignedDistance<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, out FinalSimplex simplex)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        simplex = default;
        fixed (FinalSimplex* end = &simplex)
        {
            var question = new SignedQuestion<NoPolytopeTrace> { Simplex = end };
            AskSigned(a, poseA, b, poseB, ref question, out DistanceResult result);
            return result;
        }
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
        fixed (WarmStart* warm = &warmStart)
        {
            var question = new SignedQuestion<NoPolytopeTrace> { Warm = warm };
            AskSigned(a, poseA, b, poseB, ref question, out DistanceResult result);
            return result;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void AskSigned<TA, TB, TTrace>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, ref SignedQuestion<TTrace> question,
        out DistanceResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
        where TTrace : struct, IPolytopeTrace
    {
        ref TA shapeA = ref PairProblem.Inward(a);
        ref TB shapeB = ref PairProblem.Inward(b);
        if (question.Plane != null) question.Plane->Normal = default;
        if (AreBalls(ref shapeA, ref shapeB))
        {
            if (question.Simplex != null)
                PairProblem.Ask<TA, TB, SignedQuestion<TTrace>, DistanceResult>(
                    ref shapeA, poseA, ref shapeB, poseB, ref question);
            DistanceOfBalls(
                ref shapeA, poseA, ref shapeB, poseB, float.PositiveInfinity, isSigned: true, out result);
            return;
        }

        CoreDispatch.Ask<TA, TB, SignedQuestion<TTrace>, DistanceResult>(
            ref shapeA, poseA, ref shapeB, poseB, ref question, out result);
    }

    /// <summary>The signed distance of two cores.</summary>
    private struct SignedQuestion<TTrace> : IPairProblem<SolverState, DistanceResult>
        where TTrace : struct, IPolytopeTrace
    {
        /// <summary>Where a warm query begins, and what it stores; null for a cold one.</summary>
        public WarmStart* Warm;

        /// <summary>Gets the simplex, if that is wanted.</summary>
        public FinalSimplex* Simplex;

        /// <summary>
        /// Gets where the contact is, if that is wanted; a normal of length 0 where nothing but the result says it.
        /// </summary>
        public ContactPlane* Plane;

        /// <summary>Gets how curved shapes touch, if that is wanted and they only touch.</summary>
        public StartTouch* Touch;

        /// <summary>Told of the search for the depth.</summary>
        public TTrace Trace;

        public readonly bool IsValid => true;

        public readonly void Refuse(out DistanceResult result) =>
            result = DistanceResult.Invalid(GjkStatus.InvalidInput, 0);

        [MethodImpl(MethodImplOptions.NoInlining)]
        void IPairQuestion<DistanceResult>.Ask<TA, TB>(
            ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, in PairPlacement placement,
            out DistanceResult result) =>
            PairProblem.Answer<TA, TB, SignedQuestion<TTrace>, SolverState, DistanceResult>(
                ref a, poseA, ref b, poseB, placement, ref this, out result);

        public void Solve<TA, TB>(ref TA a, ref TB b, ref PairFrame frame, out SolverState state)
            where TA : struct, ISupportMap
            where TB : struct, ISupportMap
        {
            SolverState.Begin<TA, TB>(frame, out state);
            if (frame.ArePoints)
            {
                GjkDistance.SolvePoints(frame, ref state);
                return;
            }

            SignedSolver.Solve(ref a, ref b, frame, ref *Warm, Warm != null, ref state, ref Trace);
            if (Touch != null && state.IsCurved && state.Verdict == Verdict.Apart)
                Touch->IsTouch = CurvedTouch.TryFind(ref a, ref b, frame, state, out Touch->Found);
        }

        readonly void IPairProblem<SolverState, DistanceResult>.Finish(
            in SolverState state, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, out DistanceResult result)
        {
            if (Simplex != null) Keep(state, frame, Simplex);
            bool isEmpty = state.Verdict == Verdict.Contradiction || state.Simplex.Count == 0;
            if (Plane != null && !isEmpty) Plane->Set(frame, state);
            if (Touch != null && Touch->IsTouch) Touch->Place(frame, poseA);
            ConvexQuery.Finish(state, frame, poseA, poseB, double.PositiveInfinity, true, out result);
        }
    }

    /// <summary>How curved shapes touch.</summary>
    private struct StartTouch
    {
        public bool IsTouch;
        public CastFinding Found;

        /// <summary>Where they touch, on A, and along which normal from A to B; in the world.</summary>
        public Vector3 Point, Normal;

        public void Place(in PairFrame frame, in RigidPose poseA)
        {
            Point = (Vector3)frame.SurfaceOfA(Found.OnA, Found.Normal, poseA.Position);
            Normal = (Vector3)frame.RotationA.Rotate(Found.Normal);
        }
    }
}
