namespace Gjk.Core.Tests.Queries;

/// <summary>Shapes that only touch at the start are a hit at 0 if the motion goes in, and a miss if it slides or
/// leaves; shapes that overlap there come with the normal and the depth.</summary>
public class TouchingStartTests
{
    private static readonly ConvexShape Cube = ConvexShape.Box(Vector3.One);

    private static readonly RigidPose Here = RigidPose.Identity;

    public static TheoryData<string> Bodies => ["box", "sphere", "capsule", "cylinder", "cone", "ellipsoid", "hull"];

    /// <summary>On top of a cube: down is in; along and up is not, however short or long the way.</summary>
    [Theory]
    [MemberData(nameof(Bodies))]
    public void WhatStandsMaySlideAndLeave(string kind)
    {
        ConvexShape body = Standing(kind);
        foreach (float size in new[] { 1, 1e-3f, 1024, 1e-28f, 1e28f })
        {
            ConvexShape floor = Cube.Scaled(new Vector3(size)), moving = body.Scaled(new Vector3(size));
            var pose = new RigidPose(new Vector3(0.25f * size, 2 * size, -0.25f * size));
            foreach (float way in new[] { 1, 1e-3f, 64 })
            {
                foreach (Vector3 motion in new Vector3[] { new(1, 0, 0), new(-1, 0, 2), new(0, 1, 0), new(1, 1, 1) })
                    Check(CastStatus.Miss, floor, moving, pose, motion * (way * size), $"{kind} {size} {motion}");
                foreach (Vector3 motion in new Vector3[] { new(0, -1, 0), new(1, -1, 0), new(3, -0.5f, -2) })
                    Check(CastStatus.Hit, floor, moving, pose, motion * (way * size), $"{kind} {size} {motion}");
            }

            Check(CastStatus.Miss, floor, moving, pose, default, $"{kind} {size} at rest");
        }

        static void Check(
            CastStatus status, in ConvexShape a, in ConvexShape b, in RigidPose pose, Vector3 motion, string what)
        {
            CastResult r = ConvexQuery.Cast(a, Here, default, b, pose, motion);
            CastResult shared = ConvexQuery.Cast(a, Here, motion, b, pose, motion * 2);
            CastResult swapped = ConvexQuery.Cast(b, pose, motion, a, Here, default).Swapped;
            WarmStart warm = default;
            ConvexQuery.Distance(a, Here, b, pose, ref warm);
            CastResult warmed = ConvexQuery.Cast(a, Here, default, b, pose, motion, ref warm, 1);
            foreach (CastResult s in new[] { r, shared, swapped, warmed })
            {
                Assert.True(s.Status == status, $"{what}: {s}");
                Assert.Equal((status == CastStatus.Hit ? 0f : 1f, 0f), (s.Fraction, s.Depth));
                if (status == CastStatus.Hit)
                    Assert.True((s.Normal - Vector3.UnitY).Length() < 1e-4f, $"{what}: {s}");
            }
        }
    }

    /// <summary>Lattice polytopes, corner on corner, held to all half-spaces in which they touch.</summary>
    [Fact]
    public void TheBestOfThePlanesThatTouchDecides()
    {
        int hits = 0, count = Budget.Count(1500);
        for (int i = 0; i < count; i++)
        {
            TestPair p = TouchingPairs.Make((ulong)i);
            Vector3 motion = TouchingPairs.Motion(new Rng((ulong)(4000 + i)));
            if (!HasInside(p)) continue;
            bool isIn = CloudDepth.Rate(p, motion, 1e-9) < -1e-9;
            CastResult r = ConvexQuery.Cast(p.A.Shape, p.PoseA, default, p.B.Shape, p.PoseB, motion);
            CastResult swapped = ConvexQuery.Cast(p.B.Shape, p.PoseB, motion, p.A.Shape, p.PoseA, default);
            CastStatus truth = isIn ? CastStatus.Hit : CastStatus.Miss;
            Assert.True(
                (r.Status, swapped.Status) == (truth, truth), $"{p} along {TestShape.T(motion)}: {r}, {swapped}");
            if (!isIn) continue;
            hits++;
            Assert.Equal(0, r.Fraction);
            Assert.True(Vector3.Dot(r.Normal, motion) < 0, $"{p} along {TestShape.T(motion)}: {r}");
        }

        Assert.InRange(hits, 0.03 * count, 0.4 * count);
    }

