namespace Gjk.Core.Tests;

/// <summary>Clouds on which building a hull took quadratic time: minutes for 100,000 points. The work is counted
/// (HullCostTests says in what); the corners are checked, too, as a fast wrong hull is no use.</summary>
public class SlowHullTests
{
    /// <summary>Work per point and log2 n, as in HullCostTests.</summary>
    private const double MostWork = 64;

    private const int Count = 40000;

    [Fact]
    public void ALogSpiralIsBuiltInTime() => BuildsQuickly(HostileClouds.LogSpiral(Count), Count);

    [Fact]
    public void AShrinkingMomentCurveIsBuiltInTime() =>
        BuildsQuickly(HostileClouds.ShrinkingMomentCurve(Count), Count - 20);

    [Fact]
    public void ADeepFacetIsBuiltInTime() => BuildsQuickly(HostileClouds.DeepFacets(Count), Count / 2);

    [Fact]
    public void AnApexOfHighDegreeIsBuiltInTime()
    {
        // The float circle is rounded, and not all of its points are corners.
        HullMesh mesh = BuildsQuickly(HostileClouds.Cone(Count), 20000);
        int apex = mesh.Corners.Length - 1;
        Assert.Equal(Count - 1, mesh.Corners[apex]);
        Assert.InRange(mesh.Triangles.Count(corner => corner == apex), mesh.Corners.Length / 2, mesh.Corners.Length);
    }

    [Fact]
    public void PointsWhoseHashesCollide()
    {
        Vector3[] cloud = HostileClouds.Colliding(Count);
        Vector3[] twice = [.. cloud, .. cloud.Reverse(), .. cloud];
        var distinct = new DistinctPoints(twice);
        Assert.True(distinct.Points.SequenceEqual(cloud), "the points changed, or their order");
        Assert.Equal(Enumerable.Range(0, Count), distinct.Sources);

        // Quadratic would be the square of the count, more than 10^9.
        Assert.InRange(distinct.Comparisons, 16L * twice.Length, 3L * twice.Length * 17);
    }

    [Fact]
    public void CollidingPointsWithNegativeZerosAreBuiltInTime()
    {
        Vector3[] cloud = HostileClouds.Colliding(1000);
        Vector3[] twice = [.. cloud.Select(p => new Vector3(p.X, p.Y, -0f)), .. cloud];
        var distinct = new DistinctPoints(twice);
        Assert.Equal(Enumerable.Range(0, 1000), distinct.Sources);
        Assert.All(distinct.Points, p => Assert.False(float.IsNegative(p.Z)));
    }

    private static HullMesh BuildsQuickly(Vector3[] cloud, int leastCorners)
    {
        Vector3[] points = new DistinctPoints(cloud).Points;
        HullMesh mesh = ConvexHullBuilder.Build(points, QuickHull.MostWork, out long work);
        double limit = MostWork * points.Length * Math.Log2(points.Length);
        Assert.True(work > 0 && work <= limit, $"{work} tests for {points.Length} points, the limit is {limit}");
        Assert.InRange(mesh.Corners.Length, leastCorners, points.Length);

        // Every triangle bounds the cloud; a sample, as all against all would be quadratic.
        var random = new Rng(1);
        for (int i = 0; i < 10; i++)
        {
            int t = 3 * random.Below(mesh.Triangles.Length / 3);
            Vector3 a = points[mesh.Corners[mesh.Triangles[t]]], b = points[mesh.Corners[mesh.Triangles[t + 1]]];
            HullCheck.NoneAbove(a, b, points[mesh.Corners[mesh.Triangles[t + 2]]], points, $"triangle {t / 3}");
        }

        return mesh;
    }
}
