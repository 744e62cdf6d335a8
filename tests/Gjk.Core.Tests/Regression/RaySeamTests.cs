namespace Gjk.Core.Tests.Regression;

/// <summary>A ray through an edge or a corner that triangles share goes through a surface nowhere.</summary>
public class RaySeamTests
{
    private const int Rays = 2000;

    [Theory]
    [InlineData(1)]
    [InlineData(50)]
    [InlineData(0.3f)]
    public void TheDiagonalOfASquareHasNoHoles(float half)
    {
        var mesh = new TriangleMesh(
            [new(-half, 0, -half), new(-half, 0, half), new(half, 0, half), new(half, 0, -half)], [0, 1, 2, 0, 2, 3]);
        AnyShape square = AnyShape.Surface(mesh);
        var scratch = new ConcaveScratch();
        var rng = new Rng(41);
        for (int i = 0; i < Rays; i++)
        {
            float at = i % 2 == 0 ? half * ((i % 253) - 126) / 128 : rng.Float(-0.99, 0.99) * half;
            Vector3 origin = new(at, half, at), to = new(0, -2 * half, 0);
            if (i % 3 == 0) to += new Vector3(1, 0, 1) * (rng.Float(-0.01, 0.01) * half);
            RigidPose pose = RigidPose.Identity;
            Met(ConcaveQuery.RayCast(square, pose, origin, to, scratch), $"{origin} along {to}");
            CastHit cast = ConcaveQuery.Cast(
                AnyShape.Of(ConvexShape.Point()), new RigidPose(origin), to, square, pose, default, scratch);
            Assert.True(cast.Result.Status == CastStatus.Hit, $"{cast.Result}: {origin} along {to}");
        }
    }

    [Fact]
    public void ACubeIsMetAtEveryEdgeAndCorner()
    {
        TriangleMesh mesh = Cube(out Vector3[] corners, out int[] triangles);
        AnyShape surface = AnyShape.Surface(mesh), solid = AnyShape.Solid(mesh);
        var scratch = new ConcaveScratch();
        var rng = new Rng(42);
        for (int i = 0; i < Rays; i++)
        {
            int t = 3 * Index(rng, 12), k = Index(rng, 3);
            Vector3 a = corners[triangles[t + k]], b = corners[triangles[t + (k + 1) % 3]];
            Vector3 on = a + (b - a) * (i % 129 / 128f);
            Vector3 to = -on + new Vector3(Index(rng, 129) - 64, Index(rng, 129) - 64, Index(rng, 129) - 64) / 64;
            if (to == Vector3.Zero || Vector3.Dot(to, on) >= -0.01f) continue;
            Vector3 origin = on - to;
            foreach (AnyShape shape in (AnyShape[])[surface, solid])
            {
                RayHit hit = ConcaveQuery.RayCast(shape, RigidPose.Identity, origin, to, scratch);
                Met(hit, $"{shape.Kind}, {origin} along {to}");
                Assert.True(hit.Distance <= 1.000001f * to.Length(), $"{hit}: {shape.Kind}, {origin} along {to}");
            }
        }
    }

