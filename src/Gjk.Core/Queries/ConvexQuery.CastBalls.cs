namespace Gjk.Core;

// Two balls (or points) that move: a line against a ball about A's centre with both radii, measured from the point of
// the line that is nearest to the centre (Ericson, Real-Time Collision Detection, 2005, section 5.3.2). Whether they
// touch at the start is what the distance says.
public static partial class ConvexQuery
{
    /// <summary>Ratio to the way and the radii: what rounding does to the place of the line, 32 roundings, where 20 are
    /// the most (proofs/ball-line.g). A line that passes the ball by less touches it. Pinned by
    /// CastToleranceTests.BallsThatPassByThirtyTwoRoundingsTouch.</summary>
    private const double BallLineError = 32 * RoundOff.Unit;

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static CastResult CastBalls<TA, TB>(
        ref TA a, in RigidPose poseA, Vector3 translationA, ref TB b, in RigidPose poseB, Vector3 translationB,
        float maxFraction)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Double3 motion = (Double3)translationB - translationA;
        Balls.Distance(
            ref a, poseA, ref b, poseB, float.PositiveInfinity, isSigned: false, out DistanceResult start);
        if (start.Status == GjkStatus.InvalidInput || float.IsNaN(maxFraction)
            || !Guard.IsFinite(translationA) || !motion.IsFinite)
        {
            return CastResult.Nothing(CastStatus.InvalidInput, float.NaN, 0);
        }

        if (start.IsOverlapping)
            return new CastResult(CastStatus.OverlappingAtStart, 0, start.PointA, Vector3.Zero, 1);
        float most = Math.Max(maxFraction, 0);
        Double3 between = PairFrame.BetweenCenters(poseA, a.Center, poseB, b.Center);
        double speed = motion.Length, radii = a.Margin + b.Margin;
        Double3 axis = motion * (1 / speed);
        double way = -Double3.Dot(between, axis);
        if (!(way > 0)) return CastResult.Nothing(CastStatus.Miss, most, 1);
        Double3 nearest = between + axis * way;
        nearest -= axis * Double3.Dot(nearest, axis);
        double passing = nearest.Length, along = way;
        if (passing > radii + BallLineError * (radii + way)) return CastResult.Nothing(CastStatus.Miss, most, 1);
        if (passing < radii) along -= Math.Sqrt((radii - passing) * (radii + passing));
        double fraction = Math.Max(along, 0) / speed;
        if (CastSolver.IsBeyond(fraction, most)) return CastResult.Nothing(CastStatus.Miss, most, 1);
        Double3 normal = nearest + axis * (along - way);
        normal = radii > 0 ? normal * (1 / normal.Length) : -axis;
        Double3 point = Balls.Place(poseA, a.Center) + normal * a.Margin + (Double3)translationA * fraction;
        return new CastResult(CastStatus.Hit, fraction, (Vector3)point, (Vector3)normal, 1);
    }
}
