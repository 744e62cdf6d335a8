namespace Gjk.Core;

/// <summary>Asks the exact queries about a part of each side.</summary>
internal static class PartQuery
{
    public static DistanceResult Distance(PartSide a, int partA, PartSide b, int partB, float maxDistance)
    {
        if (a.Mesh is not null && b.Mesh is not null) return TriangleDistance(a, partA, b, partB, maxDistance);
        if (a.Mesh is { IsScaled: false })
            return ConvexQuery.Distance(a.Mesh.GetPlain(partA), a.Pose, b.Convex(partB), b.Pose, maxDistance);
        if (b.Mesh is { IsScaled: false })
            return ConvexQuery.Distance(a.Convex(partA), a.Pose, b.Mesh.GetPlain(partB), b.Pose, maxDistance);
        return ShapeDistance(a, partA, b, partB, maxDistance);
    }

    /// <summary>The distance of two triangles, solved as they are: neither has a margin, or needs unwrapping.</summary>
    public static unsafe DistanceResult TriangleDistance(
        PartSide a, int partA, PartSide b, int partB, float maxDistance)
    {
        a.Mesh!.GetCore(partA, out TriangleCore coreA);
        b.Mesh!.GetCore(partB, out TriangleCore coreB);
        var solver = new DistanceSolver<NoTrace>(maxDistance);
        PairQuery<TriangleCore, TriangleCore, DistanceSolver<NoTrace>, DistanceResult>.Solve(
            ref coreA, ref coreA, a.Pose, ref coreB, ref coreB, b.Pose, ref solver, out DistanceResult result);
        return result;
    }

    private static DistanceResult ShapeDistance(PartSide a, int partA, PartSide b, int partB, float maxDistance)
    {
        ConvexShape roomA = default, roomB = default;
        return ConvexQuery.Distance(a.Part(partA, ref roomA), a.Pose, b.Part(partB, ref roomB), b.Pose, maxDistance);
    }

    public static DistanceResult SignedDistance(PartSide a, int partA, PartSide b, int partB)
    {
        ConvexShape roomA = default, roomB = default;
        return ConvexQuery.SignedDistance(a.Part(partA, ref roomA), a.Pose, b.Part(partB, ref roomB), b.Pose);
    }
}
