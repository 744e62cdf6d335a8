namespace Gjk.Core;

public static partial class ConcaveQuery
{
    /// <summary>Where a ray first meets a shape.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="origin">Where the ray begins, in the world.</param>
    /// <param name="direction">Any finite vector but zero; its length does not matter.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <param name="maxDistance">World units: how far the ray reaches, +infinity for all the way; less than 0 counts as
    /// 0, which asks whether the origin is inside.</param>
    /// <param name="options">Which contacts are passed, of each part; by default none.</param>
    /// <param name="sides">Which sides are met, of each part; by default both, and solids are solid.</param>
    /// <returns>The least distance over all parts, with the result that <c>ConvexQuery.RayCast</c> has for the part; of
    /// equal distances one that overlaps at the start, then one whose side no other part covers, then the least number.
    /// From inside a solid: OverlappingAtStart, unless shallow contacts are passed; from on its surface into it: a hit
    /// at 0. Invalid input, or a scratch that is null, gives <see cref="CastStatus.InvalidInput"/>. From inside a
    /// hollow solid: the first triangle met; of a hollow compound each part is hollow. From inside several solids and
    /// parts of a compound: out of the deepest.</returns>
    public static RayHit RayCast(
        in AnyShape shape, in RigidPose pose, Vector3 origin, Vector3 direction, ConcaveScratch scratch,
        float maxDistance = float.PositiveInfinity, in CastOptions options = default, RaySides sides = RaySides.Both)
    {
        if (!TrySetRay(shape, pose, origin, direction, scratch, maxDistance, options, sides))
            return new RayHit(RayCastResult.Nothing(CastStatus.InvalidInput, float.NaN, 0));
        FindFirst(scratch);
        RayHit found = ToRayHit(scratch, maxDistance);
        bool isUnit = scratch.A.IsUnit, isStart = found.Status == CastStatus.OverlappingAtStart;
        if (scratch.A.HasInside && !options.PassesShallow && !(isUnit && isStart) && BeginsInOrOn(scratch))
        {
            if (!isUnit)
            {
                foreach (CompoundShape unit in shape.Compound!.Units)
                {
                    RayHit one = RayCast(
                        AnyShape.Of(unit), pose, origin, direction, scratch, maxDistance, options, sides);
                    if (one.IsHit) one = new RayHit(one.Result, unit.Numbers[one.Part]);
                    if (one.IsHit && (!found.IsHit || one.CompareTo(found) < 0)) found = one;
                }

                return found;
            }

            PartPairSearch.Run(scratch, float.PositiveInfinity);
            PairDistance start = FinishDistance(scratch, float.PositiveInfinity, isSigned: true);
            if (start.Distance < 0 && !sides.Has(RaySides.Hollow))
            {
                return new RayHit(
                    new RayCastResult(
                        CastStatus.OverlappingAtStart, 0, origin, start.Result.Normal, 0, -start.Distance),
                    start.PartA);
            }

            // Both sides count when the next surface on the way is looked for.
            if (start.Distance == 0 && sides.Has(RaySides.FrontOnly)
                && TrySetRay(shape, pose, origin, direction, scratch, maxDistance, options, RaySides.Both))
            {
                PartCastSearch.Run(scratch);
            }

            if (start.Distance == 0 && Enters(scratch, direction, scratch.CastSearch, maxDistance))
            {
                Vector3 outward = PartQuery.SignedDistance(scratch.A, start.PartA, scratch.B, 0).Normal;
                return new RayHit(
                    new RayCastResult(CastStatus.Hit, 0, origin, Facing(outward, direction), 0), start.PartA);
            }
        }

        return found;
    }

    /// <summary>Finds what a ray meets first. Where it meets several parts at once, as on a seam between tiles, a side
    /// that another part covers is none that it meets.</summary>
    private static void FindFirst(ConcaveScratch scratch)
    {
        ref PartCastSearch search = ref scratch.CastSearch;
        PartCastSearch.Run(scratch);
        int first = search.PartA;
        SimultaneousHits.KeepSeparating(scratch, search.Motion);
        if (search.PartA != first) search.Ray = PartQuery.RayCast(scratch.A, search.PartA, search.Motion, search.Sides);
    }

    private static RayHit ToRayHit(ConcaveScratch scratch, float maxDistance)
    {
        ref readonly PartCastSearch search = ref scratch.CastSearch;
        return search.PartA >= 0
            ? new RayHit(search.Ray, scratch.A.NumberOf(search.PartA))
            : new RayHit(RayCastResult.Nothing(CastStatus.Miss, Math.Max(maxDistance, 0), 0));
    }

    /// <summary>Whether a ray begins in a solid or on it. Most do not, and need no distance.</summary>
    private static bool BeginsInOrOn(ConcaveScratch scratch)
    {
        PartPairSearch.Run(scratch, 0);
        return scratch.Search.PartA >= 0 || Containment.TryFind(scratch, out _);
    }

    /// <summary>Whether a ray that begins on a solid's surface goes into it. No surface is crossed before the next hit,
    /// so the middle of the way there decides.</summary>
    private static bool Enters(ConcaveScratch scratch, Vector3 direction, in PartCastSearch search, float maxDistance)
    {
        double way = search.PartA >= 0 ? search.Ray.Distance : maxDistance;
        if (!(way > 0) || double.IsInfinity(way)) return false;
        Double3 along = direction;
        return Containment.IsAnyInside(scratch, along * (0.5 * way / along.Length));
    }

    /// <summary>A triangle's normal, turned against a motion.</summary>
    private static Vector3 Facing(Vector3 normal, Vector3 motion) => Double3.Dot(normal, motion) > 0 ? -normal : normal;

