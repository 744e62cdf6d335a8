using Gjk.Core.Tests.Concave.Trees;

namespace Gjk.Core.Tests.Concave;

/// <summary>A field whose heights have changed answers as one that is built of them.</summary>
public class SetHeightsTests
{
    private readonly ConcaveScratch _scratch = new();

    [Fact]
    public void AChangedFieldAnswersAsANewOne()
    {
        for (int seed = 0; seed < 60; seed++)
        {
            var random = new Rng((ulong)seed);
            RandomField field = RandomField.Make(random, size: 1);
            Vector3 scale = random.OneIn(3) ? random.Factors(0.5, 2) : Vector3.One;
            TriangleMesh changed = field.Build().Scaled(scale);
            for (int round = 0; round < 4; round++)
            {
                Change(random, field, changed, size: random.OneIn(4) ? 0.9f : 0.5f);
                TriangleMesh built = field.Build().Scaled(scale);
                AnyShape one = AnyShape.Surface(changed), other = ConcaveShapes.Any(random);
                RigidPose at = ConcaveShapes.Pose(random, 1.5), pose = ConcaveShapes.Pose(random, 0.5);

                // Which of equally near pairs is named depends on the tree, and so do bounds and points.
                Assert.Equal(
                    ConcaveAnswers.Of(_scratch, AnyShape.Surface(built), pose, other, at)[1..],
                    ConcaveAnswers.Of(_scratch, one, pose, other, at)[1..]);
                if (field.Base is null) continue;
                Assert.Equal(
                    ConcaveAnswers.Of(_scratch, AnyShape.Solid(built), pose, other, at)[1..],
                    ConcaveAnswers.Of(_scratch, AnyShape.Solid(changed), pose, other, at)[1..]);
            }
        }
    }

    /// <summary>Heights that grow by far and shrink again, of fields of any size.</summary>
    [Fact]
    public void BoxesHoldTheirTrianglesAndTheDistanceIsTheLeast()
    {
        for (int seed = 0; seed < 80; seed++)
        {
            var random = new Rng((ulong)(1000 + seed));
            float size = MathF.Pow(2, random.Below(41) - 20);
            RandomField field = RandomField.Make(random, size);
            TriangleMesh mesh = field.Build();
            if (random.OneIn(3)) mesh = mesh.Scaled(random.Factors(1e-3, 1e3));
            for (int round = 0; round < 5; round++)
            {
                Change(random, field, mesh, size * (float)random.Magnitude(1e-4, field.Base is null ? 1e4 : 1));
                string name = $"seed {seed}, round {round}";
                PartTree tree = mesh.Tree;
                for (int lane = 0; lane < tree.Children.Length; lane++)
                    BoxLanesTests.AssertHolds(mesh, tree, lane, tree.Children[lane]);
                for (int i = 0; i < mesh.VertexCount; i++)
                {
                    if (!IsUsed(mesh, i)) continue;
                    Assert.True((mesh.GetScaledVertex(i) - tree.Origin).Length <= tree.Radius, name);
                }

                AnyShape surface = AnyShape.Surface(mesh), ball = AnyShape.Of(ConvexShape.Sphere(size / 10));
                var at = new RigidPose(random.Vector(2 * size));
                float least = float.PositiveInfinity;
                foreach (ConvexShape part in ConcaveShapes.Parts(surface))
                {
                    least = Math.Min(
                        least, ConvexQuery.Distance(part, RigidPose.Identity, ball.Convex, at).Distance);
                }

                Assert.True(
                    least == ConcaveQuery.Distance(surface, RigidPose.Identity, ball, at, _scratch).Distance, name);
            }
        }
    }

