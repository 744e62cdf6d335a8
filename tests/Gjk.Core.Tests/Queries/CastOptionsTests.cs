namespace Gjk.Core.Tests.Queries;

/// <summary>Motions that do not go deeper than is allowed pass; all others are stopped where they touch.</summary>
public class CastOptionsTests
{
    private static readonly CastOptions NoDeeper = CastOptions.OnlyDeeper();

    private static readonly string[] Kinds = [.. Generators.AllKinds, "bigHull", "made"];

    /// <summary>Any pair: what is stopped would have gone deeper, and is stopped as without the option; what passes
    /// gets no deeper, by the least signed distance on the way.</summary>
    [Fact]
    public void WhatIsStoppedGoesDeeperAndWhatPassesDoesNot()
    {
        int passed = 0, stopped = 0, count = Budget.Count(1500);
        for (int i = 0; i < count; i++)
        {
            TestPair p = Generators.Pair((ulong)i, Kinds, 1.3);
            var rng = new Rng((ulong)(3000 + i));
            Vector3 toA = p.PoseA.Position - p.PoseB.Position;
            Vector3 motion = toA * rng.Float(-0.5, 2) + rng.Vector(-1, 1) * (float)p.Scale;
            float most = rng.Float(0.2, 1.5), allowed = rng.Below(3) == 0 ? 0 : (float)p.Scale * rng.Float(0, 0.3);
            CastResult plain = Cast(p, motion, most, default);
            CastResult r = Cast(p, motion, most, CastOptions.OnlyDeeper(allowed));
            string what = $"{p} along {TestShape.T(motion)} up to {most:R}, {allowed:R}: {r}, plainly {plain}";
            Assert.True(r.Status is CastStatus.Hit or CastStatus.Miss or CastStatus.OverlappingAtStart, what);
            if (!plain.IsHit)
            {
                Assert.True(r.Status == CastStatus.Miss && r.Fraction == most, what);
                continue;
            }

            double limit = Math.Max(allowed, plain.Depth), deepest = Deepest(p, motion, plain.Fraction, most);
            double slack = 1e-5 * p.Scale + 1e-6 * motion.Length();
            if (r.Status == CastStatus.Miss)
            {
                passed++;
                Assert.True(deepest <= limit + slack, $"{what}, but it gets {deepest:R} deep");
                continue;
            }

            stopped++;
            Assert.True(
                (r.Status, r.Fraction, r.Normal, r.Depth)
                    == (plain.Status, plain.Fraction, plain.Normal, plain.Depth), what);
            Assert.True(deepest >= limit - slack, $"{what}, but it gets only {deepest:R} deep");
        }

        Assert.InRange(passed, 0.1 * count, 0.6 * count);
        Assert.InRange(stopped, 0.1 * count, 0.6 * count);
    }

    /// <summary>A box that a cast has stopped at a wall, in floats, is a rounding inside or outside of it. The rest of
    /// its motion, projected onto the wall in floats, passes whole; without the option it is often stuck.</summary>
    [Fact]
    public void WhatWasStoppedSlidesOn()
    {
        int stuck = 0, count = 300;
        for (int i = 0; i < count; i++)
        {
            var rng = new Rng((ulong)i);
            ConvexShape wall = ConvexShape.Box(new Vector3(1, 50, 50));
            ConvexShape body = i % 2 == 0 ? ConvexShape.Box(rng.Vector(0.2, 1)) : ConvexShape.Capsule(0.4f, 0.6f);
            var wallAt = new RigidPose(
                Quaternion.Normalize(new Quaternion(rng.Vector(-0.2, 0.2), 1)), rng.Vector(-3, 3));
            RigidPose at = new(rng.Rotation(), wallAt.Position + new Vector3(6, rng.Float(-2, 2), rng.Float(-2, 2)));
            Vector3 wish = new(-9, rng.Float(-4, 4), rng.Float(-4, 4));
            CastResult hit = ConvexQuery.Cast(body, at, wish, wall, wallAt, default);
            Assert.Equal(CastStatus.Hit, hit.Status);
            at = new RigidPose(at.Rotation, at.Position + wish * hit.Fraction);
            Vector3 along = wish - Vector3.Dot(wish, hit.Normal) * hit.Normal;
            along -= Vector3.Dot(along, hit.Normal) * hit.Normal;
            CastResult plain = ConvexQuery.Cast(body, at, along, wall, wallAt, default);
            CastResult slide = ConvexQuery.Cast(body, at, along, wall, wallAt, default, 1, NoDeeper);
            CastResult away = ConvexQuery.Cast(body, at, -wish, wall, wallAt, default, 1, NoDeeper);
            CastResult into = ConvexQuery.Cast(body, at, wish, wall, wallAt, default, 1, NoDeeper);
            if (plain.IsHit) stuck++;
            Assert.True(slide.Status == CastStatus.Miss, $"seed {i}: {slide}, plainly {plain}");
            Assert.True(away.Status == CastStatus.Miss, $"seed {i}: {away}");
            Assert.True(into.IsHit && into.Fraction < 1e-6f, $"seed {i}: {into}");
        }

        Assert.InRange(stuck, 30, count - 1);
    }