    /// <summary>Where the bounding balls are those of the shapes they are apart at the start, by less than counts as
    /// touching.</summary>
    [Fact]
    public void WhatTheDistanceCallsTouchingIsHitAtZero()
    {
        ConvexShape ball = ConvexShape.Ellipsoid(Vector3.One), point = ConvexShape.Sphere(0.07143247f);
        var at = new RigidPose(new Vector3(0, -1.9e-8f, 1.6e-8f));
        var beside = new RigidPose(new Vector3(0.20162179f, 0.90375173f, 0.53902596f));
        Check(ball, at, point, beside, new Vector3(0, 0, -500_000));
        var below = new RigidPose(new Vector3(-0.0916751f, -0.05800019f, -0.05918061f));
        Check(ConvexShape.Cone(0, 3e-12f), Here, ConvexShape.Sphere(0.12357464f), below, new Vector3(0.02f, 0, 0));

        static void Check(
            in ConvexShape a, in RigidPose poseA, in ConvexShape b, in RigidPose poseB, Vector3 motion)
        {
            Assert.Equal(0, ConvexQuery.SignedDistance(a, poseA, b, poseB).Distance);
            CastResult r = ConvexQuery.Cast(a, poseA, default, b, poseB, motion);
            Assert.Equal((CastStatus.Hit, 0f), (r.Status, r.Fraction));
        }
    }

    /// <summary>What has no inside is gone through: a point leaves a triangle on either side, and along it.</summary>
    [Theory]
    [InlineData(0, -1, 0)]
    [InlineData(0, 1, 0)]
    [InlineData(1, 0, 0)]
    [InlineData(1, -1, 1)]
    public void WhatIsFlatHasNothingToGoInto(float x, float y, float z)
    {
        Vector3 motion = new(x, y, z), on = new(0.25f, 0, 0.25f);
        foreach (ConvexShape flat in new[]
        {
            ConvexShape.Triangle(default, Vector3.UnitX, Vector3.UnitZ), ConvexShape.Box(new Vector3(1, 0, 1)),
            ConvexShape.Segment(new Vector3(-1, 0, 0.25f), new Vector3(1, 0, 0.25f)),
        })
        {
            CastResult r = ConvexQuery.Cast(flat, Here, default, ConvexShape.Point(), new RigidPose(on), motion);
            Assert.Equal(CastStatus.Miss, r.Status);
            Assert.Equal(CastStatus.Miss, ConvexQuery.RayCast(flat, Here, on, motion).Status);
        }
    }

    /// <summary>An overlap has the bits of the signed distance, and B moved out by it only touches.</summary>
    [Fact]
    public void AnOverlapComesWithItsWayOut()
    {
        int starts = 0;
        for (int i = 0; i < Budget.Count(300); i++)
        {
            TestPair p = Generators.Pair((ulong)i, Generators.AllKinds);
            DistanceResult signed = p.SignedDistance();
            Vector3 motion = new Rng((ulong)i).Vector(-1, 1);
            CastResult r = ConvexQuery.Cast(p.A.Shape, p.PoseA, default, p.B.Shape, p.PoseB, motion);
            if (!(signed.Distance < -1e-6 * p.Scale) || signed.Status != GjkStatus.Overlapping) continue;
            starts++;
            Assert.True(
                (r.Status, r.Fraction, r.Normal, r.Depth)
                    == (CastStatus.OverlappingAtStart, 0, signed.Normal, -signed.Distance), $"{p}: {r}, {signed}");
            Assert.True(r.IsHit);
            var moved = new RigidPose(p.PoseB.Rotation, p.PoseB.Position + r.Normal * r.Depth);
            float left = ConvexQuery.SignedDistance(p.A.Shape, p.PoseA, p.B.Shape, moved).Distance;
            Assert.True(Math.Abs(left) < 1e-5 * p.Scale, $"{p}: {r}, {left} is left");
        }

        Assert.True(starts > 50, $"{starts} starts");
    }

