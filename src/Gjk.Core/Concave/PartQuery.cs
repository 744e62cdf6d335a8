namespace Gjk.Core;

/// <summary>Asks the exact queries about a part of each side.</summary>
internal static class PartQuery
{
    public static DistanceResult Distance(PartSide a, int partA, PartSide b, int partB, float maxDistance)
    {
        if (a.Mesh is not null && b.Mesh is not null) return OfTriangles(a, partA, b, partB, maxDistance);
        if (a.Mesh is { IsScaled: false })
            return ConvexQuery.Distance(a.Mesh.GetPlain(partA), a.Pose, b.Convex(partB), b.Pose, maxDistance);
        if (b.Mesh is { IsScaled: false })
            return ConvexQuery.Distance(a.Convex(partA), a.Pose, b.Mesh.GetPlain(partB), b.Pose, maxDistance);
        return OfShapes(a, partA, b, partB, maxDistance);
    }

    private static DistanceResult OfTriangles(PartSide a, int partA, PartSide b, int partB, float maxDistance)
    {
        a.Mesh!.GetCore(partA, out TriangleCore triangleA);
        b.Mesh!.GetCore(partB, out TriangleCore triangleB);
        return ConvexQuery.Distance(triangleA, a.Pose, triangleB, b.Pose, maxDistance);
    }

    private static DistanceResult OfShapes(PartSide a, int partA, PartSide b, int partB, float maxDistance)
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