    /// <summary>Over the seam of two tiles, a little lower than the body stands, and a step up that stops it.</summary>
    [Theory]
    [InlineData(0, 0, false)]
    [InlineData(1e-6f, 1e-5f, false)]
    [InlineData(1e-5f, 0, true)]
    [InlineData(1e-3f, 2e-3f, false)]
    [InlineData(0.01f, 2e-3f, true)]
    public void ASeamDoesNotStopWhatSlidesOverIt(float step, float allowed, bool isStopped)
    {
        foreach (ConvexShape body in new[]
        {
            ConvexShape.Box(new Vector3(0.5f)), ConvexShape.Cylinder(0.5f, 0.5f),
            ConvexShape.Mesh(TestShape.Corners(new Vector3(0.5f))),
        })
        {
            ConvexShape tile = ConvexShape.Box(new Vector3(2, 0.5f, 2));
            RigidPose here = new(new Vector3(0, 0.5f, 0.3f)), next = new(new Vector3(4, -0.5f + step, 0));
            Vector3 along = new(5, 0, 0.4f);
            CastOptions options = CastOptions.OnlyDeeper(allowed);
            CastResult own = ConvexQuery.Cast(body, here, along, tile, new RigidPose(new(0, -0.5f, 0)), default);
            CastResult r = ConvexQuery.Cast(body, here, along, tile, next, default, 1, options);
            CastResult plain = ConvexQuery.Cast(body, here, along, tile, next, default);
            Assert.Equal(CastStatus.Miss, own.Status);
            Assert.Equal((isStopped ? CastStatus.Hit : CastStatus.Miss, CastStatus.Hit), (r.Status, plain.Status));
            if (isStopped) Assert.Equal(0.3f, r.Fraction, 1e-2f);
        }
    }

    /// <summary>A slope of a millionth is a slide, whatever the depth at the start; a steeper one goes in.</summary>
    [Fact]
    public void ASlopeThatFloatsMakeIsASlide()
    {
        ConvexShape floor = ConvexShape.Box(new Vector3(4, 1, 4)), cube = ConvexShape.Box(Vector3.One);
        foreach (float y in new[] { 2, 1.99f, 1.5f })
        {
            Assert.Equal(CastStatus.Miss, Cast(y, 8e-7f).Status);
            Assert.True(Cast(y, 1.2e-6f).IsHit);
        }

        CastResult Cast(float y, float slope) => ConvexQuery.Cast(
            floor, RigidPose.Identity, default, cube, new RigidPose(new Vector3(0, y, 0)), new Vector3(1, -slope, 0), 1,
            NoDeeper);
    }

    /// <summary>Round bodies that pass each other as deep as is allowed, but for a millionth more or less: told apart
    /// by bounds that meet there.</summary>
    [Fact]
    public void WhatIsJustAllowedPasses()
    {
        ConvexShape ball = ConvexShape.Sphere(1), capsule = ConvexShape.Capsule(1, 1);
        foreach (ConvexShape body in new[] { ball, capsule })
        {
            for (int i = 0; i < 60; i++)
            {
                var rng = new Rng((ulong)i);
                float side = rng.Float(1.2, 1.99), allowed = 2 - side;
                var at = new RigidPose(new Vector3(-3 - rng.Float(0, 1), 0, side));
                Vector3 motion = new Vector3(rng.Float(4, 8), 0, 0) * MathF.Pow(10, rng.Below(5) - 2);
                Assert.True(Cast(allowed * (1 + 1e-6f)).Status == CastStatus.Miss, $"seed {i}");
                Assert.True(Cast(allowed * (1 - 1e-6f) - 4e-6f).Status == CastStatus.Hit, $"seed {i}");

                CastResult Cast(float depth) => ConvexQuery.Cast(
                    capsule, RigidPose.Identity, default, body, at, motion, float.PositiveInfinity,
                    CastOptions.OnlyDeeper(Math.Max(depth, 0)));
            }
        }
    }

