namespace Gjk.Core.Tests.Queries;

/// <summary>Casts by hand, and what holds of any.</summary>
public class CastTests
{
    private static readonly ConvexShape Cube = ConvexShape.Box(Vector3.One);

    private static readonly string[] Kinds = [.. Generators.AllKinds, "bigHull", "made"];

    [Theory]
    [InlineData(0, 0, 0.3f)]
    [InlineData(1.5f, -1.5f, 0.3f)]
    [InlineData(2, 0, 0.3f)]
    public void ACubeFallsOnACube(float x, float z, float fraction)
    {
        CastResult r = ConvexQuery.Cast(
            Cube, RigidPose.Identity, default, Cube, new RigidPose(new Vector3(x, 5, z)), new Vector3(0, -10, 0));
        Assert.Equal((CastStatus.Hit, fraction, Vector3.UnitY), (r.Status, r.Fraction, r.Normal));
        Assert.Equal(1, r.Point.Y, 1e-6f);
        Assert.InRange(r.Point.X, x - 1, 1);
        Assert.True(r.IsHit);
        Assert.Equal((CastStatus.Hit, -Vector3.UnitY), (r.Swapped.Status, r.Swapped.Normal));
    }

    /// <summary>A cube that slides along a face, however close, does not hit it; nor one that leaves.</summary>
    [Theory]
    [InlineData(2.0000002f)]
    [InlineData(2.001f)]
    [InlineData(100)]
    public void WhatSlidesBesideAFaceMissesIt(float y)
    {
        foreach (Vector3 motion in new[] { new Vector3(1e6f, 0, 0), new Vector3(1, 0, 0), default, new(0, 1e-30f, 0) })
        {
            CastResult r = ConvexQuery.Cast(
                Cube, RigidPose.Identity, default, Cube, new RigidPose(new Vector3(-3, y, 0)), motion);
            Assert.Equal((CastStatus.Miss, 1f, false), (r.Status, r.Fraction, r.IsHit));
            Assert.True(float.IsNaN(r.Point.X) && float.IsNaN(r.Normal.X));
        }
    }

    [Theory]
    [InlineData(1.5f)]
    [InlineData(0.25f)]
    public void WhatOverlapsAtTheStartSaysSo(float y)
    {
        CastResult r = ConvexQuery.Cast(
            Cube, RigidPose.Identity, default, Cube, new RigidPose(new Vector3(0, y, 0)), new Vector3(0, 7, 0));
        Assert.Equal(
            (CastStatus.OverlappingAtStart, 0f, Vector3.UnitY, 2 - y, true),
            (r.Status, r.Fraction, r.Normal, r.Depth, r.IsHit));
        Assert.Equal((-r.Normal, r.Depth), (r.Swapped.Normal, r.Swapped.Depth));
        Assert.InRange(r.Point.Y, -1, 1);
    }

    /// <summary>Spheres whose centres are apart, with a small one in the large one's margin, either way.</summary>
    [Theory]
    [InlineData(1, 0, 0.25f)]
    [InlineData(0, 1, 0.25f)]
    [InlineData(0.75f, 0.25f, 0.9f)]
    public void WhereOnlyMarginsOverlapThePointIsInBoth(float radiusA, float radiusB, float apart)
    {
        SphereShape a = new(radiusA), b = new(radiusB);
        CastResult r = ConvexQuery.Cast(
            a, RigidPose.Identity, Vector3.UnitX, b, new RigidPose(new Vector3(0, apart, 0)), default);
        Assert.Equal(CastStatus.OverlappingAtStart, r.Status);
        Assert.InRange(r.Point.Length(), 0, radiusA * 1.0000001f);
        Assert.InRange((r.Point - new Vector3(0, apart, 0)).Length(), 0, radiusB * 1.0000001f);
    }

