namespace Gjk.Core.Tests;

/// <summary>Contract 8: in no direction does the hull reach less far than the cloud. And what must not matter does
/// not.</summary>
public class ConvexHullSupportTests
{
    private const int Directions = 10000;

    public static TheoryData<string> Families =>
        ["ball", "sphere", "box", "integers", "spiral", "turned", "tiny", "huge", "far", "any"];

    [Theory]
    [MemberData(nameof(Families))]
    public void SupportValueEqualsTheClouds(string family)
    {
        Vector3[] cloud = Cloud(family);
        var hull = new ConvexHull(cloud);
        const int Seed = 77;
        var rng = new Rng(Seed);
        for (int i = 0; i < Directions; i++)
            HullCheck.Support(hull, cloud, rng.UnitVector(), $"{family}, direction seed {Seed}, {i}");
        foreach (Vector3 axis in new[] { Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ, Vector3.One })
        {
            HullCheck.Support(hull, cloud, axis, family);
            HullCheck.Support(hull, cloud, -axis, family);
        }
    }

    [Theory]
    [MemberData(nameof(Families))]
    public void WalkingUphillReachesTheTop(string family)
    {
        var hull = new ConvexHull(Cloud(family));
        const int Seed = 78;
        var rng = new Rng(Seed);
        for (int i = 0; i < 100; i++)
        {
            Vector3 direction = rng.UnitVector();
            int at = rng.Below(hull.VertexCount);
            for (bool rises = true; rises;)
            {
                rises = false;
                for (int k = 0; k < hull.NeighborCount(at) && !rises; k++)
                {
                    int next = hull.GetNeighbor(at, k);
                    if (HullOracle.CompareAlong(direction, hull.GetVertex(next), hull.GetVertex(at)) <= 0) continue;
                    at = next;
                    rises = true;
                }
            }

            HullCheck.Support(
                new ConvexHull([hull.GetVertex(at)]), HullCheck.Corners(hull), direction,
                $"{family}, seed {Seed}, {i}");
        }
    }

    [Theory]
    [MemberData(nameof(Families))]
    public void OrderAndMirrorDoNotMatter(string family)
    {
        Vector3[] cloud = Cloud(family);
        var corners = new HashSet<Vector3>(HullCheck.Corners(new ConvexHull(cloud)));
        int triangles = new ConvexHull(cloud).TriangleCount;
        for (int seed = 0; seed < 5; seed++)
        {
            var permuted = new ConvexHull(Copies.Shuffled(new Rng((ulong)seed), cloud));
            Assert.True(corners.SetEquals(HullCheck.Corners(permuted)), $"{family}, permutation seed {seed}");

            // Facets may be cut differently when the points are numbered differently, but not into more or fewer
            // triangles.
            Assert.True(triangles == permuted.TriangleCount, $"{family}, surface, permutation seed {seed}");
        }

        Vector3[] mirrored = cloud.Select(p => p with { X = -p.X }).ToArray();
        Assert.True(
            corners.SetEquals(HullCheck.Corners(new ConvexHull(mirrored)).Select(p => p with { X = -p.X })),
            $"{family}, mirrored");
    }

    [Fact]
    public void TheSameCloudGivesTheSameTriangles()
    {
        Vector3[] cloud = Cloud("integers");
        ConvexHull first = new(cloud), second = new(cloud);
        for (int t = 0; t < first.TriangleCount; t++)
        {
            first.GetTriangle(t, out int a, out int b, out int c);
            second.GetTriangle(t, out int d, out int e, out int f);
            Assert.Equal((a, b, c), (d, e, f));
        }
    }

    internal static Vector3[] Cloud(string family) => family switch
    {
        "ball" => HullClouds.Ball(21, 2000),
        "sphere" => HullClouds.Sphere(22, 500),
        "box" => HullClouds.Box(23, 1000),
        "integers" => HullClouds.SmallIntegers(24, 400, 6),
        "spiral" => SphereMeshes.Spiral(515, 1),
        "turned" => HullClouds.TurnedSquare(25, 500),
        "tiny" => HullClouds.Ball(26, 300, 1e-42f),
        "huge" => HullClouds.Box(27, 300, 3e38f),
        "far" => HullClouds.Ball(28, 500, 1e-2f).Select(p => p + new Vector3(1e4f, 2e4f, -1e4f)).ToArray(),
        _ => HullClouds.AnyFloats(29, 200),
    };
}
