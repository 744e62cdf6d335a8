namespace Gjk.Core.Tests.Concave.Trees;

/// <summary>A mesh is the same whether one thread builds it or several.</summary>
public class PartTreeThreadTests
{
    [Theory]
    [InlineData(2)]
    [InlineData(5)]
    public void TheTreeDoesNotDependOnThreads(int threads)
    {
        using var workers = new Workers(threads);
        Rng rng = new(8);
        foreach (int columns in new[] { 3, 40, 90 })
        {
            float[] heights = [.. Enumerable.Range(0, columns * columns).Select(_ => rng.Float(0, 1))];
            AssertSame(
                TriangleMesh.FromHeights(heights, columns, Vector2.One),
                TriangleMesh.FromHeights(heights, columns, Vector2.One, workers: workers));
        }

        Vector3[] vertices = [.. Enumerable.Range(0, 4000).Select(_ => rng.Vector(-1, 1))];
        int[] indices = [.. Enumerable.Range(0, 30_000).Select(_ => rng.Below(vertices.Length))];
        AssertSame(new TriangleMesh(vertices, indices), new TriangleMesh(vertices, indices, workers));
    }

    [Fact]
    public void DisposedWorkersAreRefused()
    {
        var workers = new Workers(2);
        workers.Dispose();
        Vector3[] vertices = [default, Vector3.UnitX, Vector3.UnitY];
        int[] indices = [0, 1, 2];
        Assert.Throws<ObjectDisposedException>(() => new TriangleMesh(vertices, indices, workers));
        Assert.Throws<ObjectDisposedException>(
            () => TriangleMesh.TryCreate(vertices, indices, out _, out _, workers));
        Assert.Throws<ObjectDisposedException>(
            () => TriangleMesh.FromHeights(new float[4], 2, Vector2.One, workers: workers));
    }

    /// <summary>Triangles that repeat one another, in any order of their corners, some of which are equal.</summary>
    [Fact]
    public void RepeatedTrianglesAreCounted()
    {
        Rng rng = new(9);
        for (int round = 0; round < Budget.Count(200); round++)
        {
            int most = 2 + rng.Below(8);
            Vector3[] vertices = [.. Enumerable.Range(0, most).Select(i => new Vector3(i, i * i, 1))];
            int[] indices = [.. Enumerable.Range(0, 3 * (1 + rng.Below(60))).Select(_ => rng.Below(most))];
            var seen = new HashSet<string>();
            int repeated = 0;
            for (int i = 0; i < indices.Length; i += 3)
                if (!seen.Add(string.Join(' ', indices[i..(i + 3)].Order()))) repeated++;
            Assert.Equal(repeated, new TriangleMesh(vertices, indices).DuplicateCount);
        }
    }

    private static void AssertSame(TriangleMesh expected, TriangleMesh actual)
    {
        Assert.Equal(expected.Tree.Order, actual.Tree.Order);
        Assert.Equal(expected.Tree.Children, actual.Tree.Children);
        Assert.Equal(expected.Tree.Boxes, actual.Tree.Boxes);
        Assert.Equal(expected.Tree.Radius, actual.Tree.Radius);
    }
}
