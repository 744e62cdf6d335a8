namespace Gjk.Core.Diagnostics;

public static partial class AnswerCheck
{
    /// <summary>Length, as a fraction of the size: how far B is moved beyond the depth, to look for a face's own
    /// direction where the normal is rounded. Any small one will do.</summary>
    private const double Beyond = 1.0 / (1 << 10);

    /// <summary>Checks an answer of <c>ConvexQuery.Distance</c>.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="answer">What was said.</param>
    /// <param name="tolerance">World units: how much the distance may be off. NaN, the default: the float's rounding
    /// and 1e-13 of the size; of curved cores 2e-6 of the larger of size and distance. The size is the sum of the
    /// bounding radii.</param>
    /// <returns>Bounds of the signed distance. A result that overlaps is held to that; one that ended beyond a largest
    /// distance, or at the iteration limit, to its bounds and its normal, whatever its points are; one of invalid input
    /// is open. That an iteration limit was reached, and the number of iterations, is not judged.</returns>
    public static CheckedAnswer Distance<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, in DistanceResult answer,
        double tolerance = double.NaN)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap => Check(a, poseA, b, poseB, answer, tolerance, false);

    /// <summary>Checks an answer of <c>ConvexQuery.SignedDistance</c>. Of a depth, two witnesses prove that B leaves A
    /// after so much along the normal, and so that the depth is no larger; see
    /// <see cref="CheckStatus.ProvedAtMost"/>.</summary>
    /// <typeparam name="TA">The first shape's type.</typeparam>
    /// <typeparam name="TB">The second shape's type.</typeparam>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="answer">What was said.</param>
    /// <param name="tolerance">As for a distance.</param>
    /// <returns>Bounds of the signed distance. Both meet where shapes are apart, touch, or overlap by their margins
    /// alone.</returns>
    public static CheckedAnswer SignedDistance<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, in DistanceResult answer,
        double tolerance = double.NaN)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap => Check(a, poseA, b, poseB, answer, tolerance, true);

    private static CheckedAnswer Check<TA, TB>(
        TA a, in RigidPose poseA, TB b, in RigidPose poseB, in DistanceResult answer, double tolerance, bool isSigned)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        PosedPair.Of(ref a, poseA, ref b, poseB, out PosedPair pair);
        AnswerClaims claims = default;
        WitnessWalk walk = AddNumbers(ref claims, ref a, ref b, pair, answer, tolerance, isSigned);
        if (claims.AreAny && (answer.IsOverlapping || answer.Status == GjkStatus.Separated))
            AddPoints(ref claims, ref a, poseA, ref b, poseB, pair, answer);
        return new CheckedAnswer(claims.Status, walk.Lower, walk.Upper);
    }

    /// <summary>The status, the distance or depth, the lower bound and the normal.</summary>
    private static WitnessWalk AddNumbers<TA, TB>(
        ref AnswerClaims claims, ref TA a, ref TB b, in PosedPair pair, in DistanceResult answer, double tolerance,
        bool isSigned)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        bool isSeparated = answer.Status == GjkStatus.Separated, isDepth = answer.IsOverlapping && isSigned;
        bool isBeyond = answer.Status == GjkStatus.BeyondMaxDistance;
        double allowed = !double.IsNaN(tolerance) ? tolerance
            : Allowed(pair, isBeyond ? answer.LowerBound : answer.Distance);

        // No distance is below 0, so that a bound which is not above says nothing.
        bool isIdle = !isSigned && !isSeparated && !isBeyond && answer.LowerBound <= 0;
        double bound = isIdle ? double.NegativeInfinity : answer.LowerBound;
        double least = (isSeparated || isDepth ? answer.Distance : bound) - allowed;
        double most = answer.IsOverlapping && !isSigned ? Touch(pair) : answer.Distance + allowed;
        WitnessWalk walk = WitnessWalk.Of(ref a, ref b, pair, answer.Normal, least, most);
        if (!pair.IsValid || !(answer.IsOverlapping || HasBounds(answer.Status)))
        {
            claims.Add(false, false);
            return walk;
        }

        if (isDepth) walk.Lower = Math.Max(walk.Lower, Leaving(ref a, ref b, pair, answer, allowed));
        claims.IsAtMost = isDepth && walk.Upper > most;
        claims.Add(IsOfStatus(answer, isSigned));
        bool isWithin = walk.IsWithin(least, isDepth ? Math.Max(most, Touch(pair)) : most);
        bool isLess = walk.Lower > most;
        bool isOther = claims.MayBeLess && walk.Lower <= Touch(pair);
        double way = isOther ? walk.HintGap - pair.Noise : walk.Lower;
        claims.Add(isWithin && !isLess, isLess && !(way <= most) || walk.Upper < least);

        // Of shapes that are said to be apart 0 says nothing more.
        double upper = isSigned && !isSeparated ? walk.Upper : Math.Max(walk.Upper, 0);
        claims.Add(bound <= walk.Lower + allowed, !(bound <= upper));
        if (answer.IsOverlapping && !isSigned)
        {
            claims.Add(answer.Normal == default && answer.Distance == 0);
            return walk;
        }

        // The planes across the normal stand as far apart as the answer says, and where others do, it has their side.
        double d = isSeparated || isDepth ? answer.Distance : bound;
        Double3 normal = answer.Normal;
        claims.Add(IsUnit(normal) && walk.HintGap >= d - allowed - pair.Noise - TiltRatio * (pair.Size + Math.Abs(d)));
        claims.Add(!isSeparated || walk.Lower <= allowed || Double3.Dot(normal, walk.Across) > 0);
        return walk;
    }

    /// <summary>Whether a distance is one that goes with the status.</summary>
    private static bool IsOfStatus(in DistanceResult answer, bool isSigned)
    {
        float d = answer.Distance;
        if (answer.Status == GjkStatus.BeyondMaxDistance) return float.IsPositiveInfinity(d);
        bool isOfSign = answer.Status == GjkStatus.Separated ? d >= 0
            : !answer.IsOverlapping || (isSigned ? d <= 0 : d == 0);
        return isOfSign && Math.Abs(d) <= float.MaxValue;
    }

    /// <summary>Whether the answer is a distance, or bounds of one.</summary>
    private static bool HasBounds(GjkStatus status) =>
        status is GjkStatus.Separated or GjkStatus.BeyondMaxDistance or GjkStatus.IterationLimit;

    /// <summary>A lower bound of the signed distance: moved out along the normal and a little beyond, B has a distance
    /// again, and no signed distance changes by more than B moves.</summary>
    private static double Leaving<TA, TB>(
        ref TA a, ref TB b, in PosedPair pair, in DistanceResult answer, double allowed)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        double beyond = Beyond * pair.Size;
        if (!PosedPair.TryUnit(answer.Normal, out Double3 way)) return double.NegativeInfinity;
        way *= beyond - answer.Distance;
        WitnessWalk moved = WitnessWalk.Of(
            ref a, ref b, pair.Moved(way), answer.Normal, beyond - 0.5 * allowed, double.PositiveInfinity);
        return moved.Lower - way.Length - pair.Noise;
    }

    /// <summary>In both frames the points lie on their shapes, are the same, and differ by the distance.</summary>
    private static void AddPoints<TA, TB>(
        ref AnswerClaims claims, ref TA a, in RigidPose poseA, ref TB b, in RigidPose poseB, in PosedPair pair,
        in DistanceResult answer)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Double3 localA = answer.LocalPointA, localB = answer.LocalPointB, onA = answer.PointA, onB = answer.PointB;
        Double3 way = (Double3)answer.Normal * answer.Distance;
        double slack = PointSlack(pair, answer.Distance), wayA = FloatRatio * localA.Length;
        double wayB = FloatRatio * localB.Length, atA = WorldSlack(onA, poseA), atB = WorldSlack(onB, poseB);
        double between = 2 * (slack + FloatRatio * way.Length);
        claims.Add(localA.IsFinite && localB.IsFinite && onA.IsFinite && onB.IsFinite);
        AddPoint(ref claims, ref a, localA, slack + wayA);
        AddPoint(ref claims, ref b, localB, slack + wayB);
        AddPoint(ref claims, ref a, pair.LocalToA(onA, poseA), slack + atA);
        AddPoint(ref claims, ref b, pair.LocalToB(onB, poseB), slack + atB);
        claims.Add((pair.WorldOfA(localA, poseA) - onA).Length <= slack + wayA + atA);
        claims.Add((pair.WorldOfB(localB, poseB) - onB).Length <= slack + wayB + atB);
        claims.Add((pair.Way(ref a, localA, ref b, localB) - way).Length <= between + wayA + wayB);
        claims.Add((onB - onA - way).Length <= between + atA + atB);
    }

    /// <summary>What rounding to float, and the way there in double, can do to a point of the world.</summary>
    private static double WorldSlack(in Double3 point, in RigidPose pose) =>
        FloatRatio * point.Length + DoubleRatio * ((Double3)pose.Position).Length;
}
