namespace Gjk.Core.Tests.Support;

/// <summary>Everything that two shapes can be asked, for tests of what a call takes beside its answer.</summary>
internal static class EveryVerb
{
    private static readonly Vector3 Turn = new(0.3f, 2, -1);

    /// <summary>One call each, none of them in the frame of another.</summary>
    public static Action[] Of<TA, TB>(TA a, RigidPose poseA, TB b, RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Vector3 between = poseB.Position - poseA.Position, at = poseB.Position;
        DistanceResult apart = ConvexQuery.Distance(a, poseA, b, poseB);
        DistanceResult signed = ConvexQuery.SignedDistance(a, poseA, b, poseB);
        CastResult cast = ConvexQuery.Cast(a, poseA, between * 2, b, poseB, default);
        RayCastResult ray = ConvexQuery.RayCast(a, poseA, at, -between);
        return
        [
            () => ConvexQuery.Distance(a, poseA, b, poseB),
            () => ConvexQuery.Distance(a, poseA, b, poseB, 0.1f),
            () => ConvexQuery.Distance(a, poseA, b, poseB, out _),
            () => ConvexQuery.Distance(a, poseA, at),
            () => ConvexQuery.SignedDistance(a, poseA, b, poseB),
            () => ConvexQuery.SignedDistance(a, poseA, b, poseB, out _),
            () => ConvexQuery.SignedDistance(a, poseA, at),
            () => ConvexQuery.Overlaps(a, poseA, b, poseB),
            () => ConvexQuery.ClosestPoint(a, poseA, at),
            () => ConvexQuery.Contains(a, poseA, at),
            () => ConvexQuery.RayCast(a, poseA, at, -between),
            .. Moving(a, poseA, b, poseB),
            .. Warm(a, poseA, b, poseB),
            .. Traced(a, poseA, b, poseB),
            () => AnswerCheck.Distance(a, poseA, b, poseB, apart),
            () => AnswerCheck.SignedDistance(a, poseA, b, poseB, signed),
            () => AnswerCheck.Overlaps(a, poseA, b, poseB, true),
            () => AnswerCheck.Cast(a, poseA, between * 2, b, poseB, default, cast),
            () => AnswerCheck.RayCast(a, poseA, at, -between, ray),
        ];
    }

    private static Action[] Moving<TA, TB>(TA a, RigidPose poseA, TB b, RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Vector3 between = (poseB.Position - poseA.Position) * 2;
        CastOptions deeper = CastOptions.OnlyDeeper();
        RigidMotion motion = new(poseA, between, Turn), still = new(poseB, default);
        return
        [
            () => ConvexQuery.Cast(a, poseA, between, b, poseB, default),
            () => ConvexQuery.Cast(a, poseA, between, b, poseB, default, 1, deeper),
            () => ConvexQuery.TimeOfImpact(a, motion, b, still),
            () => ConvexQuery.TimeOfImpact(a, motion, b, still, 0, 1, deeper),
        ];
    }

    private static Action[] Warm<TA, TB>(TA a, RigidPose poseA, TB b, RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Vector3 between = (poseB.Position - poseA.Position) * 2;
        RigidMotion motion = new(poseA, between, Turn), still = new(poseB, default);
        var warm = default(WarmStart);
        ContactManifold manifold = default;
        return
        [
            () => ConvexQuery.Distance(a, poseA, b, poseB, ref warm),
            () => ConvexQuery.SignedDistance(a, poseA, b, poseB, ref warm),
            () => ConvexQuery.Contacts(a, poseA, b, poseB, ref warm, 0.1f, out manifold),
            () => ConvexQuery.Contacts(a, poseA, b, poseB, 0.1f, out manifold),
            () => ConvexQuery.Cast(a, poseA, between, b, poseB, default, ref warm, 1),
            () => ConvexQuery.TimeOfImpact(a, motion, b, still, ref warm, 1e-4f, 1),
        ];
    }

    private static Action[] Traced<TA, TB>(TA a, RigidPose poseA, TB b, RigidPose poseB)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        var steps = default(Untold);
        return
        [
            () => ConvexQuery.Explain(a, poseA, b, poseB, ref steps),
            () => ConvexQuery.ExplainDepth(a, poseA, b, poseB, ref steps),
        ];
    }

    private struct Untold : IGjkTrace, IPolytopeTrace
    {
        public readonly bool IsOn => true;

        public readonly void OnSupport(in TracedSupport support)
        {
        }

        public readonly void OnReduced(in TracedSimplex simplex)
        {
        }

        public readonly void OnStep(in PolytopeStep step)
        {
        }
    }
}