    /// <summary>Curved bodies on a floor: exactly on it they touch, though their depth is known to no more than 1e-6; a
    /// hundred millionth lower they overlap.</summary>
    [Fact]
    public void CurvedBodiesTouchWhereTheirDistanceSaysSo()
    {
        ConvexShape floor = ConvexShape.Box(new Vector3(8, 1, 8));
        for (int i = 0; i < Budget.Count(150); i++)
        {
            var rng = new Rng((ulong)i);
            Vector3 radii = new Vector3(1 + rng.Below(15), 1 + rng.Below(15), 1 + rng.Below(15)) / 16;
            ConvexShape body = ConvexShape.Ellipsoid(radii);
            float low = radii.Y;
            if (i % 3 == 1) (body, low) = (ConvexShape.Cone(radii.X, radii.Y), radii.Y);
            if (i % 3 == 2) (body, low) = (ConvexShape.Ellipsoid(radii).Rounded(0.125f), radii.Y + 0.125f);
            var at = new Vector3(rng.Float(-4, 4), 1 + low, rng.Float(-4, 4));
            Vector3 along = new(rng.Float(-1, 1), 0, rng.Float(-1, 1)), lower = new(0, 4.8e-7f, 0);
            string what = $"seed {i}: {body} at {at}";
            Assert.True(Cast(body, at, along).Status == CastStatus.Miss, what);
            Assert.True(Cast(body, at, along + Vector3.UnitY).Status == CastStatus.Miss, what);
            Assert.True(Cast(body, at, along - Vector3.UnitY).Status == CastStatus.Hit, what);
            CastResult deep = Cast(body, at - lower, along);
            Assert.True(deep.Status == CastStatus.OverlappingAtStart, $"{what}: {deep}");
            Assert.True(Math.Abs(deep.Depth - 4.8e-7) < 4e-6, $"{what}: {deep}");
        }

        CastResult Cast(in ConvexShape body, Vector3 at, Vector3 motion) =>
            ConvexQuery.Cast(floor, Here, default, body, new RigidPose(at), motion);
    }

    /// <summary>Round bodies that stand on a wide floor: a slope of some 1e-8 takes them in by more than counts as
    /// touching, and one of 0 does not.</summary>
    [Theory]
    [MemberData(nameof(Bodies))]
    public void ASlightSlopeGoesIn(string kind)
    {
        ConvexShape floor = ConvexShape.Box(new Vector3(64, 1, 64)), body = Standing(kind);
        ConvexShape round = ConvexShape.Cylinder(64, 1);
        var at = new RigidPose(new Vector3(0, 2, 0.5f));
        foreach (ConvexShape below in new[] { floor, round })
        {
            foreach (float slope in new[] { 1e-6f, 3e-7f, 1e-7f, 1e-8f })
            {
                CastResult r = ConvexQuery.Cast(below, Here, default, body, at, new Vector3(9, -9 * slope, 3));
                Assert.True((r.Status, r.Fraction) == (CastStatus.Hit, 0), $"{kind}, {slope}: {r}");
                Assert.True((r.Normal - Vector3.UnitY).Length() < 1e-6f, $"{kind}, {slope}: {r}");
            }

            foreach (float slope in new[] { 0, -1e-9f, -1e-6f })
            {
                CastResult r = ConvexQuery.Cast(below, Here, default, body, at, new Vector3(9, -9 * slope, 3));
                Assert.True(r.Status == CastStatus.Miss, $"{kind}, {slope}: {r}");
            }
        }
    }

