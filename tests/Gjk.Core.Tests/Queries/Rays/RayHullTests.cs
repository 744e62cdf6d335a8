namespace Gjk.Core.Tests.Queries.Rays;

/// <summary>The planes that rays clip hulls by, and the clipping with and without wide registers.</summary>
public class RayHullTests
{
    [Fact]
    public void EveryPlaneSupportsItsHullAndEveryCornerIsOnOne()
    {
        int withPlanes = 0;
        for (int i = 0; i < Budget.Count(200); i++)
        {
            ConvexHull hull = Generators.Shape(new Rng((ulong)i), i % 2 == 0 ? "made" : "hull").Shape.Hull!;
            if (hull.Planes is not { } planes) continue;
            withPlanes++;
            double tolerance = 1e-14 * hull.BoundingRadius;
            for (int v = 0; v < hull.VertexCount; v++)
            {
                Double3 corner = (Double3)hull.GetVertex(v) - hull.Center;
                double highest = Enumerable.Range(0, planes.Blocks.Length / 4).Max(k => Height(planes, k, corner));
                Assert.True(Math.Abs(highest) <= tolerance, $"seed {i}, corner {v}: {highest:R} above");
            }
        }

        Assert.True(withPlanes > 100, $"only {withPlanes} hulls have planes");
    }

    /// <summary>Two triangles of a cube's side are one plane; 6 planes fill two blocks.</summary>
    [Fact]
    public void TrianglesInOnePlaneShareIt()
    {
        var prism = new ConvexHull([.. TestShape.Corners(Vector3.One), new(0, 0, 3)]);
        Assert.Equal(12 * 4, prism.Planes!.Blocks.Length);
        Assert.Null(new ConvexHull([.. TestShape.Corners(new(1, 0, 1))]).Planes);
        Vector3[] dense = [.. Clouds.InBox(new Rng(1), 3000, Vector3.One).Select(Vector3.Normalize)];
        Assert.Null(new ConvexHull(dense).Planes);
    }

    /// <summary>Planes that rounding has moved tell where a plate ends to 1e-9 of its size, if it is thick
    /// enough.</summary>
    [Theory]
    [InlineData(1e-6, false)]
    [InlineData(4e-6, true)]
    public void AThinPlateHasNoPlanes(double halfThickness, bool hasPlanes)
    {
        var half = new Vector3(0.6f, (float)halfThickness, 0.8f);
        var plate = new ConvexHull([.. TestShape.Corners(half), new(0, 0, -0.9f)]);
        Assert.Equal(hasPlanes, plate.Planes is not null);
    }

    private static double Height(HullPlanes planes, int plane, in Double3 corner)
    {
        double[] b = planes.Blocks;
        int at = plane / 4 * HullPlanes.BlockDoubles + plane % 4;
        return b[at] * corner.X + b[at + 4] * corner.Y + b[at + 8] * corner.Z - b[at + 12];
    }
}
