namespace Gjk.Core.Tests.Concave;

/// <summary>What meets a flat floor near or on a seam gets the floor's normal: fractions are compared as they were
/// solved, and of several parts that are met at once a face goes before an edge and a corner.</summary>
public class CastSeamTests
{
    [Theory]
    [InlineData(0.05f, 1000f, 0.001f, 500f)]
    [InlineData(0.05f, 10000f, 0.001f, 500f)]
    [InlineData(0.5f, 20f, 0.0005f, 500f)]
    [InlineData(0.01f, 3f, 0.00008f, 500f)]
    [InlineData(0.05f, 1000f, 0.001f, 1f)]
    [InlineData(0.05f, 1000f, 0f, 500f)]
    public void ABallThatFallsBesideASeamMeetsTheFloor(float radius, float way, float aside, float half)
    {
        AnyShape floor = Floor(half), ball = AnyShape.Of(ConvexShape.Sphere(radius));
        var slabs = new CompoundShape(
        [
            new CompoundPart(Slab(half), new RigidPose(new Vector3(half, -1, 0))),
            new CompoundPart(Slab(half), new RigidPose(new Vector3(-half, -1, 0))),
        ]);
        var flush = new CollisionScene();
        flush.Add(Slab(half), new RigidPose(new Vector3(half, -1, 0)));
        flush.Add(Slab(half), new RigidPose(new Vector3(-half, -1, 0)));
        var scratch = new ConcaveScratch();
        for (int side = -1; side <= 1; side += 2)
        {
            var from = new RigidPose(new Vector3(side * aside, way / 2, 0));
            Vector3 down = new(0, -way, 0);
            foreach (AnyShape ground in new[] { floor, AnyShape.Of(slabs) })
            {
                CastHit hit = ConcaveQuery.Cast(
                    ground, RigidPose.Identity, Vector3.Zero, ball, from, down, scratch);
                AssertUp(hit.Result.Normal, $"{hit} {ground.Kind}");
                var scene = new CollisionScene();
                scene.Add(ground, RigidPose.Identity);
                Assert.True(scene.TryFindCastHit(ball.Convex, from, down, out CastHit first));
                AssertUp(-first.Result.Normal, $"{first} in a scene");
                var turning = new RigidMotion(from, down, new Vector3(0, 0.1f, 0));
                CastHit impact = ConcaveQuery.TimeOfImpact(
                    ground, new RigidMotion(RigidPose.Identity, Vector3.Zero), ball, turning, scratch, radius * 1e-4f);
                Assert.True(impact.Result.Normal.Y > 0.999f, $"{impact}");
            }

            Assert.True(flush.TryFindCastHit(ball.Convex, from, down, out CastHit met));
            AssertUp(-met.Result.Normal, $"{met} on flush boxes");
            var slanted = new RayQuery(new Vector3(side * 0.4f, 0.5f, 0), new Vector3(-side, -1, 0));
            Assert.True(flush.TryFindRayHit(slanted, out RayHit ray));
            AssertUp(ray.Result.Normal, $"{ray}");
        }
    }

    [Fact]
    public void AFaceGoesBeforeAnEdgeAndACornerWhateverTheNumbers()
    {
        // A wedge's edge, a pyramid's tip and a slab, whose highest points are level: a plate meets all at once.
        var wedge = ConvexShape.Mesh(
            [new(-1, 0, -1), new(-1, 0, 1), new(-1, -1, -1), new(-1, -1, 1), new(0, -1, -1), new(0, -1, 1)]);
        var tip = ConvexShape.Mesh([new(3, 0, 0), new(2, -1, -1), new(4, -1, -1), new(4, -1, 1), new(2, -1, 1)]);
        var slab = ConvexShape.Box(new Vector3(1, 0.5f, 1));
        var at = new RigidPose(new Vector3(6, -0.5f, 0));
        var ball = AnyShape.Of(new CompoundShape(
        [
            new CompoundPart(ConvexShape.Sphere(0.25f), new RigidPose(new Vector3(3, 0, 0))),
            new CompoundPart(ConvexShape.Sphere(0.25f), new RigidPose(new Vector3(-1, 0, 0))),
            new CompoundPart(ConvexShape.Sphere(0.25f), new RigidPose(new Vector3(6, 0, 0))),
        ]));
        CompoundPart[] parts =
        [
            new CompoundPart(tip, RigidPose.Identity), new CompoundPart(wedge, RigidPose.Identity),
            new CompoundPart(slab, at),
        ];
        var scratch = new ConcaveScratch();
        var hits = new List<CastHit>();
        var from = new RigidPose(new Vector3(0, 4, 0));
        for (int first = 0; first < 3; first++)
        {
            CompoundPart[] turned = [.. parts.Skip(first), .. parts.Take(first)];
            var ground = AnyShape.Of(new CompoundShape(turned));
            CastHit hit = ConcaveQuery.Cast(
                ground, RigidPose.Identity, Vector3.Zero, ball, from, new Vector3(0, -5, 0), scratch);
            Assert.Equal(((3 - first + 2) % 3, 2), (hit.PartA, hit.PartB));
            Assert.True(ConcaveQuery.CastAll(
                ground, RigidPose.Identity, Vector3.Zero, ball, from, new Vector3(0, -5, 0), scratch, hits));
            Assert.Equal([2, 1, 0], hits.Select(h => h.PartB));
            Assert.Equal(hit, hits[0]);
        }
    }

    private static AnyShape Floor(float half) => AnyShape.Surface(new TriangleMesh(
        [new(-half, 0, -half), new(half, 0, -half), new(half, 0, half), new(-half, 0, half)], [0, 2, 1, 0, 3, 2]));

    private static ConvexShape Slab(float half) => ConvexShape.Box(new Vector3(half, 1, half));

    private static void AssertUp(Vector3 normal, string message) =>
        Assert.True((normal - Vector3.UnitY).Length() < 1e-6f, message);
}
