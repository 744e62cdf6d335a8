namespace Gjk.Core;

/// <summary>Measures one part of each side by the exact queries.</summary>
internal static class PartQuery
{
    public static DistanceResult Distance(PartSide a, int partA, PartSide b, int partB, float maxDistance)
    {
        if (a.Mesh is not null && b.Mesh is not null) return TriangleDistance(a, partA, b, partB, maxDistance);
        if (a.Mesh is { IsScaled: false })
            return ConvexQuery.Distance(a.Mesh.GetPlain(partA), a.Pose, b.ConvexPart(partB), b.Pose, maxDistance);
        if (b.Mesh is { IsScaled: false })
            return ConvexQuery.Distance(a.ConvexPart(partA), a.Pose, b.Mesh.GetPlain(partB), b.Pose, maxDistance);
        return ShapeDistance(a, partA, b, partB, maxDistance);
    }

    /// <summary>The distance of two triangles, passed to the solver directly: they have no margin and need no
    /// unwrapping.</summary>
    public static unsafe DistanceResult TriangleDistance(
        PartSide a, int partA, PartSide b, int partB, float maxDistance)
    {
        a.Mesh!.GetCore(partA, out TriangleCore coreA);
        b.Mesh!.GetCore(partB, out TriangleCore coreB);
#if NET
        UnsafeRef.SkipInit(out PairMemory memory);
#else
        byte* room = stackalloc byte[sizeof(PairMemory)];
        ref PairMemory memory = ref *(PairMemory*)room;
#endif
        var solver = new DistanceSolver<NoTrace>(maxDistance);
        PairQuery<TriangleCore, TriangleCore, DistanceSolver<NoTrace>, DistanceResult>.Solve(
            ref coreA, ref coreA, a.Pose, ref coreB, ref coreB, b.Pose, ref memory, ref solver,
            out DistanceResult result);
        return result;
    }

    /// <summary>Where a ray meets a part.</summary>
    /// <param name="side">The side.</param>
    /// <param name="part">The part's number.</param>
    /// <param name="ray">The ray, as the motion of a point from B's pose.</param>
    /// <param name="sides">Which sides are met.</param>
    /// <param name="most">How far it reaches.</param>
    public static RayCastResult RayCast(
        PartSide side, int part, in PartMotion ray, RaySides sides, float most = float.PositiveInfinity)
    {
        ConvexShape room = default;
        RayCastResult met = ConvexQuery.RayCast(
            side.ShapeOf(part, ref room), ray.A.Pose, ray.B.Pose.Position, ray.B.Velocity, most, ray.Options, sides);
        TriangleBack.ApplySides(side, part, ray.B.Velocity, sides, ref met);
        return met;
    }

    private static DistanceResult ShapeDistance(PartSide a, int partA, PartSide b, int partB, float maxDistance)
    {
        ConvexShape roomA = default, roomB = default;
        return ConvexQuery.Distance(
            a.ShapeOf(partA, ref roomA), a.Pose, b.ShapeOf(partB, ref roomB), b.Pose, maxDistance);
    }

    public static DistanceResult SignedDistance(PartSide a, int partA, PartSide b, int partB)
    {
        ConvexShape roomA = default, roomB = default;
        return ConvexQuery.SignedDistance(a.ShapeOf(partA, ref roomA), a.Pose, b.ShapeOf(partB, ref roomB), b.Pose);
    }
}
