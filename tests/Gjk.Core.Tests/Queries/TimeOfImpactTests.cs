namespace Gjk.Core.Tests.Queries;

/// <summary>Times of impact against distances along the way, and what holds of any.</summary>
public class TimeOfImpactTests
{
    private static readonly ConvexShape Cube = ConvexShape.Box(Vector3.One);

    public static TheoryData<string> Families => [.. MotionFamilies.Names];

    /// <summary>The promise: no fraction is later than the first contact, and at none is the gap above the tolerance.
    /// Some ten thousand motions with GJK_LONG=1.</summary>
    [Theory]
    [MemberData(nameof(Families))]
    public void NoFractionIsLateAndNoGapIsAboveTheTolerance(string family)
    {
        int count = Budget.Count(6) + 14, hits = 0;
        for (int i = 0; i < count; i++)
        {
            MotionPair p = MotionFamilies.Pair(family, (ulong)i);
            if (i % 3 == 1) p = p.Swapped;
            if (i % 5 == 2) p = p with { Tolerance = (float)(p.Scale * (i % 2 == 0 ? 1e-3 : 1e-7)) };
            CastResult r = p.Ask();
            Assert.True(MotionJudge.Fault(p, r) is not { } fault, $"{p}: {r}, but {MotionJudge.Fault(p, r)}");
            if (r.Status == CastStatus.Hit) hits++;
        }

        Assert.InRange(hits, 1, count);
    }

    /// <summary>The judge itself finds what is late, early, and missed.</summary>
    [Fact]
    public void WrongAnswersAreFound()
    {
        int found = 0;
        for (ulong i = 0; i < 20; i++)
        {
            MotionPair p = MotionFamilies.Pair("boxes", i);
            CastResult r = p.Ask();
            if (r.Status != CastStatus.Hit || !(r.Fraction is > 0.01f and < 0.9f)) continue;
            Assert.NotNull(MotionJudge.Fault(p, With(CastStatus.Hit, r.Fraction * 0.99f)));
            Assert.NotNull(MotionJudge.Fault(p, With(CastStatus.Hit, r.Fraction * 1.01f)));
            Assert.NotNull(MotionJudge.Fault(p, With(CastStatus.Miss, 1)));
            Assert.NotNull(MotionJudge.Fault(p, With(CastStatus.OverlappingAtStart, 0)));
            found++;
        }

        Assert.InRange(found, 5, 20);

        static CastResult With(CastStatus status, float fraction) => new(status, fraction, default, default, 0);
    }

    /// <summary>A rod turns about its middle until its side meets a ball: 2 cos(angle) = 0.1 + 0.5.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(9)]
    public void ARodTurnsIntoABall(float maxFraction)
    {
        var rod = ConvexShape.Box(new Vector3(2, 0.1f, 0.1f));
        var turning = new RigidMotion(RigidPose.Identity, default, new Vector3(0, 0, (float)(Math.PI / 2)));
        RigidMotion ball = At(new Vector3(0, 2, 0));
        CastResult r = ConvexQuery.TimeOfImpact(rod, turning, ConvexShape.Sphere(0.5f), ball, 1e-5f, maxFraction);
        double angle = Math.Acos(0.3), exact = angle / (Math.PI / 2);
        Assert.Equal(CastStatus.Hit, r.Status);
        Assert.InRange(r.Fraction, exact - 1e-5, exact);
        var normal = new Vector3((float)-Math.Sin(angle), (float)Math.Cos(angle), 0);
        Assert.True((r.Normal - normal).Length() < 1e-4f, $"{r}");
        Assert.True((r.Point - (new Vector3(0, 2, 0) - normal * 0.5f)).Length() < 1e-4f, $"{r}");
    }

