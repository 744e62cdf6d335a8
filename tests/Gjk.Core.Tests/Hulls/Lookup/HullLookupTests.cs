namespace Gjk.Core.Tests;

/// <summary>The look-up finds the vertex that the plain scan finds, whatever the hull and the direction; and it is as
/// far as the furthest point of the cloud. Thousands of directions per hull, 10^6 with GJK_LONG=1.</summary>
public class HullLookupTests
{
    private const int Directions = 10000, MadeHulls = 250, CloudEvery = 16;

    /// <summary>Ratio to the sum of the terms' magnitudes: two dot products of double, and a direction that was
    /// folded.</summary>
    private const double HeightError = 16.0 / (1L << 53);

    public static TheoryData<string> Families => [.. CaseFamily.Names];

    public static TheoryData<string> Large =>
        ["prism", "turned prism", "cone", "turned disc", "dome", "turned dome", "cluster", "rings", "far prism"];

    [Theory]
    [MemberData(nameof(Families))]
    public void ItIsRightOnTheHullsOfTheCases(string family)
    {
        var clouds = CaseFamily.Load(family).Cases.SelectMany(c => new[] { c.Pair.A, c.Pair.B }).Distinct()
            .Where(s => s.Vertices is not null).Select(s => Array.ConvertAll(s.Vertices!, v => (Vector3)v)).ToList();
        Assert.NotEmpty(clouds);
        int seed = 0;
        foreach (Vector3[] cloud in clouds) Check(cloud, $"{family}, shape {seed}", (ulong)seed++, Directions);
    }

    [Fact]
    public void OnMeshesAsProgramsMakeThem()
    {
        int boxes = 0, cells = 0, flats = 0, scans = 0;
        for (int seed = 0; seed < MadeHulls; seed++)
        {
            var random = new Rng((ulong)seed);
            Vector3[] cloud = seed % 3 == 0 ? MadeMeshes.Baked(random) : MadeMeshes.Any(random);
            Vector3 away = random.Vector(1) * (float)random.Magnitude(1e3, 1e7), factors = random.Factors(1e-10, 1e10);
            if (seed % 5 == 0) cloud = Array.ConvertAll(cloud, p => p + away);
            if (seed % 5 == 1) cloud = Array.ConvertAll(cloud, p => p * factors);
            if (seed % 10 == 2) cloud = Array.ConvertAll(cloud, p => p with { Z = p.X + p.Y });
            HullCells.LookupKind kind = Check(cloud, $"made mesh, seed {seed}", (ulong)seed, Directions).Cells.Kind;
            boxes += kind == HullCells.LookupKind.Box ? 1 : 0;
            cells += kind == HullCells.LookupKind.Cells ? 1 : 0;
            flats += kind == HullCells.LookupKind.Flat ? 1 : 0;
            scans += kind == HullCells.LookupKind.Scan ? 1 : 0;
        }

        string counts = $"{boxes} boxes, {cells} with cells, {flats} flat, {scans} scanned";
        Assert.True(boxes > 0 && cells > 0 && flats > 0 && scans > 0, counts);
    }

    [Theory]
    [MemberData(nameof(Large))]
    public void ItIsRightOnLargeHulls(string kind)
    {
        ConvexHull hull = Check(HostileClouds.Create(kind), kind, 77, Directions / 5);
        Assert.Equal(kind is not ("turned disc" or "cluster"), hull.Cells.Tree is not null);
        Assert.Equal(kind == "turned disc", hull.Cells.Kind == HullCells.LookupKind.Flat);
    }

    [Theory]
    [InlineData("sphere")]
    [InlineData("any")]
    [InlineData("tiny")]
    [InlineData("huge")]
    [InlineData("far")]
    [InlineData("spiral")]
    public void ItIsRightOnTheCloudsOfTheHullTests(string family) =>
        Check(ConvexHullSupportTests.Cloud(family), family, 78, Directions);

    private static ConvexHull Check(Vector3[] cloud, string label, ulong seed, int directions)
    {
        var hull = new ConvexHull(cloud);
        var next = new LookupDirections(hull, new Rng(seed));
        int count = Budget.Few(directions);
        for (int i = 0; i < count; i++)
        {
            Double3 d = next.Next();
            int id = HullSupport.Find(hull.Cells, d, out Double3 point), expected = PlainScan.Furthest(hull.Cells, d);
            if (id != expected) Assert.Fail($"{label}, direction {i} {d}: vertex {id}, the scan finds {expected}");
            hull.GetVertex(id, out Double3 vertex);
            if (point != vertex) Assert.Fail($"{label}, direction {i} {d}: {point} is not vertex {id}, {vertex}");
            if (i % CloudEvery == 0) CheckHeight(hull, cloud, d, point, $"{label}, direction {i} {d}");
        }

        return hull;
    }

    private static void CheckHeight(
        ConvexHull hull, Vector3[] cloud, in Double3 direction, in Double3 point, string label)
    {
        // Measured where doubles are normal, in the components that matter.
        Vector3 extents = hull.Bounds.Max - hull.Bounds.Min;
        double x = extents.X > 0 ? Math.Abs(direction.X) : 0, y = extents.Y > 0 ? Math.Abs(direction.Y) : 0;
        double largest = Math.Max(Math.Max(x, y), extents.Z > 0 ? Math.Abs(direction.Z) : 0);
        if (!(largest is > 1e-250 and < 1e250)) return;
        Double3 d = direction * (1 / largest), origin = hull.Vertices.Origin;
        double height = Double3.Dot(point - origin, d), most = double.NegativeInfinity, size = 0;
        foreach (Vector3 p in cloud)
        {
            Double3 q = (Double3)p - origin;
            most = Math.Max(most, Double3.Dot(q, d));
            size = Math.Max(size, Math.Abs(q.X * d.X) + Math.Abs(q.Y * d.Y) + Math.Abs(q.Z * d.Z));
        }

        if (most - height > HeightError * size)
            Assert.Fail($"{label}: {point} is {most - height} lower than the furthest point, of {size}");
    }
}
