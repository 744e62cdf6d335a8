namespace Gjk.Core.Tests.Support;

/// <summary>All that can be asked of a pair of shapes, or of a shape and a point.</summary>
internal static class EveryQuery
{
    /// <summary>Asks every pair query, with a warm start that may be another pair's and motions of the length of the
    /// scale. Each query is named before it is asked.</summary>
    public static void Ask<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, ref WarmStart stale, float scale, Rng rng,
        Action<string> says)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        says("Overlaps");
        ConvexQuery.Overlaps(a, poseA, b, poseB);
        says("Distance");
        ConvexQuery.Distance(a, poseA, b, poseB);
        says("Distance of at most");
        ConvexQuery.Distance(a, poseA, b, poseB, rng.Float(0, 1) * scale);
        says("Distance, warm");
        ConvexQuery.Distance(a, poseA, b, poseB, ref stale);
        says("Distance, warm, again");
        ConvexQuery.Distance(a, poseA, b, poseB, ref stale);
        says("SignedDistance");
        ConvexQuery.SignedDistance(a, poseA, b, poseB, out _);
        says("SignedDistance, warm");
        ConvexQuery.SignedDistance(a, poseA, b, poseB, ref stale);
        says("Contacts");
        ContactManifold manifold = default;
        ConvexQuery.Contacts(a, poseA, b, poseB, scale, out manifold);
        AskMoving(a, poseA, b, poseB, ref stale, scale, rng, says);
    }

    /// <summary>Asks every query of a shape and a point.</summary>
    public static void AskPoint<T>(
        in T shape, in RigidPose pose, Vector3 point, float scale, Rng rng, Action<string> says)
        where T : struct, ISupportMap
    {
        says("Contains");
        ConvexQuery.Contains(shape, pose, point);
        says("Distance of a point");
        ConvexQuery.Distance(shape, pose, point);
        says("SignedDistance of a point");
        ConvexQuery.SignedDistance(shape, pose, point);
        says("ClosestPoint");
        ConvexQuery.ClosestPoint(shape, pose, point);
        foreach (Vector3 direction in new[] { rng.UnitVector(), Vector3.UnitX, -Vector3.UnitY, pose.Position - point })
        {
            says($"RayCast along {direction}");
            ConvexQuery.RayCast(shape, pose, point, direction);
            ConvexQuery.RayCast(shape, pose, point - direction * (3 * scale), direction);
        }
    }

    private static void AskMoving<TA, TB>(
        in TA a, in RigidPose poseA, in TB b, in RigidPose poseB, ref WarmStart stale, float scale, Rng rng,
        Action<string> says)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Vector3 between = poseB.Position - poseA.Position, any = rng.UnitVector() * scale;
        Vector3 across = Vector3.Cross(any, between) / Math.Max(scale, 1e-30f);
        foreach (Vector3 motion in new[] { default, between, any, across, Vector3.UnitX * scale })
        {
            if (!float.IsFinite(motion.X + motion.Y + motion.Z)) continue;
            says($"Cast by {motion}");
            ConvexQuery.Cast(a, poseA, motion, b, poseB, default);
            says($"Cast by {motion}, together");
            ConvexQuery.Cast(a, poseA, motion, b, poseB, motion);
            says($"Cast by {motion}, warm");
            ConvexQuery.Cast(a, poseA, motion, b, poseB, default, ref stale, 1);
            Vector3 turn = rng.Below(2) == 0 ? default : rng.UnitVector() * 3;
            says($"TimeOfImpact by {motion}, turning by {turn}");
            ConvexQuery.TimeOfImpact(a, new RigidMotion(poseA, motion, turn), b, new RigidMotion(poseB, default));
        }
    }
}
