using System.Collections;

namespace Gjk.Core.Tests;

/// <summary>What the hull refuses, and that it keeps nothing of its caller's.</summary>
public class ConvexHullArgumentTests
{
    [Fact]
    public void NullIsRefused()
    {
        Assert.Equal("points", Assert.Throws<ArgumentNullException>(() => new ConvexHull(null!)).ParamName);
        Assert.False(ConvexHull.TryCreate(null, out ConvexHull? hull, out string? reason));
        Assert.Null(hull);
        Assert.NotEmpty(reason);
    }

    [Fact]
    public void NoPointsAreRefused()
    {
        Assert.Equal("points", Assert.Throws<ArgumentException>(() => new ConvexHull([])).ParamName);
        Assert.False(ConvexHull.TryCreate([], out _, out string? reason));
        Assert.Contains("At least one point", reason);
    }

    [Fact]
    public void AListWithANegativeCountIsRefused()
    {
        var list = new NegativeList();
        foreach (Action build in new Action[]
        {
            () => _ = new ConvexHull(list), () => _ = new ConvexMesh(list), () => ConvexShape.Mesh(list),
        })
        {
            string name = Assert.Throws<ArgumentOutOfRangeException>(build).ParamName!;
            Assert.Equal("points", name);
        }

        Assert.False(ConvexHull.TryCreate(list, out ConvexHull? hull, out string? reason));
        Assert.Null(hull);
        Assert.NotEmpty(reason);
    }

    [Theory]
    [InlineData(float.NaN, 0, 0, 0)]
    [InlineData(0, float.PositiveInfinity, 0, 7)]
    [InlineData(0, 0, float.NegativeInfinity, 41)]
    public void NonFiniteIsRefusedByItsIndex(float x, float y, float z, int index)
    {
        Vector3[] cloud = HullClouds.Ball(1, 50);
        cloud[index] = new Vector3(x, y, z);
        ArgumentException refusal = Assert.Throws<ArgumentException>(() => new ConvexHull(cloud));
        Assert.Equal("points", refusal.ParamName);
        Assert.Contains($"Point {index} ", refusal.Message);
        Assert.False(ConvexHull.TryCreate(cloud, out ConvexHull? hull, out string? reason));
        Assert.Null(hull);
        Assert.Contains($"Point {index} ", reason);
    }

    [Fact]
    public void TryCreateBuildsWhatTheConstructorBuilds()
    {
        Vector3[] cloud = HullClouds.Ball(2, 100);
        Assert.True(ConvexHull.TryCreate(cloud, out ConvexHull? hull, out string? reason));
        Assert.Null(reason);
        Assert.Equal(HullCheck.Corners(new ConvexHull(cloud)), HullCheck.Corners(hull));
    }

    [Fact]
    public void TheListIsCopied()
    {
        Vector3[] cloud = HullClouds.Ball(3, 30);
        var hull = new ConvexHull(cloud);
        Vector3[] before = HullCheck.Corners(hull);
        Array.Clear(cloud);
        Assert.Equal(before, HullCheck.Corners(hull));
    }

    [Fact]
    public void IndicesOutOfRangeAreRefused()
    {
        var hull = new ConvexHull(HullClouds.Grid(2));
        foreach (int id in new[] { -1, 8 })
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => hull.GetVertex(id));
            Assert.Throws<ArgumentOutOfRangeException>(() => hull.SourceIndex(id));
            Assert.Throws<ArgumentOutOfRangeException>(() => hull.NeighborCount(id));
            Assert.Throws<ArgumentOutOfRangeException>(() => hull.GetNeighbor(id, 0));
        }

        Assert.Throws<ArgumentOutOfRangeException>(() => hull.GetNeighbor(0, -1));
        Assert.Throws<ArgumentOutOfRangeException>(() => hull.GetNeighbor(0, hull.NeighborCount(0)));
        Assert.Throws<ArgumentOutOfRangeException>(() => hull.GetTriangle(-1, out _, out _, out _));
        Assert.Throws<ArgumentOutOfRangeException>(() => hull.GetTriangle(12, out _, out _, out _));

        // The vertex count must bound the id, not the padded arrays.
        Assert.Throws<ArgumentOutOfRangeException>(() => new ConvexHull([Vector3.One]).GetVertex(1));
    }

    private sealed class NegativeList : IReadOnlyList<Vector3>
    {
        public int Count => -3;

        public Vector3 this[int index] => throw new ArgumentOutOfRangeException(nameof(index));

        public IEnumerator<Vector3> GetEnumerator() => Enumerable.Empty<Vector3>().GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
    }
}
