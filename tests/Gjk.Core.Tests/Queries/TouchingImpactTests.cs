namespace Gjk.Core.Tests.Queries;

/// <summary>Times of impact of bodies that turn and touch or overlap at the start: contacts that get deeper count from
/// the start, others are passed, and after they have ended the next one is found.</summary>
public class TouchingImpactTests
{
    private const int Looks = 300;

    private static readonly ConvexShape Floor = ConvexShape.Box(new Vector3(10, 1, 10));

    private static readonly RigidMotion Still = new(new RigidPose(new Vector3(0, -1, 0)), default);

    /// <summary>Lattice polytopes that touch, with any motion: held to signed distances along the way.</summary>
    [Fact]
    public void ATouchCountsIfItGetsDeeperBeforeItEnds()
    {
        int atStart = 0, later = 0, missed = 0, count = Budget.Count(300);
        for (int i = 0; i < count; i++)
        {
            TestPair p = TouchingPairs.Make((ulong)i);
            var rng = new Rng((ulong)(6000 + i));
            var a = new RigidMotion(p.PoseA, rng.Vector(-1, 1), rng.Vector(-2, 2));
            Vector3 velocity = rng.Vector(-2, 2) + (p.PoseB.Position - p.PoseA.Position) * rng.Float(-0.2, 0.3);
            var b = new RigidMotion(p.PoseB, velocity, rng.Below(3) == 0 ? default : rng.Vector(-4, 4));
            double tolerance = 1e-3 * p.Scale;
            CastResult r = ConvexQuery.TimeOfImpact(p.A.Shape, a, p.B.Shape, b, (float)tolerance);
            string what = $"{p} moving {a.Velocity} {a.AngularVelocity}, {b.Velocity} {b.AngularVelocity}: {r}";
            double end = r.Status == CastStatus.Hit && r.Fraction > 0 ? r.Fraction : 1, deepest = 0, widest = 0;
            for (int k = 0; k <= Looks && deepest > -0.9 * tolerance; k++)
            {
                double signed = Signed(p, a, b, end * k / Looks);
                deepest = Math.Min(deepest, signed);
                widest = Math.Max(widest, signed);
            }

            switch (r.Status)
            {
                case CastStatus.Hit when r.Fraction == 0:
                    atStart++;
                    Assert.True(deepest <= -0.9 * tolerance, $"{what}, but it gets only {-deepest} deep");
                    Assert.True(widest <= 0.1 * p.Scale, $"{what}, but before they are {widest} apart");
                    break;
                case CastStatus.Hit:
                    later++;
                    double gap = Signed(p, a, b, r.Fraction);
                    Assert.True(Math.Abs(gap) <= 1.1 * tolerance, $"{what}, but then they are {gap} apart");
                    Assert.True(deepest >= -1.1 * tolerance && widest >= 1.5 * tolerance, what);
                    break;
                default:
                    missed++;
                    Assert.True(r.Status == CastStatus.Miss && r.Fraction == 1, what);
                    Assert.True(deepest >= -1.1 * tolerance, $"{what}, but it gets {-deepest} deep");
                    break;
            }
        }

        Assert.True(Math.Min(Math.Min(atStart, 3 * later), missed) > 0.05 * count, $"{atStart} {later} {missed}");
    }

