using Gjk.Exact.Fuzz.Concave;

namespace Gjk.Core.Tests.Concave;

/// <summary>Where rays enter and leave solids: as often as integers say, through edges and corners, along faces, from
/// 2^-20 to 2^20 in size.</summary>
public class RayCrossingTests
{
    private static readonly RigidPose Here = RigidPose.Identity;
    private readonly ConcaveScratch _scratch = new();
    private readonly List<RayHit> _hits = [], _all = [];

    [Theory]
    [InlineData("box")]
    [InlineData("gear")]
    [InlineData("ring")]
    [InlineData("rock")]
    [InlineData("hollow")]
    public void RaysAtEdgesAndCornersCrossAsOftenAsIntegersSay(string name)
    {
        int doubled = 0, inside = 0, count = 0;
        for (ulong seed = 1; seed <= (ulong)Budget.Whole(25); seed++)
        {
            var random = new Rng(seed);
            TriangleMesh unit = Make(name, (int)seed);
            float size = MathF.ScaleB(1, 20 * ((int)(seed % 3) - 1));
            TriangleMesh mesh = seed % 2 == 0 ? Solids.Scaled(unit, size) : unit.Scaled(new Vector3(size));
            RigidPose pose = seed % 4 < 2
                ? RigidPose.Identity
                : new RigidPose(random.Rotation(), random.Vector(size));
            for (int i = 0; i < 12; i++)
            {
                // Multiples of a power of two, so that a ray in the mesh's frame meets its target to the last bit.
                Vector3 target = pose.TransformPoint(Aim(mesh, random) * mesh.Scale);
                Vector3 direction = OnLattice(random.Vector(i % 3 == 0 ? 0.4 : 3)) * size, origin = target - direction;
                string message = $"{name}, seed {seed}, ray {i}";
                bool isIn = Check(mesh, pose, origin, direction, random, message);
                doubled += _all.Count > _hits.Count ? 1 : 0;
                inside += isIn ? 1 : 0;
                count++;
            }
        }

        Assert.True(doubled > count / 5, $"{doubled} of {count} rays meet two triangles at one crossing");
        Assert.InRange(inside, 1, count - 1);
    }

    [Fact]
    public void ABoxIsCrossedOnceAtItsDiagonalsEdgesAndCorners()
    {
        foreach (int power in new[] { -20, 0, 20 })
        {
            float size = MathF.ScaleB(1, power);
            TriangleMesh box = Solids.Box(new Vector3(-size), new Vector3(size));
            (Vector3 Origin, Vector3 Direction, int Crossings)[] rays =
            [
                (new(0, 0, -3), Vector3.UnitZ, 2), (new(0, 0, 0), Vector3.UnitZ, 1), (new(0, 0, 0), Vector3.One, 1),
                (new(-2), Vector3.One, 2), (new(-2, -2, 0), new(1, 1, 0), 2), (new(-2, -2, 0), new(1, 1, 0.5f), 2),
                (new(0, 2, 0), new(1, -1, 0), 0), (new(0, 0, -1), Vector3.UnitZ, 1), (new(0, -1, -1), new(0, 1, 2), 1),
                (new(0, 3, 0), new(1, -2, 1), 0), (new(0, 0, -1), -Vector3.UnitZ, 0), (new(0, 0, 3), Vector3.UnitZ, 0),
            ];
            foreach ((Vector3 origin, Vector3 direction, int crossings) in rays)
            {
                Assert.True(Ask(box, origin * size, direction));
                Assert.True(crossings == _hits.Count, $"2^{power}, {origin} along {direction}: {_hits.Count}");
            }

            foreach (Vector3 along in new Vector3[] { new(-2, 1, 0), new(-2, 1, 1), new(-2, -1, 0), new(-2, 0, 1) })
            {
                Assert.True(Ask(box, along * size, Vector3.UnitX));
                Assert.True(_hits.Count % 2 == 0, $"2^{power}, from {along}: {_hits.Count}");
            }

            Ask(box, new Vector3(-2) * size, Vector3.One);
            Assert.Equal(-1, Math.Sign(Vector3.Dot(_hits[0].Result.Normal, Vector3.One)));
            Assert.Equal(1, Math.Sign(Vector3.Dot(_hits[1].Result.Normal, Vector3.One)));
            Assert.True(Ask(box, new Vector3(0, 0, -3) * size, Vector3.UnitZ, 3 * size));
            Assert.Equal(2 * size, Assert.Single(_hits).Distance);
        }
    }

    [Fact]
    public void OthersAreRefused()
    {
        TriangleMesh box = Solids.Box(-Vector3.One, Vector3.One);
        Assert.False(Ask(box, new Vector3(0, 0, -3), default));
        Assert.False(Ask(box, new Vector3(0, 0, -3), Vector3.UnitZ, float.NaN));
        var pair = new CompoundShape([new(ConvexShape.Sphere(1), Here), new(ConvexShape.Sphere(2), Here)]);
        foreach (AnyShape shape in new[] { AnyShape.Surface(box), AnyShape.Of(pair), default })
        {
            Assert.False(ConcaveQuery.RayCrossings(
                shape, RigidPose.Identity, new Vector3(0, 0, -3), Vector3.UnitZ, _scratch, _hits));
            Assert.Empty(_hits);
        }

        Assert.False(ConcaveQuery.RayCrossings(
            AnyShape.Solid(box), RigidPose.Identity, default, Vector3.UnitZ, _scratch, null!));
    }

