namespace Gjk.Core.Tests;

/// <summary>The order in which points are added changes the time, not the hull.</summary>
public class HullOrderTests
{
    private const int Small = 150, Medium = 3000;

    public static TheoryData<string> Families => [.. HostileClouds.Names];

    [Theory]
    [MemberData(nameof(Families))]
    public void RandomOrderGivesTheSameCorners(string family)
    {
        Vector3[] cloud = new DistinctPoints(HostileClouds.Create(family, Medium)).Points;
        HullMesh expected = ConvexHullBuilder.Build(cloud, int.MaxValue, out _);
        HullMesh shuffled = ConvexHullBuilder.Build(cloud, 0, out _);
        Assert.Equal(expected.Corners, shuffled.Corners);
        Assert.Equal(expected.Triangles.Length, shuffled.Triangles.Length);
    }

    [Theory]
    [MemberData(nameof(Families))]
    public void RandomOrderGivesTheHull(string family)
    {
        for (int seed = 0; seed < 5; seed++)
        {
            Vector3[] inOrder = new DistinctPoints(HostileClouds.Create(family, Small + seed)).Points;
            Vector3[] cloud = Copies.Shuffled(new Rng((ulong)seed), inOrder);
            IsHull(ConvexHullBuilder.Build(cloud, 0, out _), cloud, $"{family}, seed {seed}, random order");
            string label = $"{family}, seed {seed}, furthest first";
            IsHull(ConvexHullBuilder.Build(cloud, int.MaxValue, out _), cloud, label);
        }
    }

    [Theory]
    [MemberData(nameof(Families))]
    public void BuildingIsRepeatable(string family)
    {
        Vector3[] cloud = new DistinctPoints(HostileClouds.Create(family, Medium)).Points;
        foreach (int mostWork in new[] { 0, QuickHull.MostWork })
        {
            HullMesh first = ConvexHullBuilder.Build(cloud, mostWork, out long work);
            HullMesh second = ConvexHullBuilder.Build(cloud, mostWork, out long again);
            Assert.Equal((work, first.Dimension), (again, second.Dimension));
            Assert.Equal(first.Corners, second.Corners);
            Assert.Equal(first.Triangles, second.Triangles);
        }
    }

    [Fact]
    public void AShuffledOrderHoldsEveryPointOnce()
    {
        int[] order = ShuffledOrder.Of(HullClouds.Sphere(3, 1000));
        Assert.Equal(Enumerable.Range(0, 1000), order.Order());

        // Neither kept nor reversed: a random order leaves about one point in its place, and half of the pairs ascend.
        Assert.InRange(Enumerable.Range(0, 1000).Count(i => order[i] == i), 0, 10);
        Assert.InRange(Enumerable.Range(1, 999).Count(i => order[i] > order[i - 1]), 430, 570);
    }

    [Fact]
    public void OneBitChangesTheWholeOrder()
    {
        Vector3[] cloud = HullClouds.Sphere(3, 1000);
        int[] order = ShuffledOrder.Of(cloud);
        Assert.Equal(order, ShuffledOrder.Of((Vector3[])cloud.Clone()));
        cloud[^1].Z = MathF.BitIncrement(cloud[^1].Z);
        int[] other = ShuffledOrder.Of(cloud);
        Assert.InRange(Enumerable.Range(0, 1000).Count(i => order[i] == other[i]), 0, 10);
    }

    /// <summary>A closed surface with every point on or below every triangle, and no corner left out.</summary>
    private static void IsHull(HullMesh mesh, Vector3[] cloud, string label)
    {
        Assert.True(mesh.Dimension == HullOracle.Dimension(cloud), $"{label}: dimension {mesh.Dimension}");
        if (mesh.Dimension < 3) return;
        var edges = new HashSet<(int, int)>();
        for (int t = 0; t < mesh.Triangles.Length; t += 3)
        {
            int a = mesh.Triangles[t], b = mesh.Triangles[t + 1], c = mesh.Triangles[t + 2];
            bool isNew = edges.Add((a, b)) && edges.Add((b, c)) && edges.Add((c, a));
            Assert.True(isNew, $"{label}: triangle {t / 3} repeats an edge");
            HullCheck.NoneAbove(cloud[mesh.Corners[a]], cloud[mesh.Corners[b]], cloud[mesh.Corners[c]], cloud, label);
        }

        Assert.All(edges, e => Assert.True(edges.Contains((e.Item2, e.Item1)), $"{label}: edge {e} is open"));
        int euler = mesh.Corners.Length - edges.Count / 2 + mesh.Triangles.Length / 3;
        Assert.True(euler == 2, $"{label}: Euler's number is {euler}");
    }
}
