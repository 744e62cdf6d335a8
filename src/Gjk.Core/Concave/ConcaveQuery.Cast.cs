namespace Gjk.Core;

public static partial class ConcaveQuery
{
    /// <summary>When two shapes that move without turning first touch: both are translated over the fractions from 0 to
    /// 1.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A at the start.</param>
    /// <param name="translationA">Its motion, in world units, any finite vector.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B at the start.</param>
    /// <param name="translationB">Its motion.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <param name="maxFraction">How much of the motion is looked at: 1 for all of it, more for the same motion
    /// continued; less than 0 counts as 0.</param>
    /// <param name="options">Which contacts are passed; by default none. What is inside the union of the parts at the
    /// start may slide along the union, and gets no deeper in it.</param>
    /// <returns>The least fraction over all pairs of parts, with the result that <c>ConvexQuery.Cast</c> has for them;
    /// at the start the pair that overlaps deepest; where several are met at once, one whose normal separates all that
    /// are met at its point; then a face goes before an edge and an edge before a corner; then the least numbers. What
    /// begins inside a solid is OverlappingAtStart, with the way out over the solid's outside, of several in a compound
    /// that of the deepest: for a convex part whose middle is inside, the shortest way across one of the solid's faces
    /// that leads out. What touches its surface and moves into it is a hit at 0. Invalid input gives
    /// <see cref="CastStatus.InvalidInput"/>, and so does a scratch that is null, unless both shapes are
    /// convex.</returns>
    public static CastHit Cast(
        in AnyShape a, in RigidPose poseA, Vector3 translationA, in AnyShape b, in RigidPose poseB,
        Vector3 translationB, ConcaveScratch scratch, float maxFraction = 1, in CastOptions options = default)
    {
        if (AreConvex(a, b))
        {
            return new CastHit(
                ConvexQuery.Cast(
                    AnyShape.ConvexOf(a), poseA, translationA, AnyShape.ConvexOf(b), poseB, translationB, maxFraction,
                    options));
        }

        bool isValid = Guard.IsFinite(translationA) && Guard.IsFinite(translationB);
        if (!isValid || !TrySetSides(a, poseA, b, poseB, scratch)) return InvalidCast;
        var motionA = new RigidMotion(poseA, translationA);
        var motionB = new RigidMotion(poseB, translationB);
        return CastMotion(scratch, new PartMotion(MotionKind.Cast, motionA, motionB, maxFraction, 0, options));
    }

    /// <summary>When two shapes that move and turn at constant rates first touch, to within a tolerance.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="motionA">How it moves over the fractions from 0 to 1.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="motionB">How it moves.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <param name="tolerance">How accurate the touch is: the largest distance of a hit, in world units; 0 or less: at
    /// most 1e-5 of the parts' sizes. Not coarser than 2e-3 of two parts' bounding radii: it is no distance to
    /// keep.</param>
    /// <param name="maxFraction">See <see cref="Cast"/>.</param>
    /// <param name="options">See <see cref="Cast"/>.</param>
    /// <returns>The least fraction over all pairs of parts, with the result that <c>ConvexQuery.TimeOfImpact</c> has
    /// for them; else as <see cref="Cast"/>.</returns>
    public static CastHit TimeOfImpact(
        in AnyShape a, in RigidMotion motionA, in AnyShape b, in RigidMotion motionB, ConcaveScratch scratch,
        float tolerance = 0, float maxFraction = 1, in CastOptions options = default)
    {
        if (AreConvex(a, b))
        {
            return new CastHit(
                ConvexQuery.TimeOfImpact(
                    AnyShape.ConvexOf(a), motionA, AnyShape.ConvexOf(b), motionB, tolerance, maxFraction, options));
        }

        bool isValid = motionA.IsValid && motionB.IsValid && !float.IsNaN(tolerance);
        if (!isValid || !TrySetSides(a, motionA.Pose, b, motionB.Pose, scratch)) return InvalidCast;
        var motion = new PartMotion(MotionKind.Impact, motionA, motionB, maxFraction, tolerance, options);
        return CastMotion(scratch, motion);
    }

    private static CastHit InvalidCast => new(CastResult.Nothing(CastStatus.InvalidInput, float.NaN, 0));

    private static CastHit CastMotion(ConcaveScratch scratch, in PartMotion motion, List<CastHit>? all = null)
    {
        if (float.IsNaN(motion.MaxFraction)) return InvalidCast;
        if (motion.Options.PassesShallow) return CastInUnion(scratch, motion, all);
        CastHit first = FirstContact(scratch, motion, motion.B.Pose, default, all);
        if (all is not null) return default;
        bool isAtStart = first.Status == CastStatus.OverlappingAtStart;
        if (!scratch.A.HasInside && !scratch.B.HasInside) return first;
        if (!isAtStart && TryFindInside(scratch, motion, first.Result, out CastHit inside)) first = inside;
        bool isIn = first.Status == CastStatus.OverlappingAtStart;
        return isIn && SolidExit.TryFind(scratch, out CastHit way) ? way : first;
    }

