using System.Numerics;
using System.Runtime.CompilerServices;

namespace Gjk.Core;

/// <remarks>
/// What a contact means for a time of impact. Bodies that turn may leave a contact and come back, so it is followed
/// until it gets too deep, ends, or the motion does; from its end on the next one is looked for.
/// </remarks>
public static partial class ConvexQuery
{
    /// <summary>What becomes of the contact that the question has found.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void SettleImpact<TA, TB>(
        ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, in CastOptions options,
        ref ImpactQuestion question)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        CastResult found = question.Result;
        if (found.Status == CastStatus.OverlappingAtStart)
        {
            var contact = new SettledContact(found);
            bool isDeep = contact.LookAtStart(ref a, poseA, ref b, poseB);
            bool isKnown = contact.Status == CastStatus.OverlappingAtStart;
            if (isKnown && !isDeep) contact.Status = CastStatus.Hit;
            question.Result = contact.Apply(found, 0);
            if (!isKnown || (isDeep && !options.PassesShallow)) return;
        }

        question.Follow(options);
        Ask(ref a, poseA, ref b, poseB, ref question);
    }

    private partial struct ImpactQuestion
    {
        /// <summary>Whether the shapes are balls, or points, that overlap at the start.</summary>
        public bool TryBeginInBalls<TA, TB>(ref TA a, ref TB b)
            where TA : struct, ISupportMap
            where TB : struct, ISupportMap
        {
            if (!AreBalls(ref a, ref b) || !_motionA.IsValid || !_motionB.IsValid || float.IsNaN(_maxFraction))
                return false;
            DistanceResult start = AskBalls(ref a, _motionA.Pose, ref b, _motionB.Pose, float.PositiveInfinity);
            if (!start.IsOverlapping) return false;
            Result = new CastResult(CastStatus.OverlappingAtStart, 0, start.PointA, Vector3.Zero, 1);
            return true;
        }

        /// <summary>The question is asked again, from the contact on that is the result.</summary>
        public void Follow(in CastOptions options)
        {
            _follows = true;
            _options = options;
        }

        /// <summary>Follows a contact after the other until one counts.</summary>
        private void Follow<TA, TB>(
            ref TA a, ref TB b, ref PairFrame frame, ref PairMotion motion, FractionInterval interval,
            double tolerance, bool isWhole)
            where TA : struct, ISupportMap
            where TB : struct, ISupportMap
        {
            CastResult contact = Result;
            Impact impact = default;
            impact.Iterations = contact.Iterations;
            double allowed = _options.AllowedDepth / frame.Unit;
            while (true)
            {
                ContactFollower.Solve(
                    ref a, ref b, ref frame, ref motion, interval, tolerance, allowed, ref impact);
                if (impact.Outcome != Verdict.Beyond) break;
                Impact past = impact;
                AdvancementSolver.Solve(
                    ref a, ref b, ref frame, ref motion, new FractionInterval(impact.Fraction, interval.End), tolerance,
                    ref WarmStart, out impact, out SolverState state);
                impact.Iterations += past.Iterations;
                impact.Steps += past.Steps;
                contact = Finish(impact, state, ref frame, motion, isWhole);
                Result = contact;
                if (contact.Status != CastStatus.Hit || !_options.PassesShallow) return;
                interval = new FractionInterval(contact.Fraction, interval.End);
                impact.Outcome = Verdict.Undecided;
                if (impact.Steps >= AdvancementSolver.MaxSteps) break;
            }

            Result = impact.Outcome switch
            {
                Verdict.Enclosed => new CastResult(
                    contact.Status, contact.Fraction, contact.Point, contact.Normal, impact.Iterations, contact.Depth),
                Verdict.Contradiction => CastResult.Nothing(CastStatus.InvalidShape, float.NaN, impact.Iterations),
                Verdict.Apart when isWhole => CastResult.Nothing(CastStatus.Miss, _maxFraction, impact.Iterations),
                _ => CastResult.Nothing(
                    CastStatus.IterationLimit, RoundOff.Down(impact.Fraction), impact.Iterations),
            };
        }
    }
}
