namespace Gjk.Core.Tests.Concave;

/// <summary>What is known of a flat mesh without a look at its vertices.</summary>
public class MeshSlabTests
{
    /// <summary>No vertex is beyond the reach; across the mesh a vertex is there, to rounding.</summary>
    [Fact]
    public void NoVertexIsBeyondTheReach()
    {
        Rng rng = new(41);
        for (int round = 0; round < Budget.Count(60); round++)
        {
            float size = MathF.Pow(2, rng.Below(121) - 60);
            Vector3 scale = rng.Below(3) == 0 ? rng.Vector(0.5, 2) : Vector3.One;
            TriangleMesh mesh = Flat(rng, size, 20).Scaled(scale);
            MeshSlab slab = Assert.IsType<MeshSlab>(mesh.Slab);
            for (int i = 0; i < 20; i++)
            {
                Double3 along = slab.Normal + (Double3)rng.UnitVector() * (i == 0 ? 0 : Math.Pow(0.1, rng.Below(17)));
                double reach = slab.Reach(along), least = mesh.Reach(along, 1);
                Assert.True(reach >= least, $"round {round}: {reach:R} is less than {least:R}");
                if (i == 0) Assert.InRange(reach - least, 0, 1e-13 * mesh.Tree.Radius);
            }
        }
    }

    [Fact]
    public void ABentMeshHasNone()
    {
        Assert.Null(TriangleMesh.FromHeights([0, 0, 0, 0, 1, 0, 0, 0, 0], 3, Vector2.One).Slab);
        var mesh = TriangleMesh.FromHeights(new float[9], 3, Vector2.One);
        Assert.NotNull(mesh.Slab);
        mesh.HeightField!.SetHeights(1, 1, 1, [0.5f]);
        Assert.Null(mesh.Slab);
    }

    /// <summary>A mesh whose heights were set again has no slab, and the same answers.</summary>
    [Fact]
    public void AnswersAreThoseWithoutIt()
    {
        Rng rng = new(42);
        const int Columns = 24;
        float[] heights = new float[Columns * Columns];
        AnyShape with = AnyShape.Surface(TriangleMesh.FromHeights(heights, Columns, new Vector2(0.1f)));
        var set = TriangleMesh.FromHeights(heights, Columns, new Vector2(0.1f));
        set.HeightField!.SetHeights(0, 0, 1, [0]);
        AnyShape without = AnyShape.Surface(set);
        Assert.Null(set.Slab);
        ConcaveScratch scratch = new();
        int apart = 0;
        for (int round = 0; round < Budget.Count(300); round++)
        {
            Quaternion turn = rng.Rotation();
            Quaternion tilt = rng.Below(3) == 0
                ? Quaternion.CreateFromAxisAngle(rng.UnitVector(), MathF.Pow(0.1f, 1 + rng.Below(6)))
                : Quaternion.Identity;
            Vector3 along = rng.Vector(-2, 2), far = rng.Below(4) == 0 ? rng.Vector(-1e3, 1e3) : default;
            along.Y = MathF.Pow(0.1f, rng.Below(10)) * rng.Float(-1, 1);
            var a = new RigidPose(turn, far);
            var b = new RigidPose(Quaternion.Normalize(turn * tilt), far + Vector3.Transform(along, turn));
            float limit = rng.Below(2) == 0 ? float.PositiveInfinity : rng.Float(0, 0.1);
            Assert.Equal(
                ConcaveQuery.Distance(without, a, without, b, scratch, limit).Result.Distance,
                ConcaveQuery.Distance(with, a, with, b, scratch, limit).Result.Distance);
            bool overlaps = ConcaveQuery.Overlaps(without, a, without, b, scratch);
            Assert.Equal(overlaps, ConcaveQuery.Overlaps(with, a, with, b, scratch));
            if (!overlaps) apart++;
        }

        Assert.InRange(apart, 50, Budget.Count(300) - 10);
    }

    /// <summary>Plates that are a millionth of their size apart are told apart without a question about their
    /// parts.</summary>
    [Fact]
    public void ParallelPlatesAreToldApartAtOnce()
    {
        AnyShape plate = AnyShape.Surface(TriangleMesh.FromHeights(new float[900], 30, new Vector2(0.07f)));
        ConcaveScratch scratch = new();
        for (int i = 1; i < 60; i++)
        {
            var pose = new RigidPose(new Vector3(0.01f * i, i * 2e-6f, 0));
            Assert.False(ConcaveQuery.Overlaps(plate, RigidPose.Identity, plate, pose, scratch));
            Assert.Equal(0, scratch.Search.QueryCount);
            float distance = ConcaveQuery.Distance(plate, RigidPose.Identity, plate, pose, scratch).Distance;
            Assert.Equal(pose.Position.Y, distance);
            Assert.InRange(scratch.Search.QueryCount, 1, 60);
        }
    }

    /// <summary>A grid in a plane that is turned, which rounding makes not quite flat.</summary>
    private static TriangleMesh Flat(Rng rng, float size, int cells)
    {
        // In double: Vector3.Transform rounds as if its vectors had the length 1.
        var turn = new RotationD(rng.Rotation());
        Double3 middle = size * rng.Vector(-3, 3);
        var vertices = new List<Vector3>();
        var indices = new List<int>();
        for (int i = 0; i <= cells; i++)
            for (int j = 0; j <= cells; j++)
                vertices.Add((Vector3)(middle + turn.Rotate(new Vector3(i, 0, j)) * (size / cells)));
        for (int i = 0; i < cells; i++)
        {
            for (int j = 0; j < cells; j++)
            {
                int at = i * (cells + 1) + j, next = at + cells + 1;
                indices.AddRange([at, at + 1, next, next, at + 1, next + 1]);
            }
        }

        return new TriangleMesh(vertices, indices);
    }
}
