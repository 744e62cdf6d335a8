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
            return TryCastPoint(ref a, poseA, translationA, poseB, motion, maxFraction, ref result);
        if (!IsPoint(ref a)
            || !TryCastPoint(ref b, poseB, translationB, poseA, -motion, maxFraction, ref result))
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
        ref CastResult result)
        where T : struct, ISupportMap
    {
        double turn = Balls.InverseTurn(pose.Rotation), length = motion.Length;
        double reach = Math.Max(maxFraction, 0) * length * (1 + GjkTolerances.FloatBand);
        var line = new WorldRay(point.Position, motion, length, reach);
        if (!IsRay(pose, turn, line) || !point.IsValid || !Guard.IsFinite(translation)
            || !TryClosedForm(ref shape, pose, turn, line, out RayMeeting hit))
        {
            return false;
        }

        if (hit.IsAtSurface && IsInside(ref shape, pose, line.Origin)) hit.Status = CastStatus.OverlappingAtStart;
        double fraction = hit.Distance / length;
        if (hit.Status == CastStatus.Hit && CastSolver.IsBeyond(fraction, Math.Max(maxFraction, 0)))
            hit.Status = CastStatus.Miss;
        result = hit.Status switch
        {
            CastStatus.Hit => new CastResult(
                CastStatus.Hit, fraction, (Vector3)(hit.Point + (Double3)translation * fraction),
                (Vector3)hit.Normal, 0),
            CastStatus.Miss => CastResult.Nothing(CastStatus.Miss, Math.Max(maxFraction, 0), 0),
            _ => new CastResult(hit.Status, 0, line.Origin, (Vector3)hit.Normal, 0),
        };
        return true;
    }

    /// <summary>Whether nothing is left of a shape, which its own origin is then.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsPoint<T>(ref T shape)
        where T : struct, ISupportMap =>
        shape.BoundingRadius == 0 && shape.Margin == 0 && shape.Center.SumOfMagnitudes == 0;
}
