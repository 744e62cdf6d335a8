using System.Diagnostics;
using Xunit.Abstractions;

namespace Gjk.Core.Tests;

/// <summary>Large clouds. They run when the environment variable GJK_LONG is 1 and pass at once when it is
/// not.</summary>
public class ConvexHullLongTests
{
    private const int Directions = 100, Triangles = 100;

    private readonly ITestOutputHelper _output;

    public ConvexHullLongTests(ITestOutputHelper output) => _output = output;

    private static bool IsShortRun => Environment.GetEnvironmentVariable("GJK_LONG") != "1";

    [Theory]
    [InlineData("ball", 1000000)]
    [InlineData("box", 1000000)]
    [InlineData("sphere", 100000)]
    [InlineData("sphere", 1000000)]
    [InlineData("spiral", 100000)]
    [InlineData("turned", 100000)]
    [InlineData("turned", 1000000)]
    [InlineData("plane", 100000)]
    [InlineData("circle", 100000)]
    [InlineData("cylinder", 100000)]
    [InlineData("parabola", 100000)]
    [InlineData("any", 100000)]
    [InlineData("grid", 1000000)]
    [InlineData("tilted", 1000000)]
    [InlineData("line", 1000000)]
    public void LargeCloudsAreHulled(string family, int count)
    {
        if (IsShortRun) return;
        const int Seed = 5;
        Vector3[] cloud = Cloud(family, Seed, count);
        var watch = Stopwatch.StartNew();
        var hull = new ConvexHull(cloud);
        _output.WriteLine(
            $"{family} {count}: {hull.VertexCount} corners, {hull.TriangleCount} triangles, "
            + $"{watch.Elapsed.TotalSeconds:F2} s");
        var rng = new Rng(Seed);
        for (int i = 0; i < Directions; i++)
        {
            HullCheck.Support(
                hull, cloud, rng.UnitVector(), $"{family} {count}, seed {Seed}, direction {i}");
        }
        CheckSample(hull, cloud, rng, $"{family} {count}, seed {Seed}");
    }

    [Fact]
    public void ManySmallCloudsAreHulled()
    {
        if (IsShortRun) return;
        for (int seed = 0; seed < 100000; seed++)
        {
            Vector3[] cloud = HullClouds.SmallIntegers(seed, 1 + seed % 30, 2 + seed % 5);
            HullCheck.All(new ConvexHull(cloud), cloud, $"integers, seed {seed}");
        }
    }

    [Theory]
    [MemberData(nameof(ConvexHullSupportTests.Families), MemberType = typeof(ConvexHullSupportTests))]
    public void AMillionDirectionsGetTheirSupport(string family)
    {
        if (IsShortRun) return;
        Vector3[] cloud = ConvexHullSupportTests.Cloud(family);
        var hull = new ConvexHull(cloud);
        var rng = new Rng(6);
        for (int i = 0; i < 1000000; i++)
            HullCheck.Support(hull, cloud, rng.UnitVector(), $"{family}, direction seed 6, {i}");
    }

    /// <summary>All points against some triangles.</summary>
    private static void CheckSample(ConvexHull hull, Vector3[] cloud, Rng rng, string label)
    {
        for (int i = 0; i < Triangles && hull.Dimension == 3; i++)
        {
            hull.GetTriangle(rng.Below(hull.TriangleCount), out int a, out int b, out int c);
            HullCheck.NoneAbove(hull.GetVertex(a), hull.GetVertex(b), hull.GetVertex(c), cloud, label);
        }
    }

    private static Vector3[] Cloud(string family, int seed, int count) => family switch
    {
        "ball" => HullClouds.Ball(seed, count),
        "box" => HullClouds.Box(seed, count),
        "sphere" => HullClouds.Sphere(seed, count),
        "spiral" => SphereMeshes.Spiral(count, 1),
        "turned" => HullClouds.TurnedSquare(seed, count),
        "plane" => HullClouds.ExactPlane(seed, count),
        "circle" => HostileClouds.Disc(count),
        "cylinder" => HostileClouds.Prism(count),
        "parabola" => Enumerable.Range(0, count).Select(i => new Vector3(i, (float)((double)i * i), i % 7)).ToArray(),
        "any" => HullClouds.AnyFloats(seed, count),
        "grid" => HullClouds.Grid(100),

        // Shears with exact products: as coplanar as the grid, on a fine lattice.
        "tilted" =>
            HullClouds.Grid(100).Select(
                p => new Vector3(p.X + p.Y / 4096 + p.Z / 65536, p.Y + p.Z / 65536, p.Z)).ToArray(),
        _ => Enumerable.Range(0, count).Select(i => i * new Vector3(1, 2, 4)).ToArray(),
    };
}
