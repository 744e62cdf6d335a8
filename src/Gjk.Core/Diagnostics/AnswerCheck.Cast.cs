namespace Gjk.Core.Diagnostics;

public static partial class AnswerCheck
{
    /// <summary>Length, as a fraction of the larger of the size and the way: how far along the motion a cast may end
    /// early or late; 1e-7 of the scale is promised. Pinned by AnswerToleranceTests.</summary>
    private const double WayRatio = 1.2e-7;

    /// <summary>Length, as a fraction of the size: what passes no further away may be said to hit; 1e-9 of the scale is
    /// promised. Pinned by AnswerToleranceTests.</summary>
    private const double Graze = 2e-9;

    /// <summary>Length, as a fraction of the size: curved shapes touch when they are within 1e-9 of the scale, so that
    /// the point and the normal of a hit are known to the root of that. Pinned by AnswerToleranceTests.</summary>
    private const double CurvedMeeting = 1e-4;

    /// <summary>Checks an answer of <c>ConvexQuery.Cast</c>, of shapes that move without turning.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A at the start.</param>
    /// <param name="translationA">Its motion.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B at the start.</param>
    /// <param name="translationB">Its motion.</param>
    /// <param name="answer">What was said.</param>
    /// <returns>Bounds of the fraction of the first touch, 0 and +infinity where nothing is proved. A hit is proved by
    /// a plane that the motion has not crossed before it, and by a common point; a miss by a plane that it never
    /// crosses up to the fraction that it tells. A hit that hardly closes in is open where rounding could have turned
    /// it. Normal and depth of shapes that overlap at the start are held to what is said of a signed distance; a
    /// depth is open where a shorter way out is proved, since the search may have had no room. The number of
    /// iterations, and that their limit was reached, is not judged.</returns>
    public static CheckedAnswer Cast<TA, TB>(
        in TA a, in RigidPose poseA, Vector3 translationA, in TB b, in RigidPose poseB, Vector3 translationB,
        in CastResult answer)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        TA shapeA = a;
        TB shapeB = b;
        PosedPair.Of(ref shapeA, poseA, ref shapeB, poseB, out PosedPair pair);
        Double3 motion = (Double3)translationB - translationA;
        AnswerClaims claims = default;
        CheckedAnswer times = CheckTimes(ref claims, ref shapeA, ref shapeB, pair, motion, answer);
        if (answer.IsHit && claims.AreAny)
        {
            Double3 travelled = (Double3)translationA * answer.Fraction, point = answer.Point;
            Double3 onB = point - (Double3)translationB * answer.Fraction;
            double slack = MeetingSlack(pair, motion, answer.Fraction)
                + FloatRatio * (point.Length + travelled.Length);
            double slackA = slack + DoubleRatio * ((Double3)poseA.Position).Length;
            double slackB = slack + DoubleRatio * ((Double3)poseB.Position).Length + FloatRatio * onB.Length;
            AddPoint(ref claims, ref shapeA, pair.LocalToA(point - travelled, poseA), slackA);
            AddPoint(ref claims, ref shapeB, pair.LocalToB(onB, poseB), slackB);
        }