    /// <summary>With the option all that overlaps may move as long as it gets no deeper.</summary>
    [Fact]
    public void WhatGetsNoDeeperPasses()
    {
        int stopped = 0, missed = 0, count = Budget.Count(300);
        for (int i = 0; i < count; i++)
        {
            TestPair p = Generators.Pair((ulong)i, Generators.AllKinds, 1.1);
            if (!(p.Scale > 0)) continue;
            var rng = new Rng((ulong)(8000 + i));
            var a = new RigidMotion(p.PoseA, default, rng.Vector(-1, 1));
            Vector3 velocity = rng.Vector(-1, 1) + (p.PoseB.Position - p.PoseA.Position) * rng.Float(-1, 1);
            var b = new RigidMotion(p.PoseB, velocity, rng.Vector(-2, 2));
            double tolerance = 1e-3 * p.Scale, allowed = rng.Below(2) * 0.2 * p.Scale;
            CastResult r = ConvexQuery.TimeOfImpact(
                p.A.Shape, a, p.B.Shape, b, (float)tolerance, 1, CastOptions.OnlyDeeper((float)allowed));
            double limit = Math.Max(allowed, -Signed(p, a, b, 0)) + tolerance, deepest = 0;
            for (int k = 0; k <= Looks; k++) deepest = Math.Max(deepest, -Signed(p, a, b, (double)k / Looks));
            string what = $"{p} moving {a.AngularVelocity}, {b.Velocity} {b.AngularVelocity}: {r}, {deepest} {limit}";
            if (r.Status == CastStatus.Miss)
            {
                missed++;
                Assert.True(deepest <= limit + 0.2 * tolerance, what);
                continue;
            }

            stopped++;
            double turn = (a.AngularVelocity - b.AngularVelocity).Length();
            double between = (velocity.Length() + 3 * p.Scale * turn) / Looks;
            Assert.True(r.IsHit && deepest >= limit - 0.1 * tolerance - between, what);
            if (r.Status == CastStatus.OverlappingAtStart) Assert.Equal(-p.SignedDistance().Distance, r.Depth);
            else Assert.True(Math.Abs(Signed(p, a, b, r.Fraction)) <= 1.1 * tolerance, what);
        }

        Assert.True(Math.Min(stopped, missed) > 0.2 * count, $"{stopped} {missed}");
    }

    /// <summary>However much more is allowed than the bodies could get into each other, they go on.</summary>
    [Theory]
    [InlineData(1e6f)]
    [InlineData(1e15f)]
    [InlineData(1e20f)]
    [InlineData(float.MaxValue)]
    public void WhatIsAllowedMoreThanCanBePasses(float allowed)
    {
        ConvexShape[] others =
        [
            ConvexShape.Box(new Vector3(0.5f)), Floor, ConvexShape.Sphere(0.5f),
            ConvexShape.HalfSpace(Vector3.UnitY, 0.8f),
        ];
        for (int i = 0; i < 60; i++)
        {
            var rng = new Rng((ulong)i);
            ConvexShape other = others[i % others.Length], shape = ConvexShape.Capsule(0.3f, 0.4f);
            var pose = new RigidPose(rng.Rotation(), rng.Vector(-0.6f, 0.6f));
            var motion = new RigidMotion(pose, rng.Vector(-1, 1), rng.Vector(-2, 2));
            var options = CastOptions.OnlyDeeper(allowed);
            CastResult r = ConvexQuery.TimeOfImpact(other, Still, shape, motion, 0, 1, options);
            Assert.True(r.Status == CastStatus.Miss && r.Fraction == 1, $"{i}: {r}");
        }
    }

    /// <summary>Bodies that spin within each other ask for few signed distances: planes that are kept stand in for
    /// them.</summary>
    [Fact]
    public void WhatSpinsInsideAsksLittle()
    {
        QueryRecord pair = QueryRecord.Parse(
            "gjk1 ellipsoid 5.5266270637512207 5.5716376304626465 5.9605927467346191 @ 0.722093701 -0.169207484 "
            + "-0.276177078 -0.611290157 -0.87884903 0.80469346 0.815725207 ~ -0.00033002533 -0.00846943259 "
            + "0.00502429111 -2.11454296 1.3293345 2.92555523 ellipsoid 3.6024832725524902 3.5729634761810303 "
            + "5.2495298385620117 @ -0.387076348 -0.331899345 -0.64095062 0.573756993 -1.04490745 0.960144281 "
            + "0.805778325 ~ -0.395975977 0.68328923 0.2702685 2.59237289 0.342363209 2.67259431");
        CastResult r = ConvexQuery.TimeOfImpact(
            pair.A, pair.MotionA, pair.B, pair.MotionB, 0, 1, CastOptions.OnlyDeeper());
        Assert.True(r.Status == CastStatus.OverlappingAtStart && r.Iterations < 5500, $"{r} {r.Iterations}");
    }

