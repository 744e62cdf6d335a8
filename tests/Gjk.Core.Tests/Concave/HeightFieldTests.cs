namespace Gjk.Core.Tests.Concave;

/// <summary>Grids of heights and moved vertices are the meshes of their triangles, to the last bit.</summary>
public class HeightFieldTests
{
    private readonly ConcaveScratch _scratch = new();

    [Fact]
    public void AGridIsTheMeshOfItsTriangles()
    {
        for (int seed = 0; seed < 20; seed++)
        {
            var random = new Rng((ulong)seed);
            int columns = 2 + random.Below(9), rows = 2 + random.Below(9);
            float[] heights = new float[columns * rows];
            for (int i = 0; i < heights.Length; i++) heights[i] = random.OneIn(3) ? 0 : random.Float(-0.5f, 0.5f);
            var spacing = new Vector2(random.Float(0.1f, 0.4f), random.Float(0.1f, 0.4f));
            TriangleMesh grid = TriangleMesh.FromHeights(heights, columns, spacing);
            TriangleMesh mesh = Listed(heights, columns, spacing);
            if (seed % 3 == 0) (grid, mesh) = (grid.Scaled(new Vector3(2, -3, 1)), mesh.Scaled(new Vector3(2, -3, 1)));
            AssertSameMesh(mesh, grid);
            for (int i = 0; i < 20; i++)
            {
                AnyShape other = ConcaveShapes.Any(random);
                RigidPose at = ConcaveShapes.Pose(random, 1.5), pose = ConcaveShapes.Pose(random, 0.5);
                Assert.Equal(
                    ConcaveAnswers.Of(_scratch, AnyShape.Surface(mesh), pose, other, at),
                    ConcaveAnswers.Of(_scratch, AnyShape.Surface(grid), pose, other, at));
            }
        }
    }

    [Fact]
    public void TrianglesOfAGridLookUp()
    {
        TriangleMesh grid = TriangleMesh.FromHeights(new float[12], 4, new Vector2(1, 2));
        Assert.Equal((12, 12), (grid.TriangleCount, grid.VertexCount));
        Assert.Equal(new Vector3(3, 0, 4), grid.GetVertex(11));
        for (int i = 0; i < grid.TriangleCount; i++)
        {
            grid.GetTriangle(i, out int a, out int b, out int c);
            Vector3 corner = grid.GetVertex(a);
            Assert.Equal(
                2 * Vector3.UnitY, Vector3.Cross(grid.GetVertex(b) - corner, grid.GetVertex(c) - corner));
        }
    }

    [Fact]
    public void NoGridIsRefusedWithAReason()
    {
        float[] four = [0, 0, 0, 0];
        Vector2 one = Vector2.One;
        Assert.Throws<ArgumentNullException>(() => TriangleMesh.FromHeights(null!, 2, one));
        foreach (int columns in new[] { -1, 0, 1, 3, 4, 5 })
            Assert.Throws<ArgumentException>(() => TriangleMesh.FromHeights(four, columns, one));
        foreach (float hole in new[] { float.NaN, float.PositiveInfinity })
        {
            Assert.Contains(
                "Height 2",
                Assert.Throws<ArgumentException>(() => TriangleMesh.FromHeights([0, 0, hole, 0], 2, one)).Message);
        }

        foreach (float spacing in new[] { 0, -1, float.NaN, float.PositiveInfinity, float.MaxValue })
        {
            Assert.Throws<ArgumentOutOfRangeException>(
                () => TriangleMesh.FromHeights(four, 2, new Vector2(1, spacing)));
        }
    }

