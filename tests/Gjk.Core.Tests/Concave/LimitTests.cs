namespace Gjk.Core.Tests.Concave;

/// <summary>Limits of 0, the least float, huge ones and infinity are limits like others, for shapes of every size: two
/// bodies of a few triangles or parts are nine of their sizes apart.</summary>
public class LimitTests
{
    private const float Apart = 9;

    private static readonly float[] Limits = [0, float.Epsilon, 1e30f, 3e38f, float.PositiveInfinity];

    public static TheoryData<float, int> Bodies()
    {
        var data = new TheoryData<float, int>();
        foreach (float size in new[] { 1e-30f, 1e-15f, 1, 1e15f, 1e30f })
            for (int kind = 0; kind < 4; kind++) data.Add(size, kind);
        return data;
    }

    [Theory]
    [MemberData(nameof(Bodies))]
    public void PairsAreThoseWithinTheLimit(float size, int kind)
    {
        AnyShape shape = Make(size, kind);
        var (at, over) = (RigidPose.Identity, new RigidPose(new Vector3(0, Apart * size, 0)));
        var scratch = new ConcaveScratch();
        var pairs = new List<PairDistance>();
        var contacts = new List<PairContacts>();
        float distance = ConcaveQuery.Distance(shape, at, shape, over, scratch).Distance;
        Assert.Equal(Apart * size, distance, Apart * size * 0.2f);
        foreach (float limit in Limits)
        {
            bool isWithin = distance <= limit;
            PairDistance found = ConcaveQuery.Distance(shape, at, shape, over, scratch, limit);
            Assert.Equal(isWithin ? GjkStatus.Separated : GjkStatus.BeyondMaxDistance, found.Status);
            if (isWithin) Assert.Equal(distance, found.Distance);
            Assert.True(ConcaveQuery.FindPairsWithin(shape, at, shape, over, limit, scratch, pairs));
            Assert.Equal(isWithin ? PartCount(shape) * PartCount(shape) : 0, pairs.Count);
            Assert.True(ConcaveQuery.FindContacts(shape, at, shape, over, limit, scratch, contacts));
            Assert.Equal(isWithin, contacts.Count > 0);
            PairDistance point = ConcaveQuery.Distance(shape, at, over.Position, scratch, limit);
            Assert.Equal(isWithin, point.Status == GjkStatus.Separated);
        }
    }

    [Theory]
    [MemberData(nameof(Bodies))]
    public void MotionsAreLookedAtUpToTheLimit(float size, int kind)
    {
        AnyShape shape = Make(size, kind);
        var (at, over) = (RigidPose.Identity, new RigidPose(new Vector3(0, Apart * size, 0)));
        Vector3 down = new(0, -size, 0), aside = new(size, 0, 0);
        var scratch = new ConcaveScratch();
        var rays = new List<RayHit>();
        foreach (float limit in Limits)
        {
            bool isLong = limit > Apart;
            CastHit cast = ConcaveQuery.Cast(shape, at, Vector3.Zero, shape, over, down, scratch, limit);
            Assert.Equal((isLong, isLong ? cast.Fraction : limit), (cast.IsHit, cast.Fraction));
            if (isLong) Assert.Equal(Apart, cast.Fraction, 2f);
            CastHit missed = ConcaveQuery.Cast(shape, at, Vector3.Zero, shape, over, aside, scratch, limit);
            Assert.Equal((CastStatus.Miss, limit), (missed.Status, missed.Fraction));
            CastHit still = ConcaveQuery.Cast(shape, at, Vector3.Zero, shape, over, Vector3.Zero, scratch, limit);
            Assert.Equal((CastStatus.Miss, limit), (still.Status, still.Fraction));
            foreach (float turn in new[] { 0, 1e-20f, 0.1f })
            {
                var falling = new RigidMotion(over, down, new Vector3(0, turn, 0));
                CastHit met = ConcaveQuery.TimeOfImpact(
                    shape, new RigidMotion(at, Vector3.Zero), shape, falling, scratch, 0, limit);
                Assert.Equal(isLong, met.IsHit);
                var leaving = new RigidMotion(over, -down, new Vector3(0, turn, 0));
                CastHit left = ConcaveQuery.TimeOfImpact(
                    shape, new RigidMotion(at, Vector3.Zero), shape, leaving, scratch, 0, limit);
                Assert.False(left.IsHit, $"{left} {limit} {turn}");
            }

            RayHit ray = ConcaveQuery.RayCast(shape, at, over.Position, down, scratch, limit);
            bool reaches = limit >= Apart * size;
            Assert.Equal(reaches, ray.IsHit);
            Assert.True(ConcaveQuery.RayCastAll(shape, at, over.Position, down, scratch, rays, limit));
            Assert.Equal(reaches, rays.Count > 0);
        }
    }

