namespace Gjk.Core;

public static unsafe partial class ConvexQuery
{
    /// <summary>Ratio to the pair's size, which is at most 1.74 times its scale: the default tolerance, at most 1e-5 of
    /// the scale. Pinned by TimeOfImpactTests.</summary>
    internal const double DefaultTolerance = 5e-6;

    /// <summary>Ratio to the pair's size: a coarser tolerance would make a hit of shapes that are seen to pass each
    /// other, and of a mesh's triangles where its hull has none. 1e-3 to 3.5e-3 of the scale. Pinned by
    /// ImpactToleranceTests.</summary>
    internal const double CoarsestTolerance = 2e-3;

    /// <summary>Ratio to the pair's size: a finer tolerance would reach down to what counts as touching for curved
    /// cores (4e-10 of the size). Pinned by ImpactToleranceTests.</summary>
    private const double LeastTolerance = 1e-8;

    /// <summary>Ratio to what rounding does to a gap: tolerances are at least this, so that the floor of a step, a 64th
    /// of it, is no less than rounding. Pinned by ImpactToleranceTests.</summary>
    private const double RoundingTolerance = 64;

    /// <summary>Ratio: 2^-24, no more than from a float to the one before, and more than half of that. A smaller one
    /// would do as well, since what is left is rounded down. Pinned by WhatDoesNotTurnIsCast in
    /// TimeOfImpactTests.</summary>
    private const double OneFloat = 1.0 / (1 << 24);

    /// <summary>Ratio to the tolerance: the gap at which <see cref="StaysApart"/> gives up; each step leaves one
    /// tolerance. It changes the cost alone.</summary>
    private const double WindowRoom = 4;