    [Fact]
    public void TheLargestFractionIsHonoured()
    {
        var pose = new RigidPose(new Vector3(0, 5, 0));
        var motion = new Vector3(0, -2, 0);
        Assert.Equal(CastStatus.Miss, Cast(1).Status);
        Assert.Equal((CastStatus.Hit, 1.5f), (Cast(2).Status, Cast(2).Fraction));
        Assert.Equal((CastStatus.Hit, 1.5f), (Cast(1.5f).Status, Cast(1.5f).Fraction));
        Assert.Equal((CastStatus.Miss, 1.4999f), (Cast(1.4999f).Status, Cast(1.4999f).Fraction));
        CastResult endless = Cast(float.PositiveInfinity);
        Assert.Equal((CastStatus.Hit, 1.5f), (endless.Status, endless.Fraction));
        Assert.Equal((CastStatus.Miss, 0f), (Cast(-1).Status, Cast(-1).Fraction));

        CastResult Cast(float most) => ConvexQuery.Cast(Cube, RigidPose.Identity, default, Cube, pose, motion, most);
    }

    [Fact]
    public void SpheresMeetWhereTheirRadiiDo()
    {
        CastResult r = ConvexQuery.Cast(
            new SphereShape(1), RigidPose.Identity, new Vector3(1, 0, 0), new SphereShape(0.5f),
            new RigidPose(new Vector3(4, 0, 0)), new Vector3(-1, 0, 0));
        Assert.Equal(CastStatus.Miss, r.Status);
        r = ConvexQuery.Cast(
            new SphereShape(1), RigidPose.Identity, new Vector3(2, 0, 0), new SphereShape(0.5f),
            new RigidPose(new Vector3(4, 0, 0)), new Vector3(-2, 0, 0));
        Assert.Equal((CastStatus.Hit, 0.625f, Vector3.UnitX), (r.Status, r.Fraction, r.Normal));
        Assert.Equal(new Vector3(2.25f, 0, 0), r.Point);
    }

    /// <summary>Of any pair: before the fraction the shapes are apart, at it they touch to within the accuracy, and a
    /// miss is apart along the whole way.</summary>
    [Fact]
    public void AHitTouchesAndNothingBeforeIt()
    {
        int hits = 0, starts = 0, count = Budget.Count(3000);
        for (int i = 0; i < count; i++)
        {
            TestPair p = Generators.Pair((ulong)i, Kinds, 2);
            var rng = new Rng((ulong)(7000 + i));
            Vector3 toA = p.PoseA.Position - p.PoseB.Position;
            Vector3 motion = (toA + rng.Vector(-0.7, 0.7) * toA.Length()) * rng.Float(0.5, 2);
            Vector3 motionA = rng.Below(2) == 0 ? default : rng.Vector(-1, 1);
            CastResult r = ConvexQuery.Cast(
                p.A.Shape, p.PoseA, motionA, p.B.Shape, p.PoseB, motion + motionA);
            double scale = Math.Max(p.A.LongestSide, p.B.LongestSide) + motion.Length() + motionA.Length();
            Assert.True(r.Status is CastStatus.Hit or CastStatus.Miss or CastStatus.OverlappingAtStart, $"{p}: {r}");
            bool overlaps = p.Distance().IsOverlapping, isDeep = p.SignedDistance().Distance < -1e-6 * p.Scale;
            Assert.True(overlaps || r.Status != CastStatus.OverlappingAtStart, $"{p}: {r}");
            Assert.True(!isDeep || r.Status == CastStatus.OverlappingAtStart, $"{p}: {r}");
            if (r.Status == CastStatus.OverlappingAtStart) starts++;
            if (r.Status == CastStatus.Hit) hits++;
            if (overlaps && r.Status != CastStatus.OverlappingAtStart)
            {
                // They only touch.
                Assert.True(r.Status == CastStatus.Miss || r.Fraction == 0, $"{p}: {r}");
                continue;
            }

            float end = r.Status == CastStatus.Miss ? 1 : r.Fraction;
            for (int k = 0; k < 8 && r.Status != CastStatus.OverlappingAtStart; k++)
            {
                float before = end * (k == 0 ? 1 - 1e-4f : rng.Float(0, 1));
                DistanceResult d = At(p, motionA, motion, before);
                Assert.True(!d.IsOverlapping || k == 0, $"{p}: {r}, but at {before:R} {d}");
            }

            if (r.Status != CastStatus.Hit) continue;
            DistanceResult at = ConvexQuery.SignedDistance(
                p.A.Shape, new RigidPose(p.PoseA.Rotation, p.PoseA.Position + motionA * r.Fraction), p.B.Shape,
                new RigidPose(p.PoseB.Rotation, p.PoseB.Position + (motion + motionA) * r.Fraction));
            Assert.True(Math.Abs(at.Distance) <= 2e-6 * scale, $"{p}: {r}, but then {at}");
            Assert.Equal(1, r.Normal.Length(), 1e-6f);
            Assert.True(Vector3.Dot(r.Normal, motion) <= 1e-6f * motion.Length(), $"{p}: {r} moves away");
        }

        Assert.InRange(hits, 0.3 * count, 0.7 * count);
        Assert.InRange(starts, 0.02 * count, 0.4 * count);
    }