    /// <summary>Rays pass as points do: out of what they begin in, and along its surface.</summary>
    [Fact]
    public void RaysPassWhatTheyLeave()
    {
        ConvexShape box = ConvexShape.Box(Vector3.One), ball = ConvexShape.Sphere(1);
        RigidPose here = RigidPose.Identity;
        Vector3 inside = new(0, 0.75f, 0);
        foreach (ConvexShape shape in new[] { box, ball })
        {
            Assert.Equal(CastStatus.Miss, Ray(shape, inside, Vector3.UnitY).Status);
            Assert.Equal(CastStatus.OverlappingAtStart, Ray(shape, inside, -Vector3.UnitY).Status);
            Assert.Equal(CastStatus.Miss, Ray(shape, inside, -Vector3.UnitY, 0.1f, 0.35f).Status);
            Assert.Equal(CastStatus.OverlappingAtStart, Ray(shape, inside, -Vector3.UnitY, 0.2f, 0.35f).Status);
            RayCastResult from = Ray(shape, new Vector3(0, 3, 0), -Vector3.UnitY, 9, 0.5f);
            Assert.Equal((CastStatus.Hit, 2f, Vector3.UnitY), (from.Status, from.Distance, from.Normal));
            RayCastResult shallow = Ray(shape, new Vector3(0, 3, 0), -Vector3.UnitY, 2.25f, 0.5f);
            Assert.Equal((CastStatus.Miss, 2.25f), (shallow.Status, shallow.Distance));
        }

        RayCastResult graze = Ray(box, new Vector3(-5, 1, 0), Vector3.UnitX);
        Assert.Equal(CastStatus.Miss, graze.Status);
        Assert.Equal(CastStatus.Hit, ConvexQuery.RayCast(box, here, new Vector3(-5, 1, 0), Vector3.UnitX).Status);

        RayCastResult Ray(
            in ConvexShape shape, Vector3 origin, Vector3 direction, float reach = float.PositiveInfinity,
            float allowed = 0) =>
            ConvexQuery.RayCast(shape, here, origin, direction, reach, CastOptions.OnlyDeeper(allowed));
    }

    [Fact]
    public void ADepthIsFiniteAndNotNegative()
    {
        foreach (float bad in new[] { -1e-9f, float.NaN, float.PositiveInfinity })
        {
            Assert.Equal(
                "allowedDepth",
                Assert.Throws<ArgumentOutOfRangeException>(() => CastOptions.OnlyDeeper(bad)).ParamName);
        }

        CastOptions some = CastOptions.OnlyDeeper(0.5f);
        Assert.Equal((true, 0.5f), (some.PassesShallow, some.AllowedDepth));
        Assert.True(some == CastOptions.OnlyDeeper(0.5f) && some != NoDeeper && NoDeeper != default);
        Assert.Equal(some.GetHashCode(), CastOptions.OnlyDeeper(0.5f).GetHashCode());
        Assert.Equal(("Every contact", "Only what goes deeper than 0.5"), ($"{default(CastOptions)}", $"{some}"));
    }

    private static CastResult Cast(TestPair p, Vector3 motion, float most, in CastOptions options) =>
        ConvexQuery.Cast(p.A.Shape, p.PoseA, default, p.B.Shape, p.PoseB, motion, most, options);

    /// <summary>The largest depth on the way, by thirds: the signed distance is convex.</summary>
    private static double Deepest(TestPair p, Vector3 motion, double from, double to)
    {
        double ends = Math.Max(-At(from), -At(to));
        for (int i = 0; i < 40; i++)
        {
            double third = (to - from) / 3;
            if (At(from + third) < At(to - third)) to -= third;
            else from += third;
        }

        return Math.Max(ends, -At((from + to) / 2));

        double At(double fraction) => ConvexQuery.SignedDistance(
            p.A.Shape, p.PoseA, p.B.Shape,
            new RigidPose(p.PoseB.Rotation, (Vector3)((Double3)motion * fraction + p.PoseB.Position))).Distance;
    }
}
