namespace Gjk.Core;

/// <summary>Queries on shapes of any kind: convex shapes, surfaces and solids of triangles, compounds.</summary>
/// <remarks>An answer is the least over all pairs of parts, exact and rounded to float: trees leave out only what
/// cannot matter, and <see cref="ConvexQuery"/> answers for the rest. It depends on the two shapes and poses alone. No
/// method throws or allocates, but where the caller's scratch has to grow. All are thread-safe if each thread has a
/// scratch of its own.</remarks>
public static partial class ConcaveQuery
{
    /// <summary>The distance between two shapes, with the closest points and parts, or that they overlap.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <param name="maxDistance">In world units. When the distance, rounded to float, is larger, the query ends early
    /// with <see cref="GjkStatus.BeyondMaxDistance"/>. Below 0 counts as 0; NaN gives
    /// <see cref="GjkStatus.InvalidInput"/>.</param>
    /// <returns>The least distance over all pairs of parts, which is what <c>ConvexQuery.Distance</c> says of these
    /// two. Shapes overlap where two parts share a point, touching included, or where a piece of one lies inside a
    /// solid. Of pairs that are equally near one is named, for one <paramref name="maxDistance"/> always the same, and
    /// the lower bound is that of all pairs. A <c>default</c> shape or pose gives <see cref="GjkStatus.InvalidInput"/>,
    /// and so does a scratch that is null, unless both shapes are convex.</returns>
    public static PairDistance Distance(
        in AnyShape a, in RigidPose poseA, in AnyShape b, in RigidPose poseB, ConcaveScratch scratch,
        float maxDistance = float.PositiveInfinity)
    {
        if (AreConvex(a, b))
        {
            return new PairDistance(
                ConvexQuery.Distance(AnyShape.ConvexOf(a), poseA, AnyShape.ConvexOf(b), poseB, maxDistance));
        }

        if (float.IsNaN(maxDistance) || !TrySetSides(a, poseA, b, poseB, scratch)) return Invalid;
        PartPairSearch.Run(scratch, maxDistance);
        return FinishDistance(scratch, maxDistance, isSigned: false);
    }

    /// <summary>As the other, with the parts that were nearest in the last query of the pair as a guess.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="warmStart">Kept by the caller, one per pair, in the same order of A and B; updated.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <param name="maxDistance">As of the other.</param>
    /// <returns>The status and the distance are those of the other, to the last bit, and two convex shapes take nothing
    /// from it. Of pairs of parts that are equally near it may name another.</returns>
    public static PairDistance Distance(
        in AnyShape a, in RigidPose poseA, in AnyShape b, in RigidPose poseB, ref PartWarmStart warmStart,
        ConcaveScratch scratch, float maxDistance = float.PositiveInfinity)
    {
        if (AreConvex(a, b)) return Distance(a, poseA, b, poseB, scratch, maxDistance);
        if (float.IsNaN(maxDistance) || !TrySetSides(a, poseA, b, poseB, scratch)) return Invalid;
        PartPairSearch.Run(scratch, maxDistance, warmStart.PartA, warmStart.PartB);
        if (scratch.Search.PartA >= 0) warmStart.Set(scratch.Search.PartA, scratch.Search.PartB);
        return FinishDistance(scratch, maxDistance, isSigned: false);
    }

    /// <summary>Whether two shapes share a point, touching included.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <returns>What <c>Distance</c> says; false too when the input is invalid.</returns>
    public static bool Overlaps(
        in AnyShape a, in RigidPose poseA, in AnyShape b, in RigidPose poseB, ConcaveScratch scratch) =>
        Distance(a, poseA, b, poseB, scratch, 0).IsOverlapping;

    /// <summary>Makes the answer of the nearest parts: the distance, or the signed distance.</summary>
    private static PairDistance FinishDistance(ConcaveScratch scratch, float maxDistance, bool isSigned)
    {
        PartSide a = scratch.A, b = scratch.B;
        ref PartPairSearch search = ref scratch.Search;
        bool isFound = search.PartA >= 0, isTouching = isFound && search.Best.IsOverlapping;
        DistanceResult best = isFound
            ? search.Best.WithLowerBound(Math.Min(search.Best.LowerBound, search.LowerBound))
            : DistanceResult.Beyond(Math.Min(Math.Max(maxDistance, 0), search.LowerBound), Vector3.Zero, 0);
        int partA = isFound ? a.NumberOf(search.PartA) : PartSide.NoPart;
        int partB = isFound ? b.NumberOf(search.PartB) : PartSide.NoPart;
        if (isTouching || !(a.HasInside || b.HasInside) || !Containment.TryFind(scratch, out PairDistance inside))
            return new PairDistance(best, partA, partB);
        if (!isSigned || !(a.IsPoint || b.IsPoint)) return inside;
        PartSide outer = a.IsPoint ? b : a, point = a.IsPoint ? a : b;
        if (outer.Solid is null) return inside;
        double most = DistanceBound(outer, a.IsPoint ? search.PartB : search.PartA, point.Pose.Position, best.Distance);
        return new PairDistance(best.Inside(RoundOff.Down(-most)), partA, partB);
    }

    /// <summary>An upper bound of a point's distance to a triangle, given the distance rounded to float.</summary>
    private static double DistanceBound(PartSide side, int part, Vector3 point, float distance)
    {
        ConvexShape room = default;
        ref readonly ConvexShape triangle = ref side.ShapeOf(part, ref room);
        double reach = ((Double3)point - side.Pose.Position).Length + triangle.Center.Length + triangle.BoundingRadius;
        return distance * (1 + GjkTolerances.FloatBand) + 2 * GjkTolerances.LowerBoundError * reach;
    }

    /// <summary>The distance between two shapes, negative where a point is inside a solid.</summary>
    /// <param name="a">The first shape.</param>
    /// <param name="poseA">Pose of A in the world.</param>
    /// <param name="b">The second shape.</param>
    /// <param name="poseB">Pose of B in the world.</param>
    /// <param name="scratch">Memory for the search.</param>
    /// <returns>Two convex shapes: what <c>ConvexQuery.SignedDistance</c> says. A point inside a solid: minus its
    /// distance to the surface, with the nearest point of that and the way out as normal, as there. Else what
    /// <c>Distance</c> says: no single number is the depth of shapes that are not convex, so theirs is 0;
    /// <c>FindDepths</c> has those of the pairs of parts.</returns>
    public static PairDistance SignedDistance(
        in AnyShape a, in RigidPose poseA, in AnyShape b, in RigidPose poseB, ConcaveScratch scratch)
    {
        if (AreConvex(a, b))
        {
            return new PairDistance(
                ConvexQuery.SignedDistance(AnyShape.ConvexOf(a), poseA, AnyShape.ConvexOf(b), poseB));
        }

        if (!TrySetSides(a, poseA, b, poseB, scratch)) return Invalid;
        PartPairSearch.Run(scratch, float.PositiveInfinity);
        return FinishDistance(scratch, float.PositiveInfinity, isSigned: true);
    }

    private static PairDistance Invalid => new(DistanceResult.Invalid(GjkStatus.InvalidInput, 0));

    private static bool AreConvex(in AnyShape a, in AnyShape b) =>
        a.Kind == AnyShapeKind.Convex && b.Kind == AnyShapeKind.Convex;

    private static bool TrySetSides(
        in AnyShape a, in RigidPose poseA, in AnyShape b, in RigidPose poseB, ConcaveScratch scratch) =>
        scratch is not null && scratch.A.TrySet(a, poseA) && scratch.B.TrySet(b, poseB);
}