    [Fact]
    public void MovedVerticesAreThoseOfANewMesh()
    {
        for (int seed = 0; seed < 30; seed++)
        {
            var random = new Rng((ulong)(100 + seed));
            TriangleMesh before = seed % 3 == 0 ? ConcaveShapes.Torus(9, 7)
                : seed % 3 == 1 ? ConcaveShapes.Soup(random, 40, 0.3)
                : TriangleMesh.FromHeights(new float[30], 5, new Vector2(0.2f, 0.3f));
            if (seed % 2 == 0) before = before.Scaled(random.Factors(0.5, 2));
            var points = new Vector3[before.VertexCount];
            double far = random.Magnitude(1e-3, 1);
            for (int i = 0; i < points.Length; i++) points[i] = before.GetVertex(i) * 1.5f + random.Vector(far);
            if (seed % 5 == 0) points[1] = points[0];
            TriangleMesh moved = before.WithVertices(points);
            var indices = new List<int>();
            for (int i = 0; i < before.TriangleCount; i++)
            {
                before.GetTriangle(i, out int a, out int b, out int c);
                indices.AddRange([a, b, c]);
            }

            var built = new TriangleMesh(points, indices);
            if (before.Scale != Vector3.One) built = built.Scaled(before.Scale);
            AssertSameMesh(built, moved);
            for (int i = 0; i < 20; i++)
            {
                AnyShape other = ConcaveShapes.Any(random);
                RigidPose at = ConcaveShapes.Pose(random, 1.5), pose = ConcaveShapes.Pose(random, 0.5);
                string[] expected = ConcaveAnswers.Of(_scratch, AnyShape.Surface(built), pose, other, at);
                string[] found = ConcaveAnswers.Of(_scratch, AnyShape.Surface(moved), pose, other, at);

                // Which of equally near pairs is named depends on the tree, and so do bounds and points.
                Assert.Equal(expected[1..], found[1..]);
            }
        }
    }

    [Fact]
    public void OnlyAsManyFiniteVerticesCanMove()
    {
        TriangleMesh mesh = ConcaveShapes.Torus(4, 3);
        var points = new Vector3[mesh.VertexCount];
        Assert.Throws<ArgumentNullException>(() => mesh.WithVertices(null!));
        Assert.Throws<ArgumentException>(() => mesh.WithVertices(points[1..]));
        points[3].Y = float.NaN;
        Assert.Contains("Vertex 3", Assert.Throws<ArgumentException>(() => mesh.WithVertices(points)).Message);
    }

    private static TriangleMesh Listed(float[] heights, int columns, Vector2 spacing)
    {
        var points = new List<Vector3>();
        var indices = new List<int>();
        for (int i = 0; i < heights.Length; i++)
        {
            int row = i / columns, column = i % columns;
            points.Add(new Vector3(column * spacing.X, heights[i], row * spacing.Y));
            if (column + 1 == columns || i + columns >= heights.Length) continue;
            indices.AddRange([i, i + columns, i + 1, i + 1, i + columns, i + columns + 1]);
        }

        return new TriangleMesh(points, indices);
    }

    private static void AssertSameMesh(TriangleMesh expected, TriangleMesh found)
    {
        Assert.Equal(
            (expected.TriangleCount, expected.VertexCount, expected.IsClosed, expected.IsOriented,
                expected.BorderEdgeCount, expected.DegenerateCount, expected.DuplicateCount),
            (found.TriangleCount, found.VertexCount, found.IsClosed, found.IsOriented, found.BorderEdgeCount,
                found.DegenerateCount, found.DuplicateCount));
        Assert.Equal(expected.ComponentCount, found.ComponentCount);
        Assert.Equal(expected.WhyNoInside, found.WhyNoInside);
        for (int side = 0; side < 3 * expected.TriangleCount; side++)
            Assert.Equal(SidesAt(expected, side), SidesAt(found, side));
    }

    internal static SortedSet<int> SidesAt(TriangleMesh mesh, int side)
    {
        var sides = new SortedSet<int>();
        for (CornerRing ring = mesh.SidesAt(side); ring.MoveNext();) Assert.True(sides.Add(ring.Current));
        Assert.Contains(side, sides);
        return sides;
    }
}