        return new CheckedAnswer(claims.Status, times.LowerBound, times.UpperBound);
    }

    /// <summary>Checks an answer of <c>ConvexQuery.RayCast</c>.</summary>
    /// <typeparam name="T">The shape's type.</typeparam>
    /// <param name="shape">The shape.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="origin">Where the ray begins.</param>
    /// <param name="direction">Its direction, of any length but 0.</param>
    /// <param name="answer">What was said.</param>
    /// <returns>Bounds of the distance along the ray to the shape, as for a cast. A way out is not checked:
    /// <see cref="CheckStatus.Open"/>.</returns>
    public static CheckedAnswer RayCast<T>(
        in T shape, in RigidPose pose, Vector3 origin, Vector3 direction, in RayCastResult answer)
        where T : struct, ISupportMap
    {
        if (answer.IsBackFace && Double3.Dot(answer.Normal, direction) > 0)
            return new CheckedAnswer(CheckStatus.Open, 0, double.PositiveInfinity);
        T copy = shape;
        PointShape point = default;
        RigidPose begin = Guard.IsFinite(origin) ? new RigidPose(origin) : default;
        PosedPair.Of(ref copy, pose, ref point, begin, out PosedPair pair);
        PosedPair.TryUnit(direction, out Double3 unit);
        var cast = new CastResult(answer.Status, answer.Distance, answer.Point, answer.Normal, 0, answer.Depth);
        AnswerClaims claims = default;
        CheckedAnswer times = CheckTimes(ref claims, ref copy, ref point, pair, unit, cast);
        if (answer.IsHit && claims.AreAny)
        {
            Double3 met = answer.Point;
            double slack = MeetingSlack(pair, unit, answer.Distance) + FloatRatio * met.Length
                + DoubleRatio * ((Double3)pose.Position).Length;
            AddPoint(ref claims, ref copy, pair.LocalToA(met, pose), slack);
            double off = (unit * answer.Distance + origin - met).Length;
            claims.Add(off <= slack + FloatRatio * ((Double3)origin).Length);
        }

        return new CheckedAnswer(claims.Status, times.LowerBound, times.UpperBound);
    }

    /// <summary>Of a pair of which B moves, A rests.</summary>
    private static CheckedAnswer CheckTimes<TA, TB>(
        ref AnswerClaims claims, ref TA a, ref TB b, in PosedPair pair, in Double3 motion, in CastResult answer)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        double fraction = answer.Fraction, touch = Touch(pair);
        if (!pair.IsValid || !motion.IsFinite || !HasTime(answer.Status))
        {
            claims.Add(false, false);
            return new CheckedAnswer(default, 0, double.PositiveInfinity);
        }

        bool isAtStart = answer.Status == CastStatus.OverlappingAtStart;
        claims.Add(fraction >= 0 && (!isAtStart || fraction == 0) && (isAtStart || answer.Depth == 0));
        claims.Add(answer.IsHit ? Guard.IsFinite(answer.Point) : IsNothing(answer.Point) && IsNothing(answer.Normal));
        if (answer.Status == CastStatus.Hit) return CheckHit(ref claims, ref a, ref b, pair, motion, answer);
        if (isAtStart)
        {
            var depth = new DistanceResult(
                GjkStatus.Overlapping, -answer.Depth, float.NegativeInfinity, default, default, answer.Normal, default,
                default, 0);
            claims.MayBeLess = true;
            WitnessWalk walk = AddNumbers(ref claims, ref a, ref b, pair, depth, double.NaN, true);
            return new CheckedAnswer(default, 0, walk.Upper <= touch ? 0 : double.PositiveInfinity);
        }

        // What has gone past does not come back, however long the rest of the way is.
        double speed = motion.Length, past = 2 * (pair.Size + pair.Between.Length) / speed;
        Double3 way = speed > 0 ? motion * Math.Min(fraction, past) : default;
        bool isFree = IsFree(ref a, ref b, pair, way, default, out bool isCrossed);

        // Two points have no inside to be crossed.
        claims.Add(isFree, isCrossed && pair.Size > 0);
        return new CheckedAnswer(default, isFree ? fraction : 0, double.PositiveInfinity);
    }

    private static bool HasTime(CastStatus status) =>
        status is CastStatus.Hit or CastStatus.Miss or CastStatus.OverlappingAtStart or CastStatus.IterationLimit;

    private static CheckedAnswer CheckHit<TA, TB>(
        ref AnswerClaims claims, ref TA a, ref TB b, in PosedPair pair, in Double3 motion, in CastResult answer)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        double fraction = answer.Fraction, speed = motion.Length;
        Double3 normal = answer.Normal;
        PosedPair hit = pair.Moved(motion * fraction);
        double closing = -Double3.Dot(normal, motion) / speed, slack = WaySlack(pair, motion, fraction);
        double touch = Touch(hit);
        bool isUnit = PosedPair.TryUnit(normal, out Double3 unit) && IsUnit(normal);
        double gap = isUnit ? hit.Gap(ref a, ref b, unit, out _) : double.NaN;
        double tilt = pair.IsCurved ? CurvedMeeting : TiltRatio;
        claims.Add(closing >= -tilt && Math.Abs(gap) <= slack + touch + tilt * pair.Size);

        // Along a motion that hardly closes in, what touches within rounding does so for a long way.
        double allowed = slack + touch / Math.Max(closing, TiltRatio);
        double early = fraction - allowed / speed, late = fraction + allowed / speed;
        early = Math.Max(early, 0);
        bool isFree = IsFree(ref a, ref b, pair, motion * early, normal, out bool isCrossed) || early == 0;
        claims.Add(isFree, isCrossed);
        PosedPair around = pair.Moved(motion * early, motion * (late - early));
        WitnessWalk met = WitnessWalk.Of(ref a, ref b, around, normal, double.NegativeInfinity, touch);
        bool isMet = met.Upper <= touch;
        claims.Add(isMet, met.Lower > Math.Max(touch, Graze * pair.Size));
        return new CheckedAnswer(default, isFree ? early : 0, isMet ? late : double.PositiveInfinity);
    }

    /// <summary>Whether a plane leaves room for the whole way; or else whether B certainly runs into A on it.</summary>
    private static bool IsFree<TA, TB>(
        ref TA a, ref TB b, in PosedPair pair, in Double3 way, in Double3 hint, out bool isCrossed)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        PosedPair swept = pair.Moved(default, way);
        WitnessWalk walk = WitnessWalk.Of(ref a, ref b, swept, hint, double.Epsilon, double.PositiveInfinity);
        isCrossed = walk.Lower <= 0 && IsDeep(ref a, ref b, swept, walk);
        return walk.Lower > 0;
    }

    /// <summary>How far the point of a hit may be off the shapes.</summary>
    private static double MeetingSlack(in PosedPair pair, in Double3 motion, double fraction) =>
        WaySlack(pair, motion, fraction) + 3 * LeastFloat + (pair.IsCurved ? CurvedMeeting * pair.Size : 0);

    /// <summary>How far along the motion the fraction may be off.</summary>
    private static double WaySlack(in PosedPair pair, in Double3 motion, double fraction) =>
        WayRatio * Math.Max(2 * pair.Size, fraction * motion.Length) + LeastFloat;
}
