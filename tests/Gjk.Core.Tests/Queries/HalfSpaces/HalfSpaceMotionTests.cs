namespace Gjk.Core.Tests.Queries;

/// <summary>When what moves meets a half-space: casts and rays in closed form, and times of impact.</summary>
public class HalfSpaceMotionTests
{
    private static readonly ConvexShape Floor = ConvexShape.HalfSpace(Vector3.UnitY, 0);
    private static readonly ConvexShape Block = ConvexShape.Box(new Vector3(256, 128, 256));
    private static readonly RigidPose UnderFloor = new(new Vector3(0, -128, 0));

    public static TheoryData<string> Kinds =>
        [.. Generators.PolytopeKinds, .. Generators.CurvedKinds, .. Generators.LaterKinds];

    [Fact]
    public void AFractionIsTheGapOverTheSpeed()
    {
        ConvexShape ball = ConvexShape.Sphere(0.5f);
        var at = new RigidPose(new Vector3(7, 2, 0));
        var way = new Vector3(8, -4, 0);
        CastResult hit = ConvexQuery.Cast(Floor, RigidPose.Identity, default, ball, at, way);
        Assert.Equal((CastStatus.Hit, 0.375f), (hit.Status, hit.Fraction));
        Assert.Equal((new Vector3(10, 0, 0), Vector3.UnitY), (hit.Point, hit.Normal));
        hit = ConvexQuery.Cast(ball, at, way, Floor, RigidPose.Identity, default);
        Assert.Equal((CastStatus.Hit, 0.375f), (hit.Status, hit.Fraction));
        Assert.Equal((new Vector3(10, 0, 0), -Vector3.UnitY), (hit.Point, hit.Normal));
        hit = ConvexQuery.Cast(Floor, RigidPose.Identity, new Vector3(0, 4, 0), ball, at, default);
        Assert.Equal((0.375f, new Vector3(7, 1.5f, 0)), (hit.Fraction, hit.Point));
        Assert.Equal(
            CastStatus.Miss, ConvexQuery.Cast(Floor, RigidPose.Identity, default, ball, at, way, 0.37f).Status);
        Assert.Equal(
            0.375f, ConvexQuery.Cast(Floor, RigidPose.Identity, default, ball, at, way, 0.375f).Fraction);
        Assert.Equal(CastStatus.Miss, ConvexQuery.Cast(Floor, RigidPose.Identity, default, ball, at, -way).Status);
        Assert.Equal(
            CastStatus.InvalidInput,
            ConvexQuery.Cast(Floor, RigidPose.Identity, default, ball, at, way, float.NaN).Status);
    }

