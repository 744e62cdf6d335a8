namespace Gjk.Core;

// What a contact means for a cast: one at the start, which may be touching, overlapping or on its way apart, and one
// on the way that may be passed. A cast that starts apart and passes nothing does not come here.
public static unsafe partial class ConvexQuery
{
    /// <summary>Ratio to the way: 2^-20, sixteen roundings to float: how far the projection of a motion onto a surface
    /// may point into it. Pinned by CastOptionsTests.</summary>
    private const double AllowedSlope = 1.0 / (1 << 20);

    /// <summary>A contact: as a cast has found it, and then as it is settled by how deep it is.</summary>
    private struct SettledContact(in CastResult found)
    {
        public CastStatus Status = found.Status;
        public Vector3 Point = found.Point, Normal = found.Normal;
        public float Depth;

        /// <summary>Support calls made since the cast.</summary>
        public int Iterations;

        /// <summary>Asks how deep the shapes overlap at the start. Where they only touch, a normal that is known
        /// stays.</summary>
        /// <returns>Whether they do by more than touching.</returns>
        public bool MeasureAtStart<TA, TB>(ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB)
            where TA : struct, ISupportMap
            where TB : struct, ISupportMap
        {
            StartTouch touch = default;
            var solver = new SignedDistanceSolver<NoPolytopeTrace> { Touch = &touch };
            PairQuery.Run(a, poseA, b, poseB, ref solver, out DistanceResult start);
            Iterations = start.Iterations;
            bool isLimit = start.Status == GjkStatus.IterationLimit, isKnown = Normal != default;
            if (touch.IsTouch) Point = touch.Point;
            else Depth = Math.Max(isLimit ? -start.LowerBound : -start.Distance, 0);
            if (start.Status == GjkStatus.InvalidShape) Status = CastStatus.InvalidShape;
            bool isDeep = !touch.IsTouch && (isLimit || Depth > 0);
            if (isDeep || !isKnown) Normal = touch.IsTouch ? touch.Normal : start.Normal;
            return isDeep;
        }

        /// <summary>A cast that found this contact.</summary>
        public readonly CastResult Apply(in CastResult found, float maxFraction)
        {
            int iterations = found.Iterations + Iterations;
            return Status switch
            {
                CastStatus.Miss => CastResult.Nothing(Status, Math.Max(maxFraction, 0), iterations),
                CastStatus.Hit or CastStatus.OverlappingAtStart =>
                    found.With(Status, Point, Normal, iterations, Depth),
                _ => CastResult.Nothing(Status, float.NaN, iterations),
            };
        }
    }

    /// <summary>What becomes of a contact that a cast has found.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A at the start.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="motion">Of B, seen from A, for the fraction 1.</param>
    /// <param name="fraction">Of the contact; 0 with the status OverlappingAtStart.</param>
    /// <param name="most">The largest fraction.</param>
    /// <param name="options">Which contacts are passed.</param>
    /// <param name="contact">The contact; its status becomes that of the cast.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Settle<TA, TB>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, in Double3 motion, double fraction, double most,
        in CastOptions options, ref SettledContact contact)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        bool isStart = contact.Status == CastStatus.OverlappingAtStart, isDeep = false;
        if (isStart)
        {
            isDeep = contact.MeasureAtStart(ref a, poseA, ref b, poseB);
            if (contact.Status != CastStatus.OverlappingAtStart) return;
        }

        if (isDeep && !options.PassesShallow) return;
        DeepeningRange range = options.PassesShallow
            ? new DeepeningRange(fraction, most, options.AllowedDepth, AllowedSlope)
            : new DeepeningRange(0, double.PositiveInfinity, 0, 0);
        var question = new DeepeningQuestion(motion, range);
        PairQuery.Run(a, poseA, b, poseB, ref question, out MotionVerdict verdict);
        contact.Iterations += question.Iterations;
        if (verdict == MotionVerdict.Contradiction) contact.Status = CastStatus.InvalidShape;
        else if (verdict == MotionVerdict.Miss) contact.Status = CastStatus.Miss;
        else if (isStart && !isDeep) contact.Status = CastStatus.Hit;
    }

    /// <summary>Whether a contact deepens.</summary>
    private struct DeepeningQuestion(in Double3 motion, in DeepeningRange range) : IPairSolver<MotionVerdict>
    {
        public int Iterations = 0;
        private readonly Double3 _motion = motion;
        private readonly DeepeningRange _range = range;
        private MotionVerdict _verdict = MotionVerdict.Undecided;

        readonly bool IPairSolver<MotionVerdict>.TryFormula<TA, TB>(
            ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, out MotionVerdict result)
        {
            result = default;
            return false;
        }

        readonly void IPairSolver<MotionVerdict>.SolveHalfSpace<T>(
            ref HalfSpacePair pair, ref T other, in RigidPose otherPose, out MotionVerdict result) =>
            result = pair.Deepens(pair.IsSwapped ? -_motion : _motion, _range);

        readonly bool IPairSolver<MotionVerdict>.TryBegin<TA, TB>(
            ref TA a, ref TB b, in RigidPose poseA, ref PairFrame frame, out MotionVerdict result)
        {
            result = MotionVerdict.Undecided;
            if (!frame.IsValid) return false;
            frame.TightenRadii(ref a, ref b);
            return true;
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        void ICoreSolver.Solve<TA, TB>(ref TA a, ref TB b, ref PairFrame frame, ref SolverState state)
        {
            Double3 motion = frame.RotationA.InverseRotate(_motion) * (1 / frame.Unit);
            var range = new DeepeningRange(_range.From, _range.To, _range.Allowed / frame.Unit, _range.Slope);
            _verdict = DeepeningSolver<TA, TB>.Solve(ref a, ref b, ref frame, motion, range, ref Iterations);
        }

        readonly void IPairSolver<MotionVerdict>.Finish(
            in SolverState state, in PairFrame frame, in RigidPose poseA, in RigidPose poseB,
            out MotionVerdict result) => result = _verdict;
    }
}