    /// <summary>One height of many: few boxes change, and those above them still fit well.</summary>
    [Fact]
    public void OnlyTheBoxesAroundAChangeAreFitted()
    {
        const int Columns = 150;
        var random = new Rng(7);
        float[] heights = new float[Columns * Columns];
        for (int i = 0; i < heights.Length; i++) heights[i] = MathF.Sin(i % Columns * 0.1f) * MathF.Cos(i * 1e-3f);
        TriangleMesh mesh = TriangleMesh.FromHeights(heights, Columns, Vector2.One);
        PartTree tree = mesh.Tree;
        double before = Surface(tree);
        float[] boxes = [.. tree.Boxes];
        heights[70 * Columns + 60] = 3;
        mesh.HeightField!.SetHeights(60, 70, 1, [3]);
        int changed = 0;
        for (int lane = 0; lane < tree.Children.Length; lane++)
        {
            bool isSame = true;
            for (int i = 0; i < 15; i++)
                isSame &= tree.Boxes[PartTree.At(lane) + 8 * i] == boxes[PartTree.At(lane) + 8 * i];
            if (!isSame) changed++;
        }

        Assert.InRange(changed, 3, 60);
        for (int i = 0; i < 300; i++)
        {
            int column = random.Below(Columns), row = random.Below(Columns);
            mesh.HeightField.SetHeights(column, row, 1, [heights[row * Columns + column] = random.Float(-1, 1)]);
        }

        double built = Surface(TriangleMesh.FromHeights(heights, Columns, Vector2.One).Tree);
        Assert.InRange(Surface(tree) / built, 0.9, 1.5);
        Assert.InRange(before, 1, double.MaxValue);
    }

    [Fact]
    public void NothingIsAllocated()
    {
        TriangleMesh mesh = TriangleMesh.FromHeights(new float[400], 20, Vector2.One, baseHeight: -1e9f);
        var scene = new CollisionScene();
        int id = scene.Add(AnyShape.Solid(mesh), RigidPose.Identity);
        scene.Add(ConvexShape.Sphere(0.5f), new RigidPose(new Vector3(6, 1, 6)));
        float[] hill = [1, 2, 1, 2, 3, 2], all = new float[400];
        var distances = new List<PairDistance>();
        float up = 1;
        Assert.Equal(0, Allocation.Least(() =>
        {
            mesh.HeightField!.SetHeights(5, 5, 3, hill);
            mesh.HeightField.SetHeights(0, 0, 20, all);
            hill[4] = up *= 50;
            mesh.HeightField.SetHeights(5, 5, 3, hill);
            scene.Refresh(id);
            scene.FindPairsWithin(1, distances);
        }));
        Assert.Single(distances);
    }

    [Fact]
    public void AScaledCopyKeepsItsHeights()
    {
        foreach (bool hasHole in new[] { false, true })
        {
            TriangleMesh mesh = TriangleMesh.FromHeights(new float[9], 3, Vector2.One, [false, false, hasHole, false]);
            TriangleMesh copy = mesh.Scaled(new Vector3(1, 2, 1));
            copy.HeightField!.SetHeights(1, 1, 1, [2]);
            mesh.HeightField!.SetHeights(1, 1, 1, [3]);
            Assert.Equal((2, 3), (copy.HeightField.GetHeight(1, 1), mesh.HeightField.GetHeight(1, 1)));
            var above = new RigidPose(new Vector3(1, 10, 1));
            Assert.Equal(6, Gap(copy, above));
            Assert.Equal(7, Gap(mesh, above));
        }
    }

    /// <summary>Answers that pairs at rest keep are asked anew, and a hill that leaves the box is met.</summary>
    [Fact]
    public void ASceneThatIsToldAnswersAnew()
    {
        foreach (BroadPhaseKind kind in Enum.GetValues<BroadPhaseKind>())
        {
            var scene = new CollisionScene(kind);
            TriangleMesh mesh = TriangleMesh.FromHeights(new float[100], 10, Vector2.One);
            int ground = scene.Add(AnyShape.Surface(mesh), RigidPose.Identity, new ObjectSettings(isStatic: true));
            scene.Add(ConvexShape.Sphere(0.5f), new RigidPose(new Vector3(4, 5, 4)));
            for (int i = 0; i < 3; i++) scene.Add(ConvexShape.Sphere(0.5f), new RigidPose(new Vector3(40 + i, 5, 4)));
            var distances = new List<PairDistance>();
            var contacts = new List<PairContacts>();
            for (int height = 0; height <= 5; height++)
            {
                mesh.HeightField!.SetHeights(4, 4, 1, [height]);
                scene.Refresh(ground);
                for (int again = 0; again < 2; again++)
                {
                    scene.FindPairsWithin(1, distances);
                    scene.FindContacts(0.1f, contacts);
                    List<PairDistance> met = distances.FindAll(d => d.Pair.A == ground);
                    Assert.Equal(height >= 4, met.Count == 1);
                    Assert.Equal(height == 5, contacts.Exists(c => c.Pair.A == ground));
                    if (height >= 4) Assert.Equal(height == 5 ? 0 : 0.5f, met[0].Distance);
                    Assert.True(scene.TryFindRayHit(
                        new RayQuery(new Vector3(4, 4.25f, 4), -Vector3.UnitY, 10), out RayHit hit) == (height < 5));
                    if (height < 5) Assert.Equal(4.25f - height, hit.Distance);
                }
            }

            Assert.Throws<ArgumentOutOfRangeException>("id", () => scene.Refresh(99));
        }
    }

