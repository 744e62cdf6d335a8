namespace Gjk.Core;

// What a contact means for a time of impact. Bodies that turn may leave a contact and come back, so it is followed
// until it gets too deep, ends, or the motion does; from its end on the next one is looked for.
public static unsafe partial class ConvexQuery
{
    /// <summary>What becomes of the contact that the question has found.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static CastResult SettleImpact<TA, TB>(
        ref TA a, ref TB b, CastResult found, in CastOptions options, ref ImpactQuestion question)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (found.Status == CastStatus.OverlappingAtStart)
        {
            var contact = new SettledContact(found);
            bool isDeep = contact.MeasureAtStart(ref a, question.PoseA, ref b, question.PoseB);
            bool isKnown = contact.Status == CastStatus.OverlappingAtStart;
            if (isKnown && !isDeep) contact.Status = CastStatus.Hit;
            found = contact.Apply(found, 0);
            if (!isKnown || (isDeep && !options.PassesShallow)) return found;
        }

        question.Follow(found, options);
        return question.Run(ref a, ref b);
    }

    private partial struct ImpactQuestion
    {
        public readonly RigidPose PoseA => _motionA.Pose;

        public readonly RigidPose PoseB => _motionB.Pose;

        /// <summary>Answers balls, or points, that overlap at the start.</summary>
        readonly bool IPairSolver<CastResult>.TryFormula<TA, TB>(
            ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, out CastResult result)
        {
            result = default;
            if (_follows || _isWindow || !Balls.AreBalls(ref a, ref b) || !IsValid) return false;
            Balls.Distance(
                ref a, poseA, ref b, poseB, float.PositiveInfinity, isSigned: false, out DistanceResult start);
            if (!start.IsOverlapping) return false;
            result = new CastResult(CastStatus.OverlappingAtStart, 0, start.PointA, Vector3.Zero, 1);
            return true;
        }

        /// <summary>The question is to be asked again, from a contact on.</summary>
        public void Follow(in CastResult contact, in CastOptions options)
        {
            _follows = true;
            _contact = contact;
            _options = options;
        }

        /// <summary>Follows a contact after the other until one counts.</summary>
        private CastResult Follow<TA, TB>(
            ref TA a, ref TB b, ref PairFrame frame, FractionInterval interval, double tolerance)
            where TA : struct, ISupportMap
            where TB : struct, ISupportMap
        {
            CastResult contact = _contact;
            Impact impact = default;
            impact.Iterations = contact.Iterations;
            double allowed = _options.AllowedDepth / frame.Unit;
            while (true)
            {
                ContactFollower<TA, TB>.Solve(
                    ref a, ref b, ref frame, ref _motion, interval, tolerance, allowed, ref impact);
                if (impact.Outcome != MotionVerdict.Over) break;
                Impact past = impact;
                AdvancementSolver<TA, TB>.Solve(
                    ref a, ref b, ref frame, ref _motion, new FractionInterval(impact.Fraction, interval.End),
                    tolerance, Impact.FloorRatio * tolerance, leaves: true, ref *_warm, out impact,
                    out SolverState state);
                impact.Iterations += past.Iterations;
                impact.Steps += past.Steps;
                contact = Finish(impact, state, ref frame);
                if (contact.Status != CastStatus.Hit || !_options.PassesShallow) return contact;
                interval = new FractionInterval(contact.Fraction, interval.End);
                impact.Outcome = MotionVerdict.Undecided;
                if (impact.Steps >= Impact.MaxSteps) break;
            }

            return Ended(contact, impact);
        }
    }
}