    /// <summary>Where a ray meets each part of a shape.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="origin">Where the ray begins, in the world.</param>
    /// <param name="direction">Any finite vector but zero; its length does not matter.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <param name="hits">Cleared, then one for each part that is met: what <c>ConvexQuery.RayCast</c> says of it, by
    /// distance and then by number.</param>
    /// <param name="maxDistance">As of the first hit.</param>
    /// <param name="options">As of the first hit.</param>
    /// <param name="sides">As of the first hit. Of a solid each triangle is asked, hollow or not.</param>
    /// <returns>False when the input is invalid.</returns>
    public static bool RayCastAll(
        in AnyShape shape, in RigidPose pose, Vector3 origin, Vector3 direction, ConcaveScratch scratch,
        List<RayHit> hits, float maxDistance = float.PositiveInfinity, in CastOptions options = default,
        RaySides sides = RaySides.Both)
    {
        if (hits is null) return false;
        hits.Clear();
        if (!TrySetRay(shape, pose, origin, direction, scratch, maxDistance, options, sides)) return false;
        scratch.CastSearch.CollectedRays = hits;
        PartCastSearch.Run(scratch);
        scratch.CastSearch.CollectedRays = null;
        InPlaceSort.Sort(hits);
        return true;
    }

    /// <summary>Where a ray enters and leaves a solid or a convex shape, in turn. Of one that begins inside, the first
    /// hit is the way out.</summary>
    /// <param name="solid">A solid or a compound of solids alone, or a convex shape, of which there is one way in and
    /// one way out at most.</param>
    /// <param name="pose">Its pose in the world.</param>
    /// <param name="origin">Where the ray begins, in the world.</param>
    /// <param name="direction">Any finite vector but zero; its length does not matter.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <param name="hits">Cleared, then one for each crossing, by distance. Its normal looks out of the solid: against
    /// the ray where that enters, along it where that leaves.</param>
    /// <param name="maxDistance">As of the first hit; crossings further away are left out.</param>
    /// <returns>False when the input is invalid, or the shape is a surface or another compound.</returns>
    /// <remarks>A crossing is a place where the winding number changes between 0 and another: it is computed without
    /// rounding, between each two distances at which triangles are met that differ as floats. So an edge or corner is
    /// crossed once, one that the ray only touches is not crossed, and the number of crossings of a whole ray is odd if
    /// the solid contains the origin, but of a half-space, which has no far end. A face along which the ray runs
    /// counts as inside or as outside, and is crossed twice or not. An origin on the surface is where the ray goes from
    /// it, and what is thinner than a step of the distance's float is passed. Each distance asks once for the winding
    /// number, which takes as long as <c>Contains</c>.</remarks>
    public static bool RayCrossings(
        in AnyShape solid, in RigidPose pose, Vector3 origin, Vector3 direction, ConcaveScratch scratch,
        List<RayHit> hits, float maxDistance = float.PositiveInfinity)
    {
        if (!RayCastAll(solid, pose, origin, direction, scratch, hits)) return false;
        if (scratch.A.IsConvex) return FindConvexCrossings(solid.Convex, pose, origin, direction, hits, maxDistance);
        bool isSolid = scratch.A.IsAllSolid && !float.IsNaN(maxDistance), isIn = false;
        int kept = 0;
        for (int i = -1, next; isSolid && i < hits.Count; i = next)
        {
            // The hits at one distance. The first round takes those at the origin, which only say whether the ray
            // begins inside.
            float distance = i < 0 ? 0 : hits[i].Distance;
            for (next = i + 1; next < hits.Count && hits[next].Distance == distance;) next++;
            bool staysIn = next < hits.Count && Containment.HoldsOnRay(
                scratch, scratch.A, origin, direction, 0.5 * ((double)distance + hits[next].Distance));
            if (i >= 0 && staysIn != isIn && distance <= maxDistance) hits[kept++] = hits[i].Crossing(isIn);
            isIn = staysIn;
        }

        hits.RemoveRange(kept, hits.Count - kept);
        return isSolid;
    }

    /// <summary>Replaces the hits with a convex shape by where the ray enters and leaves it.</summary>
    private static bool FindConvexCrossings(
        in ConvexShape shape, in RigidPose pose, Vector3 origin, Vector3 direction, List<RayHit> hits,
        float maxDistance)
    {
        RayHit first = hits.Count > 0 ? hits[0] : default;
        RayCastResult exit = first.IsHit ? ConvexQuery.RayExit(shape, pose, origin, direction) : default;
        bool isIn = first.Status == CastStatus.OverlappingAtStart, isOut = exit.Status == CastStatus.Hit;
        bool isCrossed = isIn || !isOut || exit.Distance > first.Distance;
        if (isIn || !isCrossed || first.Distance > maxDistance) hits.Clear();
        if (isCrossed && isOut && exit.Distance <= maxDistance) hits.Add(new RayHit(exit));
        return !float.IsNaN(maxDistance);
    }

    private static bool TrySetRay(
        in AnyShape shape, in RigidPose pose, Vector3 origin, Vector3 direction, ConcaveScratch scratch,
        float maxDistance, in CastOptions options, RaySides sides)
    {
        bool isRay = Guard.IsFinite(origin) && Guard.IsFinite(direction) && direction != Vector3.Zero
            && !float.IsNaN(maxDistance);
        if (!isRay || !TrySetSides(shape, pose, Point, new RigidPose(origin), scratch)) return false;
        scratch.CastSearch.Reset(scratch, new PartMotion(
            MotionKind.Ray, new RigidMotion(pose, Vector3.Zero), new RigidMotion(new RigidPose(origin), direction),
            maxDistance, 0, options));
        scratch.CastSearch.Sides = sides;
        return true;
    }
}
