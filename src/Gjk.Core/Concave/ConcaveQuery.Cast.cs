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
    /// <param name="options">Which contacts are passed, of each pair of parts; by default none.</param>
    /// <returns>The least fraction over all pairs of parts, with the result that <c>ConvexQuery.Cast</c> has for them;
    /// of equal fractions one that overlaps at the start, then the least numbers. A piece that begins inside a solid is
    /// OverlappingAtStart; one that touches its surface and moves into it is a hit at 0. Invalid input, or a scratch
    /// that is null, gives <see cref="CastStatus.InvalidInput"/>.</returns>
    public static PartCast Cast(
        in AnyShape a, in RigidPose poseA, Vector3 translationA, in AnyShape b, in RigidPose poseB,
        Vector3 translationB, ConcaveScratch scratch, float maxFraction = 1, in CastOptions options = default)
    {
        if (AreConvex(a, b))
        {
            return new PartCast(
                ConvexQuery.Cast(
                    AnyShape.ConvexOf(a), poseA, translationA, AnyShape.ConvexOf(b), poseB, translationB, maxFraction,
                    options),
                PartSide.NoPart, PartSide.NoPart);
        }

        bool isValid = Guard.IsFinite(translationA) && Guard.IsFinite(translationB);
        if (!isValid || !TryBegin(a, poseA, b, poseB, scratch)) return InvalidCast;
        var motionA = new RigidMotion(poseA, translationA);
        var motionB = new RigidMotion(poseB, translationB);
        return Move(scratch, PartMotion.Cast, motionA, motionB, maxFraction, 0, options);
    }

    /// <summary>When two shapes that move and turn at constant rates first come within a tolerance.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="motionA">How it moves over the fractions from 0 to 1.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="motionB">How it moves.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <param name="tolerance">The largest distance of a hit, in world units; 0 or less: at most 1e-5 of the parts'
    /// sizes.</param>
    /// <param name="maxFraction">See <see cref="Cast"/>.</param>
    /// <param name="options">See <see cref="Cast"/>.</param>
    /// <returns>The least fraction over all pairs of parts, with the result that <c>ConvexQuery.TimeOfImpact</c> has
    /// for them; else as <see cref="Cast"/>.</returns>
    public static PartCast TimeOfImpact(
        in AnyShape a, in RigidMotion motionA, in AnyShape b, in RigidMotion motionB, ConcaveScratch scratch,
        float tolerance = 0, float maxFraction = 1, in CastOptions options = default)
    {
        if (AreConvex(a, b))
        {
            return new PartCast(
                ConvexQuery.TimeOfImpact(
                    AnyShape.ConvexOf(a), motionA, AnyShape.ConvexOf(b), motionB, tolerance, maxFraction, options),
                PartSide.NoPart, PartSide.NoPart);
        }

        bool isValid = motionA.IsValid && motionB.IsValid && Guard.IsFinite(tolerance);
        if (!isValid || !TryBegin(a, motionA.Pose, b, motionB.Pose, scratch)) return InvalidCast;
        return Move(scratch, PartMotion.Impact, motionA, motionB, maxFraction, tolerance, options);
    }

    private static PartCast InvalidCast =>
        new(CastResult.Nothing(CastStatus.InvalidInput, float.NaN, 0), PartSide.NoPart, PartSide.NoPart);

    private static PartCast Move(
        ConcaveScratch scratch, PartMotion motion, in RigidMotion a, in RigidMotion b, float maxFraction,
        float tolerance, in CastOptions options)
    {
        if (float.IsNaN(maxFraction)) return InvalidCast;
        PartSide sideA = scratch.A, sideB = scratch.B;
        ref PartCastSearch search = ref scratch.CastSearch;
        search.Begin(scratch, motion, a, b, maxFraction, tolerance, options);
        bool isAdvanced = motion == PartMotion.Impact && search.Speed > 0 && !options.PassesShallow;
        if (isAdvanced) PartAdvancement.Run(scratch, a, b);
        else PartCastSearch.Run(scratch);
        CastResult found = search.PartA >= 0
            ? search.Cast
            : CastResult.Nothing(CastStatus.Miss, Math.Max(maxFraction, 0), 0);
        bool isAtStart = found.Status == CastStatus.OverlappingAtStart;
        bool isSolid = sideA.IsSolid || sideB.IsSolid;
        if (!isAtStart && isSolid && !options.PassesShallow && TryInside(scratch, a, b, found, out PartCast inside))
            return inside;
        return search.PartA < 0
            ? new PartCast(found, PartSide.NoPart, PartSide.NoPart)
            : new PartCast(found, sideA.NumberOf(search.PartA), sideB.NumberOf(search.PartB));
    }

    /// <summary>What an inside makes of a motion whose parts do not overlap at the start.</summary>
    private static bool TryInside(
        ConcaveScratch scratch, in RigidMotion a, in RigidMotion b, in CastResult found, out PartCast inside)
    {
        PartPairSearch.Run(scratch, 0);
        bool isTouching = scratch.Search.PartA >= 0;
        inside = default;
        if (!isTouching)
        {
            if (!Containment.TryFind(scratch, out PartDistance start)) return false;
            inside = new PartCast(
                new CastResult(CastStatus.OverlappingAtStart, 0, start.Result.PointA, Vector3.Zero, 0), start.PartA,
                start.PartB);
            return true;
        }

        // Between the touch and the next contact no surface is crossed: a piece is inside all along, or never.
        if (!found.IsHit && found.Status != CastStatus.Miss) return false;
        double middle = 0.5 * found.Fraction;
        Double3 moved = ((Double3)b.Velocity - a.Velocity) * middle;
        bool isInside = Containment.IsAnyInside(scratch, moved);
        bool wasInside = isInside && Containment.IsAnyInside(scratch, default);
        if (!isInside) return false;
        CastStatus status = wasInside ? CastStatus.OverlappingAtStart : CastStatus.Hit;
        ref PartPairSearch touch = ref scratch.Search;
        Vector3 normal = wasInside ? Vector3.Zero : Facing(
            PartQuery.SignedDistance(scratch.A, touch.PartA, scratch.B, touch.PartB).Normal,
            (Vector3)((Double3)b.Velocity - a.Velocity));
        inside = new PartCast(
            new CastResult(status, 0, touch.Best.PointA, normal, 0), scratch.A.NumberOf(touch.PartA),
            scratch.B.NumberOf(touch.PartB));
        return true;
    }
}