    [Theory]
    [InlineData(1.5f)]
    [InlineData(0.25f)]
    public void WhatOverlapsAtTheStartSaysSo(float y)
    {
        CastResult r = Turning(y, new Vector3(0, 9, 0));
        Assert.Equal(
            (CastStatus.OverlappingAtStart, 0f, Vector3.UnitY, 2 - y), (r.Status, r.Fraction, r.Normal, r.Depth));
        Assert.InRange(r.Point.Y, -1, 1);
        r = ConvexQuery.TimeOfImpact(
            ConvexShape.Sphere(1), At(default, Vector3.One), ConvexShape.Sphere(1), At(new Vector3(1.5f, 0, 0)));
        Assert.Equal((CastStatus.OverlappingAtStart, Vector3.UnitX, 0.5f), (r.Status, r.Normal, r.Depth));
        Assert.InRange(r.Point.X, 0.5f, 1);
    }

    /// <summary>Within the tolerance what comes nearer hits at once, and what parts does not.</summary>
    [Fact]
    public void WhatIsNearAtTheStartHitsUnlessItParts()
    {
        CastResult near = Turning(2.000002f, new Vector3(0, -1, 0));
        Assert.Equal((CastStatus.Hit, 0f, Vector3.UnitY), (near.Status, near.Fraction, near.Normal));
        Assert.Equal(CastStatus.Miss, Turning(2.000002f, new Vector3(0, 9, 0)).Status);
        Assert.Equal(CastStatus.Hit, Turning(2.1f, new Vector3(0, -1, 0)).Status);

        // What has just hit, and goes back, is free.
        CastResult back = ConvexQuery.TimeOfImpact(
            Cube, At(default), Cube, new RigidMotion(
                new RigidPose(Quaternion.CreateFromAxisAngle(Vector3.UnitZ, 0.3f), new Vector3(0, 2.25088f, 0)),
                new Vector3(0, 2, 0), new Vector3(0, 0, 1)));
        Assert.Equal(CastStatus.Miss, back.Status);
    }

    /// <summary>Without turns it is a cast, and its fraction the float before.</summary>
    [Fact]
    public void WhatDoesNotTurnIsCast()
    {
        int hits = 0;
        for (ulong i = 0; i < 200; i++)
        {
            TestPair p = Generators.Pair(i, Generators.AllKinds, 2);
            Vector3 motion = (p.PoseA.Position - p.PoseB.Position) * 1.5f;
            CastResult cast = ConvexQuery.Cast(p.A.Shape, p.PoseA, Vector3.One, p.B.Shape, p.PoseB, motion);
            CastResult impact = ConvexQuery.TimeOfImpact(
                p.A.Shape, new RigidMotion(p.PoseA, Vector3.One), p.B.Shape, new RigidMotion(p.PoseB, motion));
            Assert.Equal((cast.Status, cast.Normal), (impact.Status, impact.Normal));
            if (cast.Status != CastStatus.Hit || cast.Fraction == 0) continue;
            Assert.Equal(MathF.BitDecrement(cast.Fraction), impact.Fraction);
            hits++;
        }

        Assert.InRange(hits, 40, 180);
    }