    /// <summary>The first contact of parts that counts, also with B at the pose that it is lifted to.</summary>
    private static CastHit FirstContact(
        ConcaveScratch scratch, in PartMotion motion, in RigidPose lifted, in Double3 lift, List<CastHit>? all)
    {
        PartSide sideA = scratch.A, sideB = scratch.B;
        ref PartCastSearch search = ref scratch.CastSearch;
        search.Reset(scratch, motion);
        if (lifted != motion.B.Pose) search.SetLifted(lifted, lift);
        search.CollectedCasts = all;
        bool isAdvanced = motion.Kind == MotionKind.Impact && search.Speed > 0 && !motion.Options.PassesShallow
            && all is null && !sideA.IsEndless && !sideB.IsEndless;
        if (isAdvanced) PartAdvancement.Run(scratch, motion);
        else PartCastSearch.Run(scratch);
        search.CollectedCasts = null;
        if (all is null) SimultaneousHits.KeepSeparating(scratch, motion);
        return search.PartA < 0
            ? new CastHit(CastResult.Nothing(CastStatus.Miss, Math.Max(motion.MaxFraction, 0), 0))
            : new CastHit(search.Cast, sideA.NumberOf(search.PartA), sideB.NumberOf(search.PartB), search.Feature);
    }

    /// <summary>Every pair of parts that meets, or overlaps at the start, as it would without the others.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A at the start.</param>
    /// <param name="translationA">Its motion, in world units, any finite vector.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B at the start.</param>
    /// <param name="translationB">Its motion.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <param name="hits">Cleared, then what <c>ConvexQuery.Cast</c> says of each pair that is met, in their order
    /// (<see cref="CastHit.CompareTo"/>). Where the start is in a solid, the first one is the way out of that, and
    /// takes the place of what overlaps.</param>
    /// <param name="maxFraction">See <see cref="Cast"/>.</param>
    /// <param name="options">See <see cref="Cast"/>.</param>
    /// <returns>False when the input is invalid.</returns>
    public static bool CastAll(
        in AnyShape a, in RigidPose poseA, Vector3 translationA, in AnyShape b, in RigidPose poseB,
        Vector3 translationB, ConcaveScratch scratch, List<CastHit> hits, float maxFraction = 1,
        in CastOptions options = default)
    {
        if (hits is null) return false;
        hits.Clear();
        CastHit first = Cast(a, poseA, translationA, b, poseB, translationB, scratch, maxFraction, options);
        if (first.Status == CastStatus.InvalidInput) return false;
        if (!first.Result.MayHit) return true;
        if (!AreConvex(a, b))
        {
            var motionA = new RigidMotion(poseA, translationA);
            var motionB = new RigidMotion(poseB, translationB);
            CastMotion(scratch, new PartMotion(MotionKind.Cast, motionA, motionB, maxFraction, 0, options), hits);
        }

        InPlaceSort.Sort(hits);
        bool isSolid = a.Insides.Length + b.Insides.Length > 0;
        bool replaces = isSolid && first.Result.Fraction == 0 && !options.PassesShallow;
        if (!replaces && hits.Count > 0) return true;
        int kept = 0;
        while (kept < hits.Count && hits[kept].Status == CastStatus.OverlappingAtStart) kept++;
        hits.RemoveRange(0, kept);
        hits.Insert(0, first);
        return true;
    }

    /// <summary>The hit of a motion that begins in a solid, or enters one, while no parts overlap at the
    /// start.</summary>
    private static bool TryFindInside(
        ConcaveScratch scratch, in PartMotion motion, in CastResult found, out CastHit inside)
    {
        PartPairSearch.Run(scratch, 0);
        bool isTouching = scratch.Search.PartA >= 0;
        inside = default;
        if (!isTouching)
        {
            if (!Containment.TryFind(scratch, out PairDistance start)) return false;
            inside = new CastHit(
                new CastResult(CastStatus.OverlappingAtStart, 0, start.Result.PointA, Vector3.Zero, 0), start.PartA,
                start.PartB);
            return true;
        }

        // No surface is crossed between the touch and the next contact, so a piece is inside all along, or never. A
        // piece with edges in a surface may be on both sides of it.
        if (!found.IsHit && found.Status != CastStatus.Miss) return false;
        PartPairSearch touch = scratch.Search;
        Double3 moved = motion.Way * (0.5 * found.Fraction);
        bool isInside = Containment.IsAnyInside(scratch, moved);
        bool wasInside = (isInside && Containment.IsAnyInside(scratch, default))
            || Containment.IsAnyTouchingInside(scratch, default, out PairDistance met, out Double3 outward);
        if (!wasInside && moved != default && Containment.IsAnyTouchingInside(scratch, moved, out met, out outward))
            isInside = true;
        else
            (met, outward) = (new PairDistance(default, touch.PartA, touch.PartB), default);
        if (!isInside && !wasInside) return false;
        CastStatus status = wasInside ? CastStatus.OverlappingAtStart : CastStatus.Hit;
        Vector3 normal = wasInside ? Vector3.Zero : Facing(
            outward != default
                ? (Vector3)outward
                : PartQuery.SignedDistance(scratch.A, met.PartA, scratch.B, met.PartB).Normal,
            (Vector3)motion.Way);
        inside = new CastHit(
            new CastResult(status, 0, touch.Best.PointA, normal, 0), scratch.A.NumberOf(met.PartA),
            scratch.B.NumberOf(met.PartB));
        return true;
    }
}