    /// <summary>A largest distance of 0 asks whether the origin is in the shape, along any direction.</summary>
    [Fact]
    public void ARayWithoutLengthSaysWhetherItBeginsInside()
    {
        ConvexShape ball = ConvexShape.Sphere(1), box = ConvexShape.Box(Vector3.One), cone = ConvexShape.Cone(1, 1);
        AnyShape[] shapes =
        [
            AnyShape.Of(ball), AnyShape.Of(box), AnyShape.Of(cone), AnyShape.Of(cone.Rounded(0.5f)),
            AnyShape.Of(ConvexShape.HalfSpace(new Vector3(1, 2, 3), 0.25f)), AnyShape.Solid(Solids.Named("ring", 1)),
            AnyShape.Of(new CompoundShape([new(ball, new RigidPose(Vector3.One)), new(box, RigidPose.Identity)])),
        ];
        int inside = 0;
        for (ulong seed = 1; seed <= 200; seed++)
        {
            var random = new Rng(seed);
            Vector3 origin = random.Vector(2), direction = (Vector3)random.Direction();
            var pose = new RigidPose(random.Rotation(), random.Vector(0.3));
            foreach (AnyShape shape in shapes)
            {
                RayHit hit = ConcaveQuery.RayCast(shape, pose, origin, direction, _scratch, 0);
                bool isIn = ConcaveQuery.Contains(shape, pose, origin, _scratch);
                inside += isIn ? 1 : 0;
                Assert.Equal(isIn ? CastStatus.OverlappingAtStart : CastStatus.Miss, hit.Status);
                var scene = new CollisionScene();
                scene.Add(shape, pose);
                Assert.Equal(isIn, scene.TryFindRayHit(new RayQuery(origin, direction, 0), out _));
            }
        }

        Assert.InRange(inside, 150, 1100);
    }

    private bool Ask(TriangleMesh mesh, Vector3 origin, Vector3 direction, float most = float.PositiveInfinity) =>
        ConcaveQuery.RayCrossings(
            AnyShape.Solid(mesh), RigidPose.Identity, origin, direction, _scratch, _hits, most);

    /// <summary>Holds the crossings to the exact winding number between all distances at which a triangle is
    /// met.</summary>
    private bool Check(
        TriangleMesh mesh, in RigidPose pose, Vector3 origin, Vector3 direction, Rng random, string message)
    {
        AnyShape solid = AnyShape.Solid(mesh);
        Assert.True(ConcaveQuery.RayCrossings(solid, pose, origin, direction, _scratch, _hits));
        Assert.True(ConcaveQuery.RayCastAll(solid, pose, origin, direction, _scratch, _all));
        Double3[] corners = Corners(mesh);
        bool starts = IsIn(corners, pose, origin, random), isIn = starts;
        Assert.True(starts == (_hits.Count % 2 == 1), $"{message}: {_hits.Count} crossings, inside {starts}");
        float[] met = [.. _all.Select(h => h.Distance).Distinct()];
        int crossed = 0;
        for (int i = 0; i < met.Length; i++)
        {
            double middle = i + 1 < met.Length ? 0.5 * ((double)met[i] + met[i + 1]) : 2.0 * met[i] + 1;
            Double3 at = (Double3)origin + (Double3)direction * (middle / ((Double3)direction).Length);
            bool staysIn = i + 1 < met.Length && IsIn(corners, pose, at, random);
            if (staysIn != isIn) Assert.Equal(met[i], _hits[crossed++].Distance);
            isIn = staysIn;
        }

        Assert.True(crossed == _hits.Count, message);
        for (int i = 0; i < _hits.Count; i++)
        {
            double along = Double3.Dot(_hits[i].Result.Normal, direction);
            Assert.True(starts == (i % 2 == 1) ? along <= 0 : along >= 0, $"{message}: normal {i}");
        }

        return starts;
    }

    private static bool IsIn(Double3[] corners, in RigidPose pose, in Double3 point, Rng random) =>
        ExactWinding.About(corners, pose, point, RigidPose.Identity, random) is not (null or 0);

    private static Double3[] Corners(TriangleMesh mesh)
    {
        var corners = new Double3[3 * mesh.TriangleCount];
        for (int i = 0; i < corners.Length; i += 3)
            mesh.GetCorners(i / 3, out corners[i], out corners[i + 1], out corners[i + 2]);
        return corners;
    }

    private static TriangleMesh Make(string name, int seed)
    {
        TriangleMesh box = Solids.Box(new Vector3(-0.5f), new Vector3(0.5f));
        return name switch
        {
            "box" => box,
            "hollow" => Solids.Joined((box, default), (Solids.Flipped(Solids.Scaled(box, 0.5f)), default)),
            _ => new TriangleMesh(
                [.. Solids.Vertices(Solids.Named(name, seed)).Select(OnLattice)],
                Solids.Indices(Solids.Named(name, seed))),
        };
    }

    private static Vector3 OnLattice(Vector3 v) =>
        new(MathF.Round(v.X * 1024) / 1024, MathF.Round(v.Y * 1024) / 1024, MathF.Round(v.Z * 1024) / 1024);

    /// <summary>A corner, a place on an edge, or one in a triangle.</summary>
    private static Vector3 Aim(TriangleMesh mesh, Rng random)
    {
        mesh.GetTriangle(random.Below(mesh.TriangleCount), out int a, out int b, out int c);
        Vector3 p = mesh.GetVertex(a), q = mesh.GetVertex(b), r = mesh.GetVertex(c);
        return random.Below(4) switch
        {
            0 => (p + q + r) / 3,
            1 => p,
            2 => (p + q) / 2,
            _ => p + (q - p) * (random.Below(5) / 4f),
        };
    }
}