    [Fact]
    public void NoRectangleIsRefusedAndChangesNothing()
    {
        HeightField field = TriangleMesh.FromHeights(new float[20], 5, Vector2.One, baseHeight: -1).HeightField!;
        Assert.Throws<ArgumentNullException>("heights", () => field.SetHeights(0, 0, 1, null!));
        foreach (int column in new[] { -1, 5, int.MaxValue })
            Assert.Throws<ArgumentOutOfRangeException>("column", () => field.SetHeights(column, 0, 1, [0]));
        foreach (int row in new[] { -1, 4, int.MinValue })
            Assert.Throws<ArgumentOutOfRangeException>("row", () => field.SetHeights(0, row, 1, [0]));
        foreach (int columns in new[] { -1, 0, 4, int.MaxValue })
            Assert.Throws<ArgumentOutOfRangeException>("columns", () => field.SetHeights(2, 0, columns, [1]));
        foreach (float[] heights in new float[][] { [], [1], [1, 1, 1], [1, 1, 1, 1, 1, 1] })
            Assert.Throws<ArgumentException>("heights", () => field.SetHeights(2, 2, 2, heights));
        foreach (float last in new[] { float.NaN, float.PositiveInfinity, -1, -2 })
            Assert.Throws<ArgumentException>("heights", () => field.SetHeights(2, 2, 2, [5, 5, 5, last]));
        Assert.Equal(0, field.GetHeight(2, 2));
    }

    /// <summary>Gives a rectangle of both other heights.</summary>
    private static void Change(Rng random, RandomField field, TriangleMesh mesh, float size)
    {
        int column = random.Below(field.Columns), row = random.Below(field.Rows);
        int columns = 1 + random.Below(field.Columns - column), rows = 1 + random.Below(field.Rows - row);
        float[] heights = new float[columns * rows];
        for (int i = 0; i < heights.Length; i++)
        {
            heights[i] = RandomField.RandomHeight(random, size);
            field.Heights[(row + i / columns) * field.Columns + column + i % columns] = heights[i];
        }

        mesh.HeightField!.SetHeights(column, row, columns, heights);
        Assert.Equal(heights[0], mesh.HeightField.GetHeight(column, row));
    }

    private static bool IsUsed(TriangleMesh mesh, int vertex)
    {
        for (int i = 0; i < mesh.TriangleCount; i++)
        {
            mesh.GetTriangle(i, out int a, out int b, out int c);
            if (a == vertex || b == vertex || c == vertex) return true;
        }

        return false;
    }

    private static double Surface(PartTree tree)
    {
        double sum = 0;
        for (int lane = 0; lane < tree.Children.Length; lane++)
        {
            if (tree.Children[lane] == PartTree.Empty) continue;
            Double3 half = tree.Read(PartTree.At(lane) + PartTree.Halves);
            sum += (half.X * half.Y + half.Y * half.Z + half.Z * half.X) * tree.Unit * tree.Unit;
        }

        return sum;
    }

    private float Gap(TriangleMesh mesh, in RigidPose at) => ConcaveQuery.Distance(
        AnyShape.Surface(mesh), RigidPose.Identity, AnyShape.Of(ConvexShape.Point()), at, _scratch).Distance;
}
