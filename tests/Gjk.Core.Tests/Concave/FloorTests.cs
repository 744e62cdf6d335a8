using System.Diagnostics;
namespace Gjk.Core.Tests.Concave;

/// <summary>A flat floor pushes straight up, however it is made.</summary>
public class FloorTests
{
    private const float Reach = 0.02f;
    private readonly ConcaveScratch _scratch = new();
    private readonly List<PairContacts> _contacts = [];

    [Theory]
    [InlineData("plain")]
    [InlineData("doubled")]
    [InlineData("two-sided")]
    [InlineData("slivers of 1e-7")]
    [InlineData("slivers of 1e-6")]
    [InlineData("filled T-junctions")]
    [InlineData("turned filled T-junctions")]
    [InlineData("T-junctions")]
    [InlineData("turned T-junctions")]
    [InlineData("bricks")]
    [InlineData("tiles")]
    [InlineData("tiles with steps of 1e-6")]
    [InlineData("joined boxes")]
    public void AFlatFloorPushesStraightUp(string name)
    {
        AnyShape floor = Floors.Named(name);
        var random = new Rng(3);
        for (int i = 0; i < 300; i++)
        {
            AnyShape body = Body(i);
            Quaternion yaw = Quaternion.CreateFromAxisAngle(Vector3.UnitY, i % 2 == 0 ? 0 : random.Float(0, 6));
            var over = new Vector3(
                i % 3 == 0 ? 1.5f : random.Float(0.7, 2.3), 0, i % 4 == 0 ? 1.5f : random.Float(0.7, 2.3));
            RigidPose at = SeamBodies.Placed(body, over, yaw, -0.001f - i / 7 % 3 * 0.004f);
            Assert.True(ConcaveQuery.FindContacts(floor, RigidPose.Identity, body, at, Reach, _scratch, _contacts));
            Assert.True(_contacts.Exists(one => one.Result.Distance < 0), $"{i}: contact lost");
            foreach (PairContacts one in _contacts)
                Assert.True(one.Manifold.Normal.Y > 0.9999f, $"{i}: {one}");
        }
    }

    /// <summary>A corner on another triangle's edge joins what meets there, however the mesh is scaled; once its
    /// vertices have moved off the edge it does no more.</summary>
    [Fact]
    public void ACornerOnAnEdgeJoinsWhileItIsThere()
    {
        Vector3[] points = [new(-1, 0, -1), new(-1, 0, 0), new(-1, 0, 1), new(0, 0, -1), new(0, 0, 0), new(0, 0, 1),
            new(1, 0, -1), new(1, 0, 1)];
        int[] indices = [0, 1, 3, 3, 1, 4, 1, 2, 4, 4, 2, 5, 3, 5, 6, 6, 5, 7];
        var mesh = new TriangleMesh(points, indices);
        Assert.Equal((6, 10, 1), (mesh.TriangleCount, mesh.BorderEdgeCount, mesh.ComponentCount));
        Assert.True(IsFlatUnder(mesh));
        Assert.True(IsFlatUnder(mesh.Scaled(new Vector3(1, 3, 2))));
        Assert.True(IsFlatUnder(mesh.WithVertices([.. points.Select(p => p + Vector3.UnitX * 0.01f)])));
        points[4].X = -0.05f;
        Assert.False(IsFlatUnder(mesh.WithVertices(points)));
    }

    /// <summary>A heap of triangles in one plane is built in time that is in proportion to them.</summary>
    [Fact]
    public void AHeapOfTrianglesIsBuiltInTime()
    {
        const int Count = 20_000;
        var points = new Vector3[3 * Count];
        for (int i = 0; i < points.Length; i++)
        {
            (float sin, float cos) = MathF.SinCos(i / 3 * 0.0003f + i % 3 * 2.1f);
            points[i] = new Vector3(cos, 0, sin);
        }

        var clock = Stopwatch.StartNew();
        Assert.Equal(Count, new TriangleMesh(points, [.. Enumerable.Range(0, points.Length)]).TriangleCount);
        Assert.InRange(clock.Elapsed.TotalSeconds, 0, 3);
    }

    /// <summary>Triangles a million units from their own origin, with edges of a few steps of float: what counts as on
    /// an edge is as long as the edges are.</summary>
    [Fact]
    public void FarTrianglesAreBuiltInTime()
    {
        const int Cells = 200;
        var points = new List<Vector3>();
        for (int i = 0; i < Cells * Cells; i++)
        {
            float x = 1e6f + i / Cells * 64, z = 1e6f + i % Cells * 64;
            points.AddRange([new(x, 0, z), new(x, 0, z + 0.25f), new(x + 0.25f, 0, z)]);
        }

        var clock = Stopwatch.StartNew();
        var mesh = new TriangleMesh(points, [.. Enumerable.Range(0, points.Count)]);
        Assert.InRange(clock.Elapsed.TotalSeconds, 0, 3);
        Assert.True(mesh.BorderEdgeCount > Cells * Cells);
    }

