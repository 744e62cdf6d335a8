namespace Gjk.Core.Tests;

public class ConvexHullTests
{
    [Fact]
    public void OnePointIsAHull()
    {
        Vector3[] cloud = [new Vector3(1, -2, 3), new Vector3(1, -2, 3)];
        var hull = new ConvexHull(cloud);
        HullCheck.All(hull, cloud, "one point");
        Assert.Equal((0, 1, 0, 0), (hull.Dimension, hull.VertexCount, hull.TriangleCount, hull.NeighborCount(0)));
        Assert.Equal(new Double3(1, -2, 3), hull.Center);
        Assert.Equal(0, hull.BoundingRadius);
    }

    [Fact]
    public void NegativeZeroIsZero()
    {
        var hull = new ConvexHull([new Vector3(-0f, 0, -0f), new Vector3(0, -0f, 0), new Vector3(1, -0f, 0)]);
        Assert.Equal(2, hull.VertexCount);
        HullVertices v = hull.Vertices;
        for (int i = 0; i < v.X.Length; i++)
        {
            Assert.False(
                float.IsNegative(v.X[i]) || float.IsNegative(v.Y[i]) || float.IsNegative(v.Z[i]),
                $"slot {i} holds -0");
        }
    }

    [Fact]
    public void PointsOnALineAreASegment()
    {
        Vector3[] cloud = [new(0, 0, 0), new(2, 4, -6), new(-1, -2, 3), new(2, 4, -6), new(1, 2, -3)];
        var hull = new ConvexHull(cloud);
        HullCheck.All(hull, cloud, "line");
        Assert.Equal([1, 2], new[] { hull.SourceIndex(0), hull.SourceIndex(1) });
        Assert.Equal((1, 0), (hull.GetNeighbor(0, 0), hull.GetNeighbor(1, 0)));
    }

    [Fact]
    public void ATriangleHasTwoSides()
    {
        Vector3[] cloud = [new(0, 0, 5), new(3, 0, 5), new(0, 3, 5), new(1, 1, 5), new(1.5f, 1.5f, 5)];
        var hull = new ConvexHull(cloud);
        HullCheck.All(hull, cloud, "triangle");
        Assert.Equal((2, 3, 2), (hull.Dimension, hull.VertexCount, hull.TriangleCount));
    }

    [Fact]
    public void ACubeOf24VerticesHasEight()
    {
        Vector3[] cloud = Enumerable.Repeat(HullClouds.Grid(2), 3).SelectMany(p => p).ToArray();
        var hull = new ConvexHull(cloud);
        HullCheck.All(hull, cloud, "cube");
        Assert.Equal((3, 8, 12), (hull.Dimension, hull.VertexCount, hull.TriangleCount));
        Assert.Equal(new Double3(0.5, 0.5, 0.5), hull.Center);
    }

    [Theory]
    [InlineData(3, 1f)]
    [InlineData(7, 0.1f)]
    [InlineData(20, 1e-45f)]
    public void AGridHasEightCorners(int side, float step)
    {
        Vector3[] cloud = HullClouds.Grid(side, step);
        var hull = new ConvexHull(cloud);
        HullCheck.All(hull, cloud, $"grid {side} step {step}");
        Assert.Equal((8, 12), (hull.VertexCount, hull.TriangleCount));
    }

