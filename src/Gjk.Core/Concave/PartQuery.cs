namespace Gjk.Core;

/// <summary>Asks the exact queries about a part of each side.</summary>
internal static class PartQuery
{
    public static DistanceResult Distance(PartSide a, int partA, PartSide b, int partB, float maxDistance)
    {
        if (a.Mesh is not null && b.Mesh is not null)
        {
            a.Mesh.GetCore(partA, out TriangleCore triangleA);
            b.Mesh.GetCore(partB, out TriangleCore triangleB);
            return ConvexQuery.Distance(triangleA, a.Pose, triangleB, b.Pose, maxDistance);
        }

        ConvexShape roomA = default, roomB = default;
        if (a.Mesh is { IsScaled: false })
        {
            TriangleShape triangle = a.Mesh.GetPlain(partA);
            return ConvexQuery.Distance(triangle, a.Pose, b.Part(partB, ref roomB), b.Pose, maxDistance);
        }

        if (b.Mesh is { IsScaled: false })
        {
            TriangleShape triangle = b.Mesh.GetPlain(partB);
            return ConvexQuery.Distance(a.Part(partA, ref roomA), a.Pose, triangle, b.Pose, maxDistance);
        }

        return ConvexQuery.Distance(a.Part(partA, ref roomA), a.Pose, b.Part(partB, ref roomB), b.Pose, maxDistance);
    }

    public static DistanceResult SignedDistance(PartSide a, int partA, PartSide b, int partB)
    {
        ConvexShape roomA = default, roomB = default;
        return ConvexQuery.SignedDistance(a.Part(partA, ref roomA), a.Pose, b.Part(partB, ref roomB), b.Pose);
    }
}