    /// <summary>Only the relative motion matters, and either shape may be called A.</summary>
    [Fact]
    public void SwappingMirrorsAndAStandingShapeMayMove()
    {
        for (int i = 0; i < Budget.Count(1000); i++)
        {
            TestPair p = Generators.Pair((ulong)i, Kinds, 2);
            Vector3 motion = (p.PoseA.Position - p.PoseB.Position) * 1.5f;
            CastResult r = ConvexQuery.Cast(p.A.Shape, p.PoseA, default, p.B.Shape, p.PoseB, motion);
            CastResult swapped = ConvexQuery.Cast(p.B.Shape, p.PoseB, motion, p.A.Shape, p.PoseA, default).Swapped;
            CastResult moved = ConvexQuery.Cast(p.A.Shape, p.PoseA, -motion, p.B.Shape, p.PoseB, default);
            WarmStart warm = default;
            p.Distance();
            ConvexQuery.Distance(p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, ref warm);
            CastResult warmed = ConvexQuery.Cast(
                p.A.Shape, p.PoseA, default, p.B.Shape, p.PoseB, motion, ref warm, 1);
            double scale = 1 + Math.Max(p.A.LongestSide, p.B.LongestSide) / Math.Max(motion.Length(), 1e-3f);
            foreach (CastResult other in new[] { swapped, moved, warmed })
            {
                Assert.Equal(r.Status, other.Status);
                Assert.Equal(r.Fraction, other.Fraction, 2e-6 * scale);
            }
        }
    }

    [Theory]
    [InlineData(1e-28f)]
    [InlineData(1e28f)]
    public void AnySizeWillDo(float size)
    {
        CastResult r = ConvexQuery.Cast(
            ConvexShape.Box(new Vector3(size)), RigidPose.Identity, default, ConvexShape.Capsule(size, size),
            new RigidPose(new Vector3(0, 7 * size, 0)), new Vector3(0, -8 * size, 0));
        Assert.Equal(CastStatus.Hit, r.Status);
        Assert.Equal(0.5f, r.Fraction, 1e-6f);
        Assert.Equal(1, r.Point.Y / size, 1e-6f);
    }

    [Fact]
    public void BadInputIsInvalidAndNothingIsAllocated()
    {
        Assert.Equal(CastStatus.InvalidInput, Cast(default, Vector3.UnitX, 1).Status);
        Assert.Equal(CastStatus.InvalidInput, Cast(Cube, new Vector3(float.NaN, 0, 0), 1).Status);
        Assert.Equal(CastStatus.InvalidInput, Cast(Cube, new Vector3(0, float.PositiveInfinity, 0), 1).Status);
        Assert.Equal(CastStatus.InvalidInput, Cast(Cube, Vector3.UnitX, float.NaN).Status);
        Assert.True(float.IsNaN(Cast(default, Vector3.UnitX, 1).Fraction));
        Assert.Equal(CastStatus.None, default(CastResult).Status);
        Assert.Equal(0, Allocation.Least(() =>
        {
            for (int i = 0; i < 100; i++) Cast(Cube, new Vector3(-4, 0.1f, 0), 1);
        }));

        static CastResult Cast(ConvexShape shape, Vector3 motion, float most) => ConvexQuery.Cast(
            Cube, RigidPose.Identity, default, shape, new RigidPose(new Vector3(4, 0, 0)), motion, most);
    }

    private static DistanceResult At(TestPair p, Vector3 motionA, Vector3 motion, float fraction) =>
        ConvexQuery.Distance(
            p.A.Shape, new RigidPose(p.PoseA.Rotation, p.PoseA.Position + motionA * fraction), p.B.Shape,
            new RigidPose(p.PoseB.Rotation, p.PoseB.Position + (motion + motionA) * fraction));
}