    /// <summary>A wheel and a ball roll, and a top spins; a body that falls with a spin is stopped at once.</summary>
    [Fact]
    public void WhatRollsIsNotStopped()
    {
        Quaternion side = Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 2);
        ConvexShape wheel = ConvexShape.Cylinder(0.5f, 0.125f), ball = ConvexShape.Sphere(0.5f);
        ConvexShape cube = ConvexShape.Box(new Vector3(0.5f));
        foreach (float turn in new[] { 0.5f, 3, 6 })
        {
            Vector3 roll = new(0.5f * turn, 0, 0), rolling = new(0, 0, -turn), spin = new(0, turn, 0);
            foreach (float dy in new[] { 0, -1e-7f, 1e-7f })
            {
                Assert.Equal(CastStatus.Miss, Ask(wheel, side, dy, roll, rolling, 1e-4f).Status);
                Assert.Equal(CastStatus.Miss, Ask(ball, Quaternion.Identity, dy, roll, rolling, 1e-4f).Status);
            }

            Assert.Equal(CastStatus.Miss, Ask(ball, Quaternion.Identity, 0, roll, rolling).Status);
            Assert.Equal(CastStatus.Miss, Ask(cube, Quaternion.Identity, 0, roll, spin).Status);
            Assert.Equal(CastStatus.Miss, Ask(cube, Quaternion.Identity, 0, new(0, 9, 0), rolling).Status);
            foreach (ConvexShape shape in new[] { ball, cube })
            {
                CastResult fall = Ask(shape, Quaternion.Identity, 0, -Vector3.UnitY, spin);
                Assert.Equal((CastStatus.Hit, 0f, Vector3.UnitY), (fall.Status, fall.Fraction, fall.Normal));
            }

            Assert.Equal((CastStatus.Hit, 0f), Brief(Ask(cube, Quaternion.Identity, 0, default, rolling)));
        }

        static CastResult Ask(
            in ConvexShape shape, Quaternion rotation, float dy, Vector3 velocity, Vector3 turn, float allowed = -1) =>
            ConvexQuery.TimeOfImpact(
                Floor, Still, shape,
                new RigidMotion(new RigidPose(rotation, new Vector3(0, 0.5f + dy, 0)), velocity, turn), 0, 1,
                allowed < 0 ? default : CastOptions.OnlyDeeper(allowed));
    }

    /// <summary>A rod stands on its left end; it turns until the right one comes down: tan(angle) = 1/2.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2.5f)]
    public void WhatLeavesAContactFindsTheNextOne(float turn)
    {
        ConvexShape rod = ConvexShape.Segment(new Vector3(-2, 0, 0), new Vector3(2, 1, 0));
        CastResult down = Ask(new Vector3(0, 0, -turn)), up = Ask(new Vector3(0, 0, turn));
        Assert.Equal(CastStatus.Hit, down.Status);
        Assert.InRange(down.Fraction * turn, Math.Atan(0.5) - 1e-4, Math.Atan(0.5));
        Assert.Equal((CastStatus.Hit, 0f), Brief(up));
        Assert.Equal(CastStatus.Miss, Ask(new Vector3(0, turn, 0)).Status);
        CastResult passed = Ask(new Vector3(0, 0, -0.3f), CastOptions.OnlyDeeper(0.25f));
        Assert.Equal(CastStatus.Miss, passed.Status);
        Assert.Equal(
            Brief(down), Brief(Ask(new Vector3(0, 0, -turn), CastOptions.OnlyDeeper(0.1f))));

        CastResult Ask(Vector3 velocity, CastOptions options = default) => ConvexQuery.TimeOfImpact(
            Floor, Still, rod, new RigidMotion(RigidPose.Identity, default, velocity), 0, 1, options);
    }

    private static (CastStatus Status, float Fraction) Brief(in CastResult r) => (r.Status, r.Fraction);

    private static double Signed(TestPair p, in RigidMotion a, in RigidMotion b, double fraction) =>
        ConvexQuery.SignedDistance(p.A.Shape, At(a, fraction), p.B.Shape, At(b, fraction)).Distance;

    private static RigidPose At(in RigidMotion motion, double fraction)
    {
        Vector3 position = (Vector3)((Double3)motion.Velocity * fraction + motion.Pose.Position);
        double rate = ((Double3)motion.AngularVelocity).Length;
        if (rate == 0) return new RigidPose(motion.Pose.Rotation, position);
        QuaternionD turned = QuaternionD.About((Double3)motion.AngularVelocity * (1 / rate), rate * fraction)
            * motion.Pose.Rotation;
        return new RigidPose(
            Quaternion.Normalize(new Quaternion((float)turned.X, (float)turned.Y, (float)turned.Z, (float)turned.W)),
            position);
    }
}