    [Theory]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(5)]
    public void SmallIntegersOfEveryCount(int side)
    {
        int[] seenDimensions = new int[4];
        for (int seed = 0; seed < 600; seed++)
        {
            int count = 1 + seed % 24;
            Vector3[] cloud = HullClouds.SmallIntegers(seed, count, side);
            var hull = new ConvexHull(cloud);
            HullCheck.All(hull, cloud, $"integers below {side}, {count} points, seed {seed}");
            seenDimensions[hull.Dimension]++;
        }

        Assert.All(seenDimensions, n => Assert.True(n > 0, "a dimension never came up"));
    }

    [Fact]
    public void FlatCloudsInAnyPlaneAreHulled()
    {
        for (int seed = 0; seed < 60; seed++)
        {
            var rng = new Rng((ulong)seed);
            Vector3 u = HullClouds.SmallIntegers(seed, 1, 9)[0] - new Vector3(4);
            Vector3 v = HullClouds.SmallIntegers(seed + 1000, 1, 9)[0] - new Vector3(4);
            var cloud = new Vector3[3 + seed % 20];
            for (int i = 0; i < cloud.Length; i++)
                cloud[i] = (rng.Below(11) - 5) * u + (rng.Below(11) - 5) * v + new Vector3(100, 7, -3);
            HullCheck.All(new ConvexHull(cloud), cloud, $"flat, seed {seed}");
        }
    }

    [Theory]
    [InlineData(1f)]
    [InlineData(1e-30f)]
    [InlineData(1e30f)]
    [InlineData(1e-42f)]
    [InlineData(1e38f)]
    public void BallsOfAnySizeAreHulled(float radius)
    {
        for (int seed = 0; seed < 5; seed++)
        {
            Vector3[] cloud = HullClouds.Ball(seed, 150, radius);
            HullCheck.All(new ConvexHull(cloud), cloud, $"ball of radius {radius}, seed {seed}");
        }
    }

    [Fact]
    public void MixedMagnitudesAreHulled()
    {
        for (int seed = 0; seed < 200; seed++)
        {
            Vector3[] cloud = HullClouds.AnyFloats(seed, 4 + seed % 40);
            HullCheck.All(new ConvexHull(cloud), cloud, $"any floats, seed {seed}");
        }
    }

    [Fact]
    public void TheLargestFloatsAreHulled()
    {
        Vector3[] cloud = HullClouds.Grid(2, 2).Select(p => float.MaxValue * (p - Vector3.One)).ToArray();
        var hull = new ConvexHull(cloud);
        HullCheck.All(hull, cloud, "largest");
        Assert.Equal(8, hull.VertexCount);
    }

    [Fact]
    public void NearlyFlatCloudsAreSolids()
    {
        for (int seed = 0; seed < 10; seed++)
        {
            Vector3[] cloud = HullClouds.TurnedSquare(seed, 300);
            var hull = new ConvexHull(cloud);
            Assert.Equal(3, hull.Dimension);
            HullCheck.All(hull, cloud, $"turned square, seed {seed}");
        }
    }

    [Fact]
    public void ExactlyFlatCloudsAreNot()
    {
        Vector3[] cloud = HullClouds.ExactPlane(5, 80);
        var hull = new ConvexHull(cloud);
        Assert.Equal(2, hull.Dimension);
        HullCheck.All(hull, cloud, "plane z = x + y, seed 5");
    }

    [Fact]
    public void ABitOffALineCountsAmongRounding()
    {
        // Double finds crosses that are not zero among points of the line, all larger than those of the points off it.
        for (int seed = 0; seed < 20; seed++)
        {
            Vector3 farEnd = -1294001f / (1 << 20) * new Vector3(1, 3, 5);
            Vector3[] line = [farEnd, .. HullClouds.WideLine(seed, 40)];
            Vector3[] flat = [.. line, default, new Vector3(0, 0, 1e-35f)];
            Vector3[] solid = [.. flat, new Vector3(0, 1e-38f, 0)];
            HullCheck.All(new ConvexHull(line), line, $"line, seed {seed}");
            HullCheck.All(new ConvexHull(flat), flat, $"line and a point off it, seed {seed}");
            HullCheck.All(new ConvexHull(solid), solid, $"line and two points off it, seed {seed}");
            Assert.Equal(2, new ConvexHull(flat).Dimension);
            Assert.Equal(3, new ConvexHull(solid).Dimension);
        }
    }

    [Fact]
    public void PlanesOnWhichDoubleRounds()
    {
        for (int seed = 0; seed < 20; seed++)
        {
            Vector3[] deep = HullClouds.WidePlane(seed, 40, 44), along = HullClouds.PlaneAlongAxis(seed, 40);
            HullCheck.All(new ConvexHull(deep), deep, $"deep plane, seed {seed}");
            HullCheck.All(new ConvexHull(along), along, $"plane along an axis, seed {seed}");
        }
    }

    [Fact]
    public void CapsOfManyCoplanarPointsAreHulled()
    {
        // Two copies of a circle's corners: a prism, whose caps are facets with 64 corners.
        var cloud = new List<Vector3>();
        for (int i = 0; i < 64; i++)
        {
            double angle = i * Math.PI / 32;
            var p = new Vector3((float)Math.Cos(angle), (float)Math.Sin(angle), 0);
            cloud.AddRange([p - Vector3.UnitZ, p + Vector3.UnitZ, 0.5f * p + Vector3.UnitZ]);
        }

        var hull = new ConvexHull(cloud);
        HullCheck.All(hull, cloud.ToArray(), "prism");
        Assert.Equal((128, 252), (hull.VertexCount, hull.TriangleCount));

        // No hub: a walk over a cap would otherwise have to look at all of it in one step.
        Assert.All(Enumerable.Range(0, 128), i => Assert.InRange(hull.NeighborCount(i), 3, 16));
    }

    [Fact]
    public void ASphereOf515PointsKeepsThemAll()
    {
        Vector3[] cloud = SphereMeshes.Spiral(515, 1);
        var hull = new ConvexHull(cloud);
        HullCheck.All(hull, cloud, "spiral 515");
        Assert.Equal((515, 1026), (hull.VertexCount, hull.TriangleCount));
    }

    [Fact]
    public void ADenseSpiralIsHulled()
    {
        Vector3[] cloud = SphereMeshes.Spiral(4096, 0.37);
        var hull = new ConvexHull(cloud);
        HullCheck.All(hull, cloud, "spiral 4096");
        Assert.Equal(4096, hull.VertexCount);
    }

    [Fact]
    public void TheCenterOfACloudFarAwayIsItsOwn()
    {
        var offset = new Vector3(1 << 23, -(1 << 23), 0);
        Vector3[] cloud = HullClouds.Grid(2).Select(p => p + offset).ToArray();
        var hull = new ConvexHull(cloud);
        Assert.Equal(new Double3((1 << 23) + 0.5, -(1 << 23) + 0.5, 0.5), hull.Center);
        Assert.InRange(hull.BoundingRadius, Math.Sqrt(0.75), Math.Sqrt(0.75) * (1 + 1e-14));
    }
}