    [Fact]
    public void WhatTouchesAtTheStartHitsOnlyIfItGoesIn()
    {
        ConvexShape box = ConvexShape.Box(new Vector3(1));
        var on = new RigidPose(new Vector3(50, 1, 3));
        (Vector3 Way, CastStatus Status)[] motions =
        [
            (new(0, -1, 0), CastStatus.Hit), (new(3, 0, 1), CastStatus.Miss), (new(0, 1, 0), CastStatus.Miss),
            (Vector3.Zero, CastStatus.Miss),
        ];
        foreach ((Vector3 way, CastStatus status) in motions)
        {
            CastResult cast = ConvexQuery.Cast(Floor, RigidPose.Identity, default, box, on, way);
            Assert.Equal(status, cast.Status);
            if (status == CastStatus.Hit) Assert.Equal((0f, Vector3.UnitY), (cast.Fraction, cast.Normal));
        }

        var deep = new RigidPose(new Vector3(50, 0.75f, 3));
        CastResult start = ConvexQuery.Cast(Floor, RigidPose.Identity, default, box, deep, Vector3.UnitX);
        Assert.Equal((CastStatus.OverlappingAtStart, 0.25f), (start.Status, start.Depth));
        Assert.Equal(Vector3.UnitY, start.Normal);
        CastOptions deeper = CastOptions.OnlyDeeper(0.5f);
        Assert.Equal(
            CastStatus.Miss, Cast(box, deep, new Vector3(1, -0.1f, 0), deeper).Status);
        Assert.Equal(
            CastStatus.OverlappingAtStart, Cast(box, deep, new Vector3(1, -0.5f, 0), deeper).Status);
        Assert.Equal(CastStatus.Miss, Cast(box, on, new Vector3(1, -0.4f, 0), deeper).Status);
        Assert.Equal(CastStatus.Hit, Cast(box, on, new Vector3(1, -0.6f, 0), deeper).Status);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void CastsAreThoseAgainstALargeBox(string kind)
    {
        int hits = 0;
        for (ulong seed = 1; seed <= 150; seed++)
        {
            var rng = new Rng(seed);
            ConvexShape shape = Generators.Shape(rng, kind).Shape;
            var pose = new RigidPose(rng.Rotation(), rng.Vector(-3, 3) + new Vector3(0, 2.5f, 0));
            Vector3 way = rng.Vector(-5, 5);
            CastOptions options = rng.Below(2) == 0 ? default : CastOptions.OnlyDeeper(rng.Float(0.05, 2));
            CastResult found = Cast(shape, pose, way, options);
            CastResult expected = ConvexQuery.Cast(Block, UnderFloor, default, shape, pose, way, 1, options);
            string message = $"{kind}, seed {seed}: {found} for {expected}";
            Assert.True(found.Status == expected.Status, message);
            hits += found.IsHit ? 1 : 0;
            if (!found.IsHit) continue;
            Assert.Equal(expected.Fraction, found.Fraction, 2e-6f);
            Assert.Equal(expected.Depth, found.Depth, 2e-5f);
            Assert.Equal(Vector3.UnitY, found.Normal);
        }

        Assert.InRange(hits, 15, 130);
    }

    [Fact]
    public void ARayMeetsThePlane()
    {
        var pose = new RigidPose(new Vector3(0, 1, 0));
        RayCastResult hit = ConvexQuery.RayCast(Floor, pose, new Vector3(0, 4, 0), new Vector3(4, -3, 0));
        Assert.Equal((CastStatus.Hit, 5f), (hit.Status, hit.Distance));
        Assert.Equal((new Vector3(4, 1, 0), Vector3.UnitY), (hit.Point, hit.Normal));
        Assert.Equal(CastStatus.Hit, Ray(pose, new(0, 4, 0), new(4, -3, 0), 5).Status);
        Assert.Equal(CastStatus.Miss, Ray(pose, new(0, 4, 0), new(4, -3, 0), 4.99f).Status);
        Assert.Equal(CastStatus.Miss, Ray(pose, new(0, 4, 0), new(4, 3, 0)).Status);
        Assert.Equal(CastStatus.Miss, Ray(pose, new(0, 4, 0), new(4, 0, 0)).Status);
        RayCastResult inside = Ray(pose, new(0, -1, 0), Vector3.UnitY);
        Assert.Equal((CastStatus.OverlappingAtStart, 2f), (inside.Status, inside.Depth));
        Assert.Equal((CastStatus.Hit, 0f), (Ray(pose, new(3, 1, 0), new(1, -1, 0)).Status, Ray(
            pose, new(3, 1, 0), new(1, -1, 0)).Distance));
        Assert.Equal(CastStatus.Miss, Ray(pose, new(3, 1, 0), Vector3.UnitX).Status);
        Assert.Equal(CastStatus.InvalidInput, Ray(default, new(3, 1, 0), Vector3.UnitX).Status);
        Assert.Equal(new Vector3(5, 1, 6), ConvexQuery.ClosestPoint(Floor, pose, new Vector3(5, 9, 6)));
        Assert.True(ConvexQuery.Contains(Floor, pose, new Vector3(5, 1, 6)));
        Assert.False(ConvexQuery.Contains(Floor, pose, new Vector3(5, 1.0001f, 6)));
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void TimesOfImpactAreThoseAgainstALargeBox(string kind)
    {
        int hits = 0;
        for (ulong seed = 1; seed <= 60; seed++)
        {
            var rng = new Rng(seed);
            ConvexShape shape = Generators.Shape(rng, kind).Shape;
            var pose = new RigidPose(rng.Rotation(), rng.Vector(-3, 3) + new Vector3(0, 3, 0));
            var motion = new RigidMotion(pose, rng.Vector(-5, 5), rng.UnitVector() * rng.Float(0, 9));
            CastOptions options = rng.Below(3) > 0 ? default : CastOptions.OnlyDeeper(rng.Float(0.05, 1));
            var still = new RigidMotion(RigidPose.Identity, default);
            CastResult found = ConvexQuery.TimeOfImpact(Floor, still, shape, motion, 0, 1, options);
            CastResult expected = ConvexQuery.TimeOfImpact(
                Block, new RigidMotion(UnderFloor, default), shape, motion, 1e-4f, 1, options);
            string message = $"{kind}, seed {seed}: {found} for {expected}";
            Assert.True(found.Status == expected.Status || IsClose(shape, motion, options), message);
            if (found.Status != expected.Status) continue;
            hits += found.IsHit ? 1 : 0;
            if (!found.IsHit) continue;
            Assert.True(Math.Abs(found.Fraction - expected.Fraction) < 2e-3, message);
            Assert.Equal(expected.Depth, found.Depth, 2e-5f);
            CastResult swapped = ConvexQuery.TimeOfImpact(shape, motion, Floor, still, 0, 1, options);
            Assert.Equal((found.Fraction, found.Status), (swapped.Fraction, swapped.Status));
            Assert.Equal(Vector3.UnitY, -swapped.Normal);
        }

        Assert.InRange(hits, 8, 58);
    }

    /// <summary>A half-space that turns: at the fraction they are within the tolerance, and before apart.</summary>
    [Fact]
    public void AHalfSpaceThatTurnsIsMetInTime()
    {
        const float tolerance = 1e-3f;
        int hits = 0;
        for (ulong seed = 1; seed <= 300; seed++)
        {
            var rng = new Rng(seed);
            string[] kinds = Generators.PolytopeKinds;
            ConvexShape shape = Generators.Shape(rng, kinds[rng.Below(kinds.Length)]).Shape;
            ConvexShape plane = ConvexShape.HalfSpace(rng.UnitVector(), rng.Float(-1, 1));
            RigidMotion a = Motion(rng), b = Motion(rng);
            if (!(ConvexQuery.SignedDistance(plane, a.Pose, shape, b.Pose).Distance > 0)) continue;
            CastResult found = ConvexQuery.TimeOfImpact(plane, a, shape, b, tolerance);
            Assert.True(found.Status is CastStatus.Hit or CastStatus.Miss, $"seed {seed}: {found}");
            hits += found.IsHit ? 1 : 0;
            float end = found.IsHit ? found.Fraction : 1;
            for (int i = 0; i < 64; i++)
            {
                float f = end * i / 64;
                DistanceResult before = ConvexQuery.SignedDistance(plane, At(a, f), shape, At(b, f));
                Assert.True(before.Distance > -1e-5f, $"seed {seed}: {before} at {f}");
            }

            if (!found.IsHit) continue;
            DistanceResult at = ConvexQuery.SignedDistance(plane, At(a, end), shape, At(b, end));
            Assert.True(at.Distance < tolerance + 2e-5f, $"seed {seed}: {at}");
            Assert.True((at.PointA - found.Point).Length() < 1e-2f * (1 + at.PointA.Length()), $"seed {seed}");
            Assert.True((at.Normal - found.Normal).Length() < 1e-4f, $"seed {seed}");
        }

        Assert.InRange(hits, 40, 250);
    }

    /// <summary>A wheel rolls along a floor without a contact that counts, for many turns.</summary>
    [Fact]
    public void AWheelRolls()
    {
        ConvexShape wheel = ConvexShape.Cylinder(0.5f, 0.1f);
        var upright = Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 2);
        var motion = new RigidMotion(new(upright, new(0, 0.5f, 0)), new(20, 0, 0), new(0, 0, -40));
        var still = new RigidMotion(RigidPose.Identity, default);
        CastResult found = ConvexQuery.TimeOfImpact(Floor, still, wheel, motion, 0, 1, CastOptions.OnlyDeeper(0.01f));
        Assert.Equal(CastStatus.Miss, found.Status);
        Assert.True(found.Iterations < 200, $"{found.Iterations} supports");
    }

    /// <summary>Whether a motion gets about as deep as it may, so that tolerances decide.</summary>
    private static bool IsClose(in ConvexShape shape, in RigidMotion motion, in CastOptions options)
    {
        double least = double.PositiveInfinity, start = 0;
        for (int i = 4096; i >= 0; i--)
        {
            start = ConvexQuery.SignedDistance(Floor, RigidPose.Identity, shape, At(motion, i / 4096f)).Distance;
            least = Math.Min(least, start);
        }

        double limit = options.PassesShallow ? Math.Max(options.AllowedDepth, -start) : 0;
        return Math.Abs(least + limit) < 1e-3;
    }

    private static RigidMotion Motion(Rng rng) => new(
        new(rng.Rotation(), rng.Vector(-4, 4)), rng.Vector(-3, 3),
        rng.Below(4) == 0 ? default : rng.UnitVector() * rng.Float(0.1, 4));

    private static RigidPose At(in RigidMotion motion, float f)
    {
        float angle = motion.AngularVelocity.Length();
        Quaternion turn = angle > 0
            ? Quaternion.CreateFromAxisAngle(motion.AngularVelocity / angle, angle * f)
            : Quaternion.Identity;
        return new RigidPose(
            Quaternion.Normalize(turn * motion.Pose.Rotation), motion.Pose.Position + motion.Velocity * f);
    }

    private static CastResult Cast(in ConvexShape shape, in RigidPose pose, Vector3 way, in CastOptions options) =>
        ConvexQuery.Cast(Floor, RigidPose.Identity, default, shape, pose, way, 1, options);

    private static RayCastResult Ray(
        in RigidPose pose, Vector3 origin, Vector3 direction, float most = float.PositiveInfinity) =>
        ConvexQuery.RayCast(Floor, pose, origin, direction, most);
}