    /// <summary>A ray from a surface hits at 0 if it goes in; from inside the way out is told.</summary>
    [Theory]
    [MemberData(nameof(Bodies))]
    public void RaysFromASurfaceGoInOrMiss(string kind)
    {
        ConvexShape body = Standing(kind);
        Vector3 origin = new(0, -1, 0), inside = new(0, -0.75f, 0);
        foreach (Vector3 v in new Vector3[] { new(0, 1, 0), new(1, 2, 0), new(0, 1e-3f, 0) })
        {
            RayCastResult r = ConvexQuery.RayCast(body, Here, origin, v);
            Assert.True(r.Status == CastStatus.Hit, $"{kind} along {v}: {r}");
            Assert.Equal((0f, origin, 0f), (r.Distance, r.Point, r.Depth));
            Assert.True((r.Normal + Vector3.UnitY).Length() < 1e-4f, $"{kind}: {r}");
        }

        foreach (Vector3 v in new Vector3[] { new(0, -1, 0), new(1, 0, 0), new(1, -1, 1) })
        {
            RayCastResult r = ConvexQuery.RayCast(body, Here, origin, v, 7);
            Assert.True((r.Status, r.Distance) == (CastStatus.Miss, 7), $"{kind} along {v}: {r}");
        }

        RayCastResult deep = ConvexQuery.RayCast(body, Here, inside, Vector3.UnitX);
        DistanceResult signed = ConvexQuery.SignedDistance(body, Here, inside);
        Assert.Equal(
            (CastStatus.OverlappingAtStart, inside, signed.Normal, -signed.Distance),
            (deep.Status, deep.Point, deep.Normal, deep.Depth));
    }

    /// <summary>A point, turned anyhow, within a rounding of a capsule's tip: the cast begins as the overlap of the
    /// same pair says, in either order.</summary>
    [Fact]
    public void ATurnedPointOnATipBeginsAsItsOverlapSays()
    {
        int touching = 0;
        for (int i = 0; i < Budget.Count(4000); i++)
        {
            var rng = new Rng((ulong)i);
            float radius = (16 + rng.Below(240)) / 256f, half = (16 + rng.Below(240)) / 256f;
            ConvexShape capsule = ConvexShape.Capsule(radius, half), point = ConvexShape.Point();
            var at = new RigidPose(new Vector3(0, -(radius + half), 0));
            var tip = new RigidPose(rng.Rotation(), new Vector3(0, rng.Float(0, 4e-15), 0));
            var away = new Vector3(0, 0.25f, 0);
            bool isOver = ConvexQuery.Overlaps(point, tip, capsule, at);
            touching += isOver ? 1 : 0;
            Check(ConvexQuery.Cast(point, tip, away, capsule, at, default), isOver, i);
            Check(ConvexQuery.Cast(point, tip, -away, capsule, at, default), isOver, i);
            isOver = ConvexQuery.Overlaps(capsule, at, point, tip);
            Check(ConvexQuery.Cast(capsule, at, default, point, tip, -away), isOver, i);
        }

        Assert.InRange(touching, 1, Budget.Count(4000) - 1);

        static void Check(in CastResult r, bool isOver, int seed) => Assert.True(
            !isOver || r.Status == CastStatus.Miss || r.Fraction == 0, $"seed {seed}: {r}");
    }

    [Fact]
    public void NothingIsAllocated()
    {
        var touching = new RigidPose(new Vector3(0, 2, 0));
        Assert.Equal(0, Allocation.Least(() =>
        {
            for (int i = 0; i < 20; i++)
            {
                ConvexQuery.Cast(Cube, Here, default, Cube, touching, new Vector3(1, -0.1f, 0));
                ConvexQuery.RayCast(Cube, Here, new Vector3(0, 1, 0), -Vector3.UnitY);
                ConvexQuery.Cast(Cube, Here, default, Cube, touching, -Vector3.UnitY, 1, CastOptions.OnlyDeeper(0.1f));
            }
        }));
    }

    /// <summary>One of them has an inside, so there is something to go into.</summary>
    private static bool HasInside(TestPair p) => p.A.Vertices!.Length > 3 || p.B.Vertices!.Length > 3;

    /// <summary>Reaches down to y = -1 at the origin, and not along a wall.</summary>
    private static ConvexShape Standing(string kind) => kind switch
    {
        "sphere" => ConvexShape.Sphere(1),
        "capsule" => ConvexShape.Capsule(0.5f, 0.5f),
        "cylinder" => ConvexShape.Cylinder(1, 1),
        "cone" => ConvexShape.Cone(1, 1),
        "ellipsoid" => ConvexShape.Ellipsoid(new Vector3(0.5f, 1, 2)),
        "hull" => ConvexShape.Mesh([new(-1, -1, -1), new(1, -1, -1), new(0, -1, 1), new(0, 1, 0)]),
        _ => Cube,
    };
}
