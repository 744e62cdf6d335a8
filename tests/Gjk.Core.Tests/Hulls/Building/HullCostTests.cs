namespace Gjk.Core.Tests;

/// <summary>No cloud takes more than about n log n to build. Counted in tests of a point against a plane, so that a
/// slow or busy machine changes nothing.</summary>
public class HullCostTests
{
    /// <summary>Work per point and log2 n. The furthest points first may take QuickHull.MostWork and one step, the
    /// random order takes up to 30 where double often cannot tell. A quadratic order would take 260 on 10,000 points of
    /// a log spiral.</summary>
    private const double MostWork = 64;

    /// <summary>As above, for clouds that never need the random order.</summary>
    private const double MostOrdinaryWork = 9;

    /// <summary>As above, for the random order alone.</summary>
    private const double MostRandomWork = 36;

    private const int Count = 10000;

    private static bool IsShortRun => Environment.GetEnvironmentVariable("GJK_LONG") != "1";

    public static TheoryData<string> Families => [.. HostileClouds.Names];

    [Theory]
    [MemberData(nameof(Families))]
    public void WorkGrowsWithNLogN(string family)
    {
        for (int count = Count / 100; count <= Count; count *= 10)
        {
            double work = Work(HostileClouds.Create(family, count), QuickHull.MostWork, out int points);
            double perPoint = work / points / Math.Log2(points);
            Assert.True(perPoint <= MostWork, $"{family}, {count} points: {perPoint} n log n");
        }
    }

    [Theory]
    [MemberData(nameof(Families))]
    public void TheRandomOrderBoundsTheWork(string family)
    {
        double work = Work(HostileClouds.Create(family, Count), 0, out int points);
        Assert.InRange(work / points / Math.Log2(points), 0, MostRandomWork);
    }

    [Theory]
    [InlineData("ball")]
    [InlineData("sphere")]
    [InlineData("grid")]
    [InlineData("turned square")]
    [InlineData("moment curve")]
    [InlineData("helix")]
    [InlineData("sphere spiral")]
    [InlineData("cone")]
    [InlineData("prism")]
    public void OrdinaryCloudsAreDoneWithTheFurthestPointsFirst(string family)
    {
        double work = Work(HostileClouds.Create(family, Count), QuickHull.MostWork, out int points);
        Assert.InRange(work / points / Math.Log2(points), 0.1, MostOrdinaryWork);
    }

    [Fact]
    public void TheLimitIsNeeded()
    {
        // Without it the log spiral is quadratic, or the limit above would hold for any order.
        double limited = Work(HostileClouds.LogSpiral(Count), QuickHull.MostWork, out int points);
        double unlimited = Work(HostileClouds.LogSpiral(Count), int.MaxValue, out _);
        double unit = points * Math.Log2(points);
        Assert.True(limited > QuickHull.MostWork * unit, $"the limit was not reached: {limited / unit}");
        Assert.True(unlimited > 3 * MostWork * unit, $"the furthest points first took {unlimited / unit} only");
    }

    [Theory]
    [InlineData("sphere")]
    [InlineData("grid")]
    [InlineData("few points")]
    [InlineData("denormals")]
    [InlineData("any floats")]
    public void RepeatsOfOrdinaryCloudsAreFoundByTheHash(string family)
    {
        Vector3[] cloud = HostileClouds.Create(family, Count);
        Assert.InRange(new DistinctPoints(cloud).Comparisons, cloud.Length, 3 * cloud.Length);
    }

    [Theory]
    [MemberData(nameof(Families))]
    public void AHundredThousandPointsTakeLittleWork(string family)
    {
        if (IsShortRun) return;
        double work = Work(HostileClouds.Create(family, 100000), QuickHull.MostWork, out int points);
        double perPoint = work / points / Math.Log2(points);
        Assert.True(perPoint <= MostWork, $"{family}: {perPoint} n log n");
    }

    private static double Work(Vector3[] cloud, int mostWork, out int points)
    {
        Vector3[] distinct = new DistinctPoints(cloud).Points;
        points = distinct.Length;
        ConvexHullBuilder.Build(distinct, mostWork, out long work);
        return work;
    }
}
