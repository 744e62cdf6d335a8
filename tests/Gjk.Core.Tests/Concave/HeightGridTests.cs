namespace Gjk.Core.Tests.Concave;

/// <summary>Holes, bases and both axes of height fields: the triangles are the ones that were promised.</summary>
public class HeightGridTests
{
    private readonly ConcaveScratch _scratch = new();

    [Fact]
    public void TrianglesAreThoseOfTheCellsThatAreThere()
    {
        for (int seed = 0; seed < 60; seed++)
        {
            var random = new Rng((ulong)seed);
            RandomField field = RandomField.Make(random, size: MathF.Pow(2, random.Below(41) - 20));
            TriangleMesh found = field.Build(), expected = field.Listed();
            Assert.Equal(expected.TriangleCount, found.TriangleCount);
            for (int i = 0; i < expected.TriangleCount; i++)
                Assert.Equal(Corners(expected, i), Corners(found, i));
            Assert.Equal(
                (expected.IsClosed, expected.IsOriented, expected.BorderEdgeCount, expected.ComponentCount,
                    expected.WhyNoInside, expected.DegenerateCount, expected.DuplicateCount),
                (found.IsClosed, found.IsOriented, found.BorderEdgeCount, found.ComponentCount,
                    found.WhyNoInside, found.DegenerateCount, found.DuplicateCount));
            for (int side = 0; side < 3 * expected.TriangleCount; side++)
                Assert.Equal(HeightFieldTests.SidesAt(expected, side), HeightFieldTests.SidesAt(found, side));
        }
    }

    [Fact]
    public void AnswersAreThoseOfTheListedTriangles()
    {
        for (int seed = 0; seed < 60; seed++)
        {
            var random = new Rng((ulong)(1000 + seed));
            RandomField field = RandomField.Make(random, size: 1);
            Vector3 scale = random.OneIn(3) ? random.Factors(0.5, 2) : Vector3.One;
            TriangleMesh found = field.Build().Scaled(scale), expected = field.Listed().Scaled(scale);
            for (int i = 0; i < 6; i++)
            {
                AnyShape other = ConcaveShapes.Any(random);
                RigidPose at = ConcaveShapes.Pose(random, 1.5), pose = ConcaveShapes.Pose(random, 0.5);
                Assert.Equal(
                    ConcaveAnswers.Of(_scratch, AnyShape.Surface(expected), pose, other, at),
                    ConcaveAnswers.Of(_scratch, AnyShape.Surface(found), pose, other, at));
            }
        }
    }

    /// <summary>A part leads to its cell and back, and its corners are those of the cell.</summary>
    [Fact]
    public void APartTellsItsCell()
    {
        for (int seed = 0; seed < 60; seed++)
        {
            var random = new Rng((ulong)(2000 + seed));
            RandomField made = RandomField.Make(random, size: 1);
            TriangleMesh mesh = made.Build();
            HeightField field = mesh.HeightField!;
            Assert.Equal(
                (made.Columns, made.Rows, made.Spacing, made.IsZUp, made.Base),
                (field.Columns, field.Rows, field.Spacing, field.IsZUp, field.BaseHeight));
            Assert.Equal((made.Columns - 1) * (made.Rows - 1), field.CellCount);
            for (int row = 0; row < field.Rows; row++)
                for (int column = 0; column < field.Columns; column++)
                    Assert.Equal(made.Heights[row * made.Columns + column], field.GetHeight(column, row));
            var seen = new HashSet<int>();
            for (int i = 0; i < mesh.TriangleCount; i++)
            {
                int cell = field.CellOf(i), column = cell % (field.Columns - 1), row = cell / (field.Columns - 1);
                Assert.Equal(cell, field.CellOf(i ^ 1));
                Assert.False(made.IsHole[cell]);
                mesh.GetTriangle(i, out int a, out int b, out int c);
                foreach (int vertex in (int[])[a, b, c])
                {
                    int top = vertex % (field.Columns * field.Rows);
                    Assert.InRange(top % field.Columns, column, column + 1);
                    Assert.InRange(top / field.Columns, row, row + 1);
                }

                if (!seen.Add(cell)) continue;
                Assert.Equal(i, field.TriangleOf(cell));
                Assert.Contains(row * field.Columns + column, (int[])[a, b, c]);
            }

            for (int cell = 0; cell < field.CellCount; cell++)
                Assert.Equal(made.IsHole[cell], field.TriangleOf(cell) < 0);
        }
    }