    [Theory]
    [MemberData(nameof(Bodies))]
    public void ScenesKeepToTheLimit(float size, int kind)
    {
        foreach (BroadPhaseKind phase in new[] { BroadPhaseKind.SortAndSweep, BroadPhaseKind.DynamicTree })
        {
            var scene = new CollisionScene(phase);
            scene.Add(Make(size, kind), RigidPose.Identity);
            var over = new RigidPose(new Vector3(0, Apart * size, 0));
            scene.Add(Make(size, kind), over);
            scene.Add(ConvexShape.Sphere(0.1f * size), new RigidPose(new Vector3(0, -Apart * size, 0)));
            var (pairs, depths) = (new List<PairDistance>(), new List<PairDistance>());
            var contacts = new List<PairContacts>();
            var (casts, rays) = (new List<CastHit>(), new List<RayHit>());
            ConvexShape ball = ConvexShape.Sphere(0.5f * size);
            foreach (float limit in Limits)
            {
                bool isWithin = limit >= 3 * Apart * size, isLong = limit > Apart;
                scene.FindPairsWithin(limit, pairs);
                Assert.Equal(isWithin ? 3 : 0, pairs.Count);
                scene.FindContacts(limit, contacts);
                Assert.Equal(isWithin, contacts.Count > 0);
                scene.FindDepths(depths);
                Assert.Empty(depths);
                var away = new RigidPose(new Vector3(0, 3 * Apart * size, 0));
                Assert.Equal(isWithin, scene.TryFindNearest(ball, away, out PairDistance _, limit));
                Vector3 down = new(0, -size, 0);
                Assert.Equal(isLong, scene.TryFindCastHit(ball, away, down, out CastHit _, limit));
                scene.FindCastHits(ball, away, down, casts, limit);
                Assert.Equal(isLong ? 3 : 0, casts.Count);
                scene.FindCastHits(ball, away, Vector3.Zero, casts, limit);
                Assert.Empty(casts);
                Assert.Equal(isWithin, scene.TryFindRayHit(new RayQuery(away.Position, down, limit), out RayHit _));
                scene.FindRayHits(new RayQuery(away.Position, down, limit), rays);
                Assert.Equal(isWithin ? 3 : 0, rays.Count);
            }
        }
    }

    private static int PartCount(in AnyShape shape) => ConcaveShapes.Parts(shape).Count;

    /// <summary>One triangle, a closed box of triangles, the same scaled, a compound of two balls.</summary>
    private static AnyShape Make(float size, int kind)
    {
        Vector3[] corners =
        [
            new(-size, 0, -size), new(size, 0, -size), new(0, 0, size),
        ];
        var ball = ConvexShape.Sphere(0.3f * size);
        return kind switch
        {
            0 => AnyShape.Surface(new TriangleMesh(corners, [0, 2, 1])),
            1 => AnyShape.Solid(ConcaveShapes.Box(new Vector3(size * 0.5f))),
            2 => AnyShape.Surface(ConcaveShapes.Box(new Vector3(0.5f)).Scaled(new Vector3(size))),
            _ => AnyShape.Of(new CompoundShape(
            [
                new CompoundPart(ball, RigidPose.Identity),
                new CompoundPart(ball, new RigidPose(new Vector3(size, 0, 0))),
            ])),
        };
    }
}