    [Fact]
    public void FromOnASolidInIsAHitAtOnce()
    {
        TriangleMesh mesh = Cube(out _, out _);
        AnyShape solid = AnyShape.Solid(mesh), point = AnyShape.Of(ConvexShape.Point());
        var scratch = new ConcaveScratch();
        Vector3 on = new(0.5f, 0.25f, 1), inward = new(-0.3f, -0.7f, -2);
        foreach (float most in (float[])[0.1f, 1, float.PositiveInfinity])
        {
            RayCastResult ray = ConcaveQuery.RayCast(solid, RigidPose.Identity, on, inward, scratch, most).Result;
            Assert.Equal((CastStatus.Hit, 0f, Vector3.UnitZ), (ray.Status, ray.Distance, ray.Normal));
            ray = ConcaveQuery.RayCast(solid, RigidPose.Identity, on, -inward, scratch, most).Result;
            Assert.Equal(CastStatus.Miss, ray.Status);
        }

        CastResult cast = ConcaveQuery.Cast(
            point, new RigidPose(on), inward, solid, RigidPose.Identity, default, scratch).Result;
        Assert.Equal((CastStatus.Hit, 0f, -Vector3.UnitZ), (cast.Status, cast.Fraction, cast.Normal));
        PairDistance d = ConcaveQuery.SignedDistance(
            solid,
            new RigidPose(new Quaternion(-0.83442086f, -0.5175501f, 0.1890511f, 0.011974347f), Vector3.Zero),
            new Vector3(0.089100495f, -0.039674554f, -1.1012803f), scratch);
        Assert.True(d.Result.LowerBound <= -3.145252661642258e-10, $"{d.Result.LowerBound:R}");
        List<RayHit> hits = new(99);
        for (int i = 0; i < 3; i++)
            ConcaveQuery.RayCastAll(solid, RigidPose.Identity, 3 * Vector3.One, -Vector3.One, scratch, hits);
        long before = GC.GetAllocatedBytesForCurrentThread();
        ConcaveQuery.RayCastAll(solid, RigidPose.Identity, 3 * Vector3.One, -Vector3.One, scratch, hits);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
        Assert.True(hits.Count > 2);
    }

    /// <summary>A flat line that passes an edge closely crosses the triangle's plane far beside it: it meets the edge,
    /// where the neighbour's hit is before.</summary>
    [Fact]
    public void AFlatLineMeetsAnEdgeWhereItPassesIt()
    {
        Vector3[] corners = [new(-0.5f, 0, 0), new(0, 0, 0), new(0, 0, -0.5f), new(0.5f, 0, -0.5f)];
        int[] triangles = [0, 1, 2, 2, 1, 3];
        var pose = new RigidPose(
            new Quaternion(0.55394983f, -0.11987774f, 0.070853405f, 0.820822f),
            new Vector3(0.65045923f, -0.5600591f, -0.3490575f));
        Vector3 origin = new(0.6929637f, -0.5585863f, -0.33782446f), to = new(0.016643789f, 0.46171498f, -0.1900021f);
        AnyShape surface = AnyShape.Surface(new TriangleMesh(corners, triangles));
        var scratch = new ConcaveScratch();
        List<RayHit> hits = [];
        ConcaveQuery.RayCastAll(surface, pose, origin, to, scratch, hits);
        Assert.Equal([1, 0], hits.ConvertAll(hit => hit.Part));
        Assert.Equal(1, ConcaveQuery.RayCast(surface, pose, origin, to, scratch).Part);
        foreach (RayHit hit in hits)
        {
            int i = 3 * hit.Part;
            ConvexShape triangle = ConvexShape.Triangle(
                corners[triangles[i]], corners[triangles[i + 1]], corners[triangles[i + 2]]);
            var at = new RigidPose(hit.Result.Point);
            Assert.True(ConvexQuery.Distance(triangle, pose, ConvexShape.Point(), at).Distance < 2e-7f, $"{hit}");
        }
    }

    private static TriangleMesh Cube(out Vector3[] corners, out int[] triangles)
    {
        corners =
        [
            new(-1, -1, -1), new(1, -1, -1), new(1, 1, -1), new(-1, 1, -1), new(-1, -1, 1), new(1, -1, 1),
            new(1, 1, 1), new(-1, 1, 1),
        ];
        triangles =
        [
            0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 2, 3, 7, 2, 7, 6, 1, 2, 6, 1, 6, 5, 0, 4, 7, 0, 7, 3,
        ];
        return new TriangleMesh(corners, triangles);
    }

    private static int Index(Rng rng, int count) => (int)rng.Float(0, count - 1e-3);

    private static void Met(in RayHit hit, string where) =>
        Assert.True(hit.Result.Status is CastStatus.Hit or CastStatus.OverlappingAtStart, $"{hit.Result}: {where}");
}