    /// <summary>Below the surface and above the base is inside, in a cell that is no hole.</summary>
    [Fact]
    public void ASolidFieldHoldsWhatIsBelowItsSurface()
    {
        int inside = 0, outside = 0;
        for (int seed = 0; seed < 80; seed++)
        {
            var random = new Rng((ulong)(3000 + seed));
            float size = MathF.Pow(2, random.Below(41) - 20);
            RandomField field = RandomField.Make(random, size, hasBase: true);
            TriangleMesh mesh = field.Build();
            Assert.Null(mesh.WhyNoInside);
            AnyShape solid = AnyShape.Solid(mesh);
            for (int i = 0; i < 20; i++)
            {
                float x = random.Float(-0.2f, 1.2f) * field.Spacing.X * (field.Columns - 1);
                float z = random.Float(-0.2f, 1.2f) * field.Spacing.Y * (field.Rows - 1);
                float height = random.Float(-1.2f, 1.2f) * size;
                Vector3 point = field.IsZUp ? new(x, z, height) : new(x, height, z);
                double ground = field.GroundAt(x, z);
                double near = Math.Min(Math.Abs(height - ground), Math.Abs(height - field.Base!.Value));
                if (near < 1e-5 * size) continue;
                bool expected = height < ground && height > field.Base;
                if (expected) inside++;
                else outside++;
                string name = $"seed {seed}, {point}";
                Assert.True(expected == ConcaveQuery.Contains(solid, RigidPose.Identity, point, _scratch), name);
                PairDistance signed = ConcaveQuery.SignedDistance(solid, RigidPose.Identity, point, _scratch);
                Assert.True(expected ? signed.Distance < 0 : signed.Distance > 0, name);
                PairDistance least = ConcaveQuery.Distance(
                    AnyShape.Surface(field.Listed()), RigidPose.Identity, point, _scratch);
                Assert.True(Math.Abs(signed.Distance) == least.Distance, name);
            }

            MassProperties mass = mesh.GetMassProperties();
            Assert.Equal(1, mass.Mass / field.Volume(), 1e-5);
        }

        Assert.True(inside > 150 && outside > 300, $"{inside} inside, {outside} outside");
    }

    [Fact]
    public void NoHolesAndNoBaseAreRefusedWithAReason()
    {
        float[] six = [0, 0, 0, 1, 1, 1];
        ArgumentException refused = Assert.Throws<ArgumentException>(
            () => TriangleMesh.FromHeights(six, 3, Vector2.One, [true]));
        Assert.Equal("isHole", refused.ParamName);
        refused = Assert.Throws<ArgumentException>(
            () => TriangleMesh.FromHeights(six, 3, Vector2.One, [true, true]));
        Assert.Equal("isHole", refused.ParamName);
        Assert.Contains("All cells are holes", refused.Message);
        foreach (float low in new[] { 0, 0.5f, 2, float.NaN, float.NegativeInfinity })
        {
            refused = Assert.Throws<ArgumentOutOfRangeException>(
                () => TriangleMesh.FromHeights(six, 3, Vector2.One, baseHeight: low));
            Assert.Equal("baseHeight", refused.ParamName);
        }

        HeightField field = TriangleMesh.FromHeights(six, 3, Vector2.One, [false, true]).HeightField!;
        Assert.Equal((0, -1), (field.TriangleOf(0), field.TriangleOf(1)));
        Assert.Throws<ArgumentOutOfRangeException>("cell", () => field.TriangleOf(2));
        Assert.Throws<ArgumentOutOfRangeException>("cell", () => field.TriangleOf(-1));
        Assert.Throws<ArgumentOutOfRangeException>("triangle", () => field.CellOf(2));
        Assert.Throws<ArgumentOutOfRangeException>("column", () => field.GetHeight(3, 0));
        Assert.Throws<ArgumentOutOfRangeException>("row", () => field.GetHeight(0, -1));
        Assert.Null(new TriangleMesh([default, Vector3.UnitX, Vector3.UnitY], [0, 1, 2]).HeightField);
    }

    private static Vector3[] Corners(TriangleMesh mesh, int triangle)
    {
        mesh.GetTriangle(triangle, out int a, out int b, out int c);
        return [mesh.GetVertex(a), mesh.GetVertex(b), mesh.GetVertex(c)];
    }
}