    /// <summary>A wheel that turns ten times above a floor: its own tilts would take thousands of steps to tell
    /// apart.</summary>
    [Theory]
    [InlineData(0.1f)]
    [InlineData(1e-3f)]
    [InlineData(5e-4f)]
    public void AWheelPassesAFloor(float gap)
    {
        TestShape floor = TestShape.Box(new Vector3(10, 1, 10)), wheel = TestShape.Cylinder(1, 0.3f);
        TestShape prism = TestShape.Mesh(Clouds.Prism(64, 1, 0.5f));
        foreach (TestShape s in new[] { wheel, prism, TestShape.Ellipsoid(new Vector3(1, 0.4f, 1)) })
        {
            var upright = Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 2);
            var p = new MotionPair(
                $"wheel {gap}", floor, At(new Vector3(0, -1, 0)), s, new RigidMotion(
                    new RigidPose(upright, new Vector3(-3, 1 + gap, 0)), new Vector3(6, 0, 0),
                    new Vector3(0, 0, -62.8f)));
            Assert.Equal(CastStatus.Miss, p.Ask().Status);
            Assert.Equal(CastStatus.Miss, p.Swapped.Ask().Status);
        }
    }

    /// <summary>Lengths of any size, by powers of two, which round nothing: the same fraction.</summary>
    [Theory]
    [InlineData(-90)]
    [InlineData(-40)]
    [InlineData(40)]
    [InlineData(90)]
    public void AnySizeWillDo(int exponent)
    {
        foreach (string family in new[] { "boxes", "hulls", "needles", "cylinders", "offCentre" })
        {
            for (ulong i = 0; i < 20; i++)
            {
                MotionPair p = MotionFamilies.Pair(family, i);
                CastResult r = p.Ask(), other = p.Resized(MathF.ScaleB(1, exponent)).Ask();
                Assert.True(
                    r.Status == other.Status && Math.Abs(r.Fraction - other.Fraction) * p.Speed <= p.Promised,
                    $"{p}: {r}, but resized {other}");
            }
        }
    }

    /// <summary>Far from the origin, on a grid that floats hold there.</summary>
    [Fact]
    public void WhereTheWorldBeginsDoesNotMatter()
    {
        for (ulong i = 0; i < 100; i++)
        {
            MotionPair p = MotionFamilies.Pair("mixed", i);
            p = p with { MotionA = OnGrid(p.MotionA), MotionB = OnGrid(p.MotionB) };
            CastResult r = p.Ask(), far = p.Shifted(new Vector3(8192, -4096, 16384)).Ask();
            Assert.Equal((r.Status, r.Fraction, r.Normal), (far.Status, far.Fraction, far.Normal));
        }

        static RigidMotion OnGrid(in RigidMotion m) => new(
            new RigidPose(m.Pose.Rotation, Round(m.Pose.Position)), m.Velocity, m.AngularVelocity);

        static Vector3 Round(Vector3 v) => new(Grid(v.X), Grid(v.Y), Grid(v.Z));
        static float Grid(float x) => MathF.Round(x * 128) / 128;
    }

    /// <summary>The same bits on every target and runtime: sines are the library's own. If a change of them is meant,
    /// put the new number here.</summary>
    [Fact]
    public void TheImpactsKeepTheirBits()
    {
        ulong hash = 0;
        for (ulong i = 0; i < 400; i++)
        {
            var rng = new Rng(i);
            TestShape a = Generators.Shape(rng, "box"), b = Generators.Shape(rng, i % 2 == 0 ? "hull" : "capsule");
            var motionA = new RigidMotion(Pose(rng, default), rng.Vector(-1, 1), rng.Vector(-9, 9));
            Vector3 from = rng.Vector(-4, 4);
            var motionB = new RigidMotion(Pose(rng, from), -from + rng.Vector(-1, 1), rng.Vector(-9, 9));
            CastResult r = ConvexQuery.TimeOfImpact(a.Shape, motionA, b.Shape, motionB);
            foreach (float x in new[] { r.Fraction, r.Point.X, r.Point.Y, r.Normal.Z })
                hash = hash * 31 + (float.IsNaN(x) ? 1UL : (uint)BitConverter.SingleToInt32Bits(x + 0f));
        }

        Assert.Equal(1187862534719562796UL, hash);

        static RigidPose Pose(Rng rng, Vector3 position) =>
            new(Quaternion.Normalize(new Quaternion(rng.Vector(-1, 1), 2)), position);
    }

    /// <summary>A warm start may come from anywhere; the promise holds.</summary>
    [Fact]
    public void WarmStartsKeepThePromise()
    {
        WarmStart warm = default;
        for (ulong i = 0; i < 100; i++)
        {
            MotionPair p = MotionFamilies.Pair(MotionFamilies.Names[i % 11], i / 3);
            CastResult r = ConvexQuery.TimeOfImpact(p.A.Shape, p.MotionA, p.B.Shape, p.MotionB, ref warm, 0, 1);
            Assert.True(MotionJudge.Fault(p, r) is null, $"{p}: {r}, but {MotionJudge.Fault(p, r)}");
        }
    }

    private static CastResult Turning(float y, Vector3 velocity) => ConvexQuery.TimeOfImpact(
        Cube, At(default), Cube, new RigidMotion(
            new RigidPose(new Vector3(0, y, 0)), velocity, new Vector3(0, 1, 0)));

    private static RigidMotion At(Vector3 position, Vector3 turn = default) =>
        new(new RigidPose(position), default, turn);
}