    /// <summary>When two shapes that move and turn at constant rates first touch, to within a tolerance.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="motionA">How it moves over the fractions from 0 to 1.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="motionB">How it moves.</param>
    /// <param name="tolerance">How accurate the touch is: the largest distance of a hit, in world units; 0 or less: at
    /// most 1e-5 of the longest side of the larger shape, or, for two points, of the arms that they turn on or the way
    /// between them. Not finer than 1e-8 of the sizes and 1e-13 of the distances and ways, and not coarser than 2e-3 of
    /// the sum of the bounding radii. To ask when shapes come within a distance of each other, round one of them by
    /// it.</param>
    /// <param name="maxFraction">How much of the motion is looked at: 1 for all of it, more for the same motion
    /// continued; less than 0 counts as 0.</param>
    /// <param name="options">Which contacts are passed; by default none.</param>
    /// <returns>Hit: the shapes are proved apart before the fraction, and at it their distance is at most the
    /// tolerance; the point is on A as it has moved. The fraction is rounded down to a float. Where the shapes move by
    /// more than the tolerance between two floats (some 1e-7 of the way up to there), the distance may be larger by
    /// twice that. Miss: they are proved apart up to the largest fraction. OverlappingAtStart: they overlap at 0, by
    /// the depth and along the normal that <c>SignedDistance</c> says. Shapes that only touch at 0 are a hit there if
    /// the motion takes them into each other by more than the tolerance before they part; else the contact is passed,
    /// and a later one is found. Shapes that are within the tolerance at the start and part at once do not hit.
    /// Whether shapes hit that pass each other within the tolerance, without a touch, is open. IterationLimit: they are
    /// apart up to the fraction, or no deeper than is passed, and 1024 steps or a million radians have been spent.
    /// Where neither turns, hit and miss are those of <c>Cast</c>, whatever the tolerance, and the fraction is the
    /// float before its.</returns>
    public static CastResult TimeOfImpact<TA, TB>(
        in TA a, in RigidMotion motionA, in TB b, in RigidMotion motionB, float tolerance = 0, float maxFraction = 1,
        in CastOptions options = default)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        WarmStart unused = default;
        return TimeOfImpact(a, motionA, b, motionB, ref unused, tolerance, maxFraction, options);
    }

    /// <summary>As the first, beginning where the last query of the pair ended: faster for pairs that move
    /// little.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="motionA">How it moves over the fractions from 0 to 1.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="motionB">How it moves.</param>
    /// <param name="warmStart">Kept by the caller, one per pair, in the same order of A and B; updated. It may be the
    /// one that <c>Distance</c> uses.</param>
    /// <param name="tolerance">See the first overload.</param>
    /// <param name="maxFraction">See the first overload.</param>
    /// <param name="options">See the first overload.</param>
    /// <returns>See the first overload, whose promises hold here too.</returns>
    public static CastResult TimeOfImpact<TA, TB>(
        in TA a, in RigidMotion motionA, in TB b, in RigidMotion motionB, ref WarmStart warmStart,
        float tolerance = 0, float maxFraction = 1, in CastOptions options = default)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        if (float.IsNaN(tolerance)) return CastResult.Nothing(CastStatus.InvalidInput, float.NaN, 0);
        if (motionA.AngularVelocity == Vector3.Zero && motionB.AngularVelocity == Vector3.Zero)
        {
            return BeforeTouching(
                Cast(
                    a, motionA.Pose, motionA.Velocity, b, motionB.Pose, motionB.Velocity, ref warmStart, maxFraction,
                    options));
        }

        ref TA shapeA = ref PairQuery.AsRef(a);
        ref TB shapeB = ref PairQuery.AsRef(b);
        fixed (WarmStart* warm = &warmStart)
        {
            var question = new ImpactQuestion(motionA, motionB, tolerance, maxFraction, warm);
            CastResult found = question.Run(ref shapeA, ref shapeB);
            return options.Settles(found.Status)
                ? found
                : SettleImpact(ref shapeA, ref shapeB, found, options, ref question);
        }
    }

    /// <summary>Whether it is proved that two shapes that move and turn stay further apart than the tolerance of a
    /// time of impact for a part of their motion, so that it finds no hit there.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="motionA">How it moves over the fractions from 0 to 1.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="motionB">How it moves.</param>
    /// <param name="tolerance">Of the time of impact.</param>
    /// <param name="maxFraction">Likewise.</param>
    /// <param name="from">The first fraction.</param>
    /// <param name="to">The last one.</param>
    internal static bool StaysApart<TA, TB>(
        in TA a, in RigidMotion motionA, in TB b, in RigidMotion motionB, float tolerance, float maxFraction,
        double from, double to)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        WarmStart cold = default;
        var question = new ImpactQuestion(motionA, motionB, tolerance, maxFraction, &cold);
        question.Within(from, to);
        return question.Run(ref PairQuery.AsRef(a), ref PairQuery.AsRef(b)).Status == CastStatus.Miss;
    }

    /// <summary>A cast's fraction is the nearest float, which may be later; the one before is not.</summary>
    private static CastResult BeforeTouching(in CastResult cast) =>
        cast.Status == CastStatus.Hit ? cast.At(RoundOff.Down(cast.Fraction * (1 - OneFloat))) : cast;

    /// <summary>When two cores that move and turn touch, to within a tolerance.</summary>
    private partial struct ImpactQuestion(
        in RigidMotion motionA, in RigidMotion motionB, float tolerance, float maxFraction, WarmStart* warm)
        : IPairSolver<CastResult>
    {
        private readonly WarmStart* _warm = warm;
        private readonly RigidMotion _motionA = motionA, _motionB = motionB;
        private readonly float _tolerance = tolerance, _maxFraction = maxFraction < 0 ? 0 : maxFraction;

        private PairMotion _motion;
        private double _begin, _end, _last;

        /// <summary>Whether nothing is asked but that the shapes stay further apart than the tolerance, and the
        /// fractions between which.</summary>
        private bool _isWindow;
        private double _from, _to;

        /// <summary>Whether the end is that of the motion.</summary>
        private bool _isWhole;

        /// <summary>Whether to go on from a contact, which one, and what it may pass.</summary>
        private bool _follows;
        private CastResult _contact, _found;
        private CastOptions _options;

        public readonly bool IsValid => _motionA.IsValid && _motionB.IsValid && !float.IsNaN(_maxFraction);

        /// <summary>Asks about a part of the motion: a miss if the shapes stay apart by more than the
        /// tolerance.</summary>
        public void Within(double from, double to) => (_isWindow, _from, _to) = (true, from, to);

        public CastResult Run<TA, TB>(ref TA a, ref TB b)
            where TA : struct, ISupportMap
            where TB : struct, ISupportMap
        {
            PairQuery.Run(a, _motionA.Pose, b, _motionB.Pose, ref this, out CastResult result);
            return result;
        }

        bool IPairSolver<CastResult>.TryBegin<TA, TB>(
            ref TA a, ref TB b, in RigidPose poseA, ref PairFrame frame, out CastResult result)
        {
            result = CastResult.Nothing(CastStatus.InvalidInput, float.NaN, 0);
            if (!frame.IsValid || !IsValid) return false;
            frame.TightenRadii(ref a, ref b);
            PairMotion.Make(_motionA, _motionB, frame, out _motion);
            result = CastResult.Nothing(CastStatus.Miss, _maxFraction, 0);
            if (!_motion.TryReach(frame.Margins, _maxFraction, out _begin, out _end)) return false;
            if (_follows) _begin = _contact.Fraction;
            double turned = SineCosine.MaxAngle / _motion.Rate;
            _isWhole = _end <= turned;
            if (!_isWhole) _end = turned;
            _last = _end;
            if (_isWindow)
            {
                _isWhole = _isWhole || _to <= turned;
                _begin = Math.Max(_begin, _from);
                _end = Math.Min(_end, _to);
                if (_begin > _end && _isWhole) return false;
            }

            result = CastResult.Nothing(CastStatus.IterationLimit, RoundOff.Down(_begin), 0);
            if (_begin > _end) return false;
            if (_begin > 0) _motion.MoveTo(_begin, ref frame);
            frame.Magnitude = frame.Radius + frame.Margins + frame.Translation.SumOfMagnitudes;
            return true;
        }

        /// <summary>Solves the pair from where its balls meet on.</summary>
        [MethodImpl(MethodImplOptions.NoInlining)]
        void ICoreSolver.Solve<TA, TB>(ref TA a, ref TB b, ref PairFrame frame, ref SolverState state)
        {
            if (frame.Unit != 1) _motion.Resize(1 / frame.Unit);
            double tolerance = ToleranceOf(frame, _motion, _last), floor = Impact.FloorRatio * tolerance;
            var interval = new FractionInterval(_begin, _end);
            if (_follows)
            {
                _found = Follow(ref a, ref b, ref frame, interval, tolerance);
                return;
            }

            if (_isWindow) (tolerance, floor) = (WindowRoom * tolerance, tolerance);
            AdvancementSolver<TA, TB>.Solve(
                ref a, ref b, ref frame, ref _motion, interval, tolerance, floor, !_isWindow, ref *_warm,
                out Impact impact, out state);
            _found = Finish(impact, state, ref frame);
        }

        readonly void IPairSolver<CastResult>.Finish(
            in SolverState state, in PairFrame frame, in RigidPose poseA, in RigidPose poseB, out CastResult result) =>
            result = _found;

        /// <summary>In solver units.</summary>
        private readonly double ToleranceOf(in PairFrame frame, in PairMotion motion, double end)
        {
            double size = frame.Radius;

            // Points have no size, but the arms that they turn on do, or the way between them.
            if (!(size > 0)) size = motion.A.Reach + motion.B.Reach;
            if (!(size > 0)) size = motion.Start.Length;
            double least = Math.Max(LeastTolerance * size, RoundingTolerance * motion.Rounding(end, frame.Margins));
            double asked = _tolerance > 0 ? _tolerance / frame.Unit : DefaultTolerance * size;
            return Math.Max(Math.Min(asked, CoarsestTolerance * size), least);
        }

        /// <summary>The contact that counts, or none.</summary>
        private readonly CastResult Ended(in CastResult contact, in Impact impact) =>
            impact.Outcome == MotionVerdict.Hit
                ? contact.With(contact.Status, contact.Point, contact.Normal, impact.Iterations, contact.Depth)
                : Nothing(impact);

        private readonly CastResult Nothing(in Impact impact)
        {
            bool isMiss = impact.Outcome == MotionVerdict.Miss && _isWhole;
            CastStatus status = impact.Outcome == MotionVerdict.Contradiction ? CastStatus.InvalidShape
                : isMiss ? CastStatus.Miss : CastStatus.IterationLimit;
            return CastResult.Nothing(status, FractionOf(status, impact.Fraction, _maxFraction), impact.Iterations);
        }

        private readonly CastResult Finish(in Impact impact, in SolverState state, ref PairFrame frame)
        {
            if (impact.Outcome != MotionVerdict.Hit) return Nothing(impact);
            int iterations = impact.Iterations;
            float fraction = RoundOff.Down(impact.Fraction);
            if (impact.Fraction == 0 && impact.Normal == default)
            {
                DistanceFinish.Write(
                    state, frame, _motionA.Pose, _motionB.Pose, double.PositiveInfinity, false,
                    out DistanceResult common);
                return new CastResult(CastStatus.OverlappingAtStart, 0, common.PointA, Vector3.Zero, iterations);
            }

            // Balls that touch where they meet come without a plane.
            Double3 normal = impact.Normal == default
                ? frame.Translation * (1 / frame.Translation.Length)
                : impact.Normal;
            var outward = (Vector3)frame.RotationA.Rotate(normal);
            Double3 onA = state.Simplex.WitnessOnA(state.Weights);
            _motion.MoveTo(fraction, ref frame);
            Double3 position = (Double3)_motionA.Pose.Position + (Double3)_motionA.Velocity * fraction;
            return new CastResult(
                CastStatus.Hit, impact.Fraction, (Vector3)frame.SurfaceOfA(onA, normal, position), outward, iterations)
                .At(fraction);
        }
    }
}
