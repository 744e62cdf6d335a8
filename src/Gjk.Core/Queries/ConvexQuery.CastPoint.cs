namespace Gjk.Core;

// A cast in which one of the shapes is a point is a ray, and has its closed forms. Any type that is a point comes
// here, so all of them have the same bits.
public static partial class ConvexQuery
{
    /// <summary>Casts a pair of which one shape is a point that moves, seen from the other.</summary>
    /// <returns>False where it is no such pair, or no closed form fits it.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool TryCastPoint<TA, TB>(
        ref TA a, in RigidPose poseA, Vector3 translationA, ref TB b, in RigidPose poseB, Vector3 translationB,
        float maxFraction, out CastResult result)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        result = default;
        Double3 motion = (Double3)translationB - translationA;
        if (IsPoint(ref b))
            return TryCastPoint(ref a, poseA, translationA, poseB, motion, maxFraction, false, ref result);
        if (!IsPoint(ref a)
            || !TryCastPoint(ref b, poseB, translationB, poseA, -motion, maxFraction, true, ref result))
        {
            return false;
        }

        result = result.Swapped;
        return true;
    }

    /// <summary>A point, which is seen to move, against a shape that is translated in the world.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static bool TryCastPoint<T>(
        ref T shape, in RigidPose pose, Vector3 translation, in RigidPose point, in Double3 motion, float maxFraction,
        bool isPointFirst, ref CastResult result)
        where T : struct, ISupportMap
    {
        double turn = Balls.RotationScale(pose.Rotation), length = motion.Length;
        double reach = Math.Max(maxFraction, 0) * length * (1 + GjkTolerances.FloatBand);
        var line = new WorldRay(point.Position, motion, length, reach);
        if (!IsRay(pose, turn, line) || !point.IsValid || !Guard.IsFinite(translation)
            || !TryClosedForm(ref shape, pose, turn, line, out RayMeeting hit))
        {
            return false;
        }

        if (hit.IsAtSurface && IsInside(ref shape, pose, point, isPointFirst))
            hit.Status = CastStatus.OverlappingAtStart;
        double fraction = hit.Distance / length;
        if (hit.Status == CastStatus.Hit && CastSolver.IsBeyond(fraction, Math.Max(maxFraction, 0)))
            hit.Status = CastStatus.Miss;
        result = hit.Status switch
        {
            CastStatus.Hit => new CastResult(
                CastStatus.Hit, fraction, (Vector3)(hit.Point + (Double3)translation * fraction),
                (Vector3)hit.Normal, 0),
            CastStatus.Miss => CastResult.Nothing(CastStatus.Miss, Math.Max(maxFraction, 0), 0),
            _ => new CastResult(hit.Status, 0, point.Position, (Vector3)hit.Normal, 0),
        };
        return true;
    }

    /// <summary>True for a point at the local origin with no margin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsPoint<T>(ref T shape)
        where T : struct, ISupportMap =>
        shape.BoundingRadius == 0 && shape.Margin == 0 && shape.Center.SumOfMagnitudes == 0;

    /// <summary>Ratio to the way and the radii: what rounding does to the place of the line, 32 roundings, where 20 are
    /// the most (proofs/ball-line.g). A line that passes the ball by less touches it. Pinned by
    /// CastToleranceTests.BallsThatPassByThirtyTwoRoundingsTouch.</summary>
    private const double BallLineError = 32 * RoundOff.Unit;

    /// <summary>Two balls (or points) that move: a line against a ball about A's centre with both radii, measured from
    /// the point of the line that is nearest to the centre (Ericson, Real-Time Collision Detection, 2005, section
    /// 5.3.2). Whether they touch at the start is what the distance says.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static CastResult CastBalls<TA, TB>(
        ref TA a, in RigidPose poseA, Vector3 translationA, ref TB b, in RigidPose poseB, Vector3 translationB,
        float maxFraction)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Double3 motion = (Double3)translationB - translationA;
        Balls.Distance(ref a, poseA, ref b, poseB, float.PositiveInfinity, isSigned: false, out DistanceResult start);
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
        Double3 point = Balls.ToWorld(poseA, a.Center) + normal * a.Margin + (Double3)translationA * fraction;
        return new CastResult(CastStatus.Hit, fraction, (Vector3)point, (Vector3)normal, 1);
    }
}