    private bool IsFlatUnder(TriangleMesh mesh)
    {
        Quaternion lying = Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 2);
        AnyShape wheel = AnyShape.Of(ConvexShape.Cylinder(0.5f, 0.1f));
        for (int i = 0; i < 60; i++)
        {
            var at = new RigidPose(lying, new Vector3(-0.3f + 0.01f * i, 0.45f, 0));
            ConcaveQuery.FindContacts(
                AnyShape.Surface(mesh), RigidPose.Identity, wheel, at, Reach / 2, _scratch, _contacts);
            if (_contacts.Exists(one => one.Manifold.Normal.Y < 0.9999f)) return false;
        }

        return true;
    }

    /// <summary>A fin that stands on a floor is a third triangle at a seam: from the side it pushes sideways, and over
    /// its end as well, which a floor below does not change.</summary>
    [Fact]
    public void AnEdgeOfThreeTrianglesStays()
    {
        Vector3[] points = [new(-2, 0, -2), new(-2, 0, 2), new(0, 0, 2), new(0, 0, -2), new(2, 0, 2), new(2, 0, -2),
            new(0, -1, -2), new(0, -1, 2)];
        AnyShape roof = AnyShape.Surface(new TriangleMesh(
            [.. points.Select(p => p - new Vector3(0, 0.5f * Math.Abs(p.X), 0))],
            [0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5, 6, 7, 2, 6, 2, 3]));
        AnyShape ball = SeamBodies.Named("ball");
        var at = new RigidPose(new Vector3(0.001f, 0.295f, 0));
        ConcaveQuery.FindContacts(roof, RigidPose.Identity, ball, at, Reach, _scratch, _contacts);
        Assert.True(_contacts.Exists(one => one.Manifold.Normal.Y > 0.999f), string.Join("; ", _contacts));
    }

    /// <summary>A column of cells that is as good as a line: what touches only the short sides of its triangles touches
    /// no end of the floor.</summary>
    [Theory]
    [InlineData(1e-8f)]
    [InlineData(1e-7f)]
    [InlineData(1e-6f)]
    public void AColumnOfSliversHasNoEnds(float width)
    {
        float[] across = [-2, -1, 0, width, 1, 2];
        Vector3[] points = [.. across.SelectMany(x => Enumerable.Range(-2, 5).Select(z => new Vector3(x, 0, z)))];
        var indices = new List<int>();
        for (int p = 0; p < 25; p++)
            if (p % 5 != 4) indices.AddRange([p, p + 1, p + 5, p + 1, p + 6, p + 5]);
        AnyShape floor = AnyShape.Surface(new TriangleMesh(points, indices));
        AnyShape[] bodies =
        [
            AnyShape.Of(ConvexShape.Box(new Vector3(0.2f)).Rounded(0.1f)),
            AnyShape.Solid(Solids.Box(new Vector3(-0.3f), new Vector3(0.3f))),
        ];
        var random = new Rng(5);
        for (int i = 0; i < 1200; i++)
        {
            float x = i % 4 < 2 ? random.Float(-0.5, 0.5) : (i % 4 - 2.5f) * 0.6f + random.Float(-1e-4, 1e-4);
            float z = i % 3 == 0 ? random.Float(-1, 1) : 0.7f + random.Float(-0.01, 0.01);
            var at = new RigidPose(new Vector3(x, 0.3f - random.Of(1e-5f, 1e-3f, 9e-3f), z));
            ConcaveQuery.FindContacts(floor, RigidPose.Identity, bodies[i % 2], at, Reach / 2, _scratch, _contacts);
            Assert.NotEmpty(_contacts);
            Assert.All(_contacts, one => Assert.True(one.Manifold.Normal.Y > 0.999f, $"{i}: {one}"));
        }
    }

    /// <summary>Each triangle of a fan without area is joined to all others; looked through without a bound, each would
    /// double the work.</summary>
    [Fact]
    public void AFanOfTrianglesWithoutAreaEnds()
    {
        var points = new Vector3[60];
        var indices = new List<int>();
        for (int i = 0; i < points.Length; i++) points[i] = new Vector3(i / 60f, 0, 0);
        for (int i = 1; i < points.Length; i++)
            for (int k = i + 1; k < points.Length; k += 7) indices.AddRange([0, i, k]);
        points[^1] = new Vector3(0.5f, 0, 1);
        AnyShape fan = AnyShape.Surface(new TriangleMesh(points, [.. indices, 0, 58, 59])), box = Body(1);
        var at = new RigidPose(new Vector3(0.5f, 0.1f, 0.2f));
        Assert.True(ConcaveQuery.FindContacts(fan, RigidPose.Identity, box, at, Reach, _scratch, _contacts));
        Assert.NotEmpty(_contacts);
    }

    private static AnyShape Body(int i) => AnyShape.Of((i % 6) switch
    {
        0 => ConvexShape.Sphere(0.25f),
        1 => ConvexShape.Box(new Vector3(0.2f, 0.15f, 0.3f)),
        2 => ConvexShape.Cylinder(0.2f, 0.15f),
        4 => ConvexShape.Cylinder(0.25f, 0.05f).Placed(
            new RigidPose(Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 2), Vector3.Zero)),
        3 => ConvexShape.Capsule(0.1f, 0.3f).Placed(
            new RigidPose(Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 2), Vector3.Zero)),
        _ => ConvexShape.Box(new Vector3(0.05f, 0.15f, 0.05f)),
    });
}
