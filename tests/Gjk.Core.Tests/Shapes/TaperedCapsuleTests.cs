namespace Gjk.Core.Tests.Shapes;

/// <summary>Tapered capsules against formulas of their own, against hulls of points on them, and against what they are
/// where the balls are equal or one holds the other.</summary>
public class TaperedCapsuleTests
{
    /// <summary>Ratio to the size: the search ends within 1e-9 of a distance, and within 2e-7 of a depth; both are
    /// promised to 1e-6.</summary>
    private const double Apart = 2e-9, Deep = 4e-7;

    private static readonly RigidPose Shifted = new(Quaternion.Normalize(new(0.1f, 0.5f, -0.3f, 0.7f)), new(1, -2, 3));

    [Fact]
    public void APointIsAtTheDistanceOfTheFormula()
    {
        int inside = 0, count = Budget.Count(2000);
        for (ulong seed = 0; seed < (ulong)count; seed++)
        {
            var rng = new Rng(seed);
            Sizes a = Sizes.Any(rng);
            RigidPose pose = Generators.Pose(rng, rng.Vector(-1, 1));
            Vector3 point = pose.Position + rng.Vector(-0.4, 0.4);
            double truth = a.At(pose).Distance(point);
            if (truth < 0) inside++;
            string what = $"seed {seed}: {a.Shape}, {truth:R}";
            Check(truth, ConvexQuery.SignedDistance(a.Shape, pose, point).Distance, what);
            Check(Math.Max(truth, 0), ConvexQuery.Distance(a.Shape, pose, point).Distance, what);
            if (Math.Abs(truth) > Accuracy.FlagScale)
                Assert.True(truth < 0 == ConvexQuery.Contains(a.Shape, pose, point), what);
        }

        Assert.InRange(inside, 0.3 * count, 0.7 * count);
    }

    [Fact]
    public void APairIsAtTheDistanceOfTheFormula()
    {
        int inside = 0, count = Budget.Count(3000);
        for (ulong seed = 0; seed < (ulong)count; seed++)
        {
            var rng = new Rng(10_000 + seed);
            Sizes a = Sizes.Any(rng), b = Sizes.Any(rng);
            RigidPose poseA = Generators.Pose(rng, default), poseB = Generators.Pose(rng, rng.Vector(-0.8, 0.8));
            double truth = a.At(poseA).Distance(b.At(poseB));
            if (truth < 0) inside++;
            string what = $"seed {seed}: {a.Shape}, {b.Shape}, {truth:R}";
            Check(truth, ConvexQuery.SignedDistance(a.Shape, poseA, b.Shape, poseB).Distance, what);
            Check(Math.Max(truth, 0), ConvexQuery.Distance(a.Shape, poseA, b.Shape, poseB).Distance, what);
            if (Math.Abs(truth) > Accuracy.FlagScale)
                Assert.True(truth < 0 == ConvexQuery.Overlaps(a.Shape, poseA, b.Shape, poseB), what);
        }

        Assert.InRange(inside, 0.3 * count, 0.7 * count);
    }

    /// <summary>A hull of points on the surface lies inside the shape, by no more than the sag of its facets.</summary>
    [Fact]
    public void AFineHullIsNearlyAsFar()
    {
        const double Sag = 4e-3;
        int apart = 0, count = Budget.Count(100);
        Vector3[] ball = [.. Icosphere.InFloat(3)];
        for (ulong seed = 0; seed < (ulong)count; seed++)
        {
            var rng = new Rng(20_000 + seed);
            Sizes a = Sizes.Any(rng);
            var up = new Vector3(0, a.Half, 0);
            ConvexShape fine = ConvexShape.Mesh(
                [.. ball.Select(v => v * a.Top + up), .. ball.Select(v => v * a.Bottom - up)]);
            TestShape b = Generators.Shape(rng, Generators.AllKinds[rng.Below(Generators.AllKinds.Length)]);
            RigidPose poseA = Generators.Pose(rng, default), poseB = Generators.Pose(rng, rng.Vector(-0.9, 0.9));
            float expected = ConvexQuery.Distance(fine, poseA, b.Shape, poseB).Distance;
            float found = ConvexQuery.Distance(a.Shape, poseA, b.Shape, poseB).Distance;
            Assert.True(
                found <= expected + 1e-6 && found >= expected - Sag,
                $"seed {seed}: {a.Shape}, {b}: {found:R}, as a hull {expected:R}");
            if (found > 0) apart++;
        }

        Assert.InRange(apart, 0.3 * count, 0.7 * count);
    }

    [Fact]
    public void ARayMeetsTheBodyOfTheFormula()
    {
        int hits = 0, count = Budget.Count(1000);
        for (ulong seed = 0; seed < (ulong)count; seed++)
        {
            var rng = new Rng(30_000 + seed);
            Sizes a = Sizes.Any(rng);
            RigidPose pose = Generators.Pose(rng, rng.Vector(-1, 1));
            Vector3 from = pose.Position + rng.UnitVector() * 4, way = pose.Position + rng.Vector(-0.7, 0.7) - from;
            Double3 unit = (Double3)way * (1 / ((Double3)way).Length);
            TaperedBody body = a.At(pose);
            double truth = Meeting(t => body.Distance((Double3)from + unit * t), 20);
            RayCastResult hit = ConvexQuery.RayCast(a.Shape, pose, from, way);
            Assert.True(
                hit.Status == CastStatus.Hit ? Math.Abs(hit.Distance - truth) <= 1.2e-7 * truth : truth >= 20,
                $"seed {seed}: {a.Shape}, {hit}, truly {truth:R}");
            if (hit.Status == CastStatus.Hit) hits++;
        }

        Assert.InRange(hits, 0.3 * count, 0.7 * count);
    }

    [Fact]
    public void ACastMeetsTheBodyOfTheFormula()
    {
        int hits = 0, count = Budget.Count(500);
        for (ulong seed = 0; seed < (ulong)count; seed++)
        {
            var rng = new Rng(40_000 + seed);
            Sizes a = Sizes.Any(rng), b = Sizes.Any(rng);
            RigidPose pose = Generators.Pose(rng, default), still = Generators.Pose(rng, rng.UnitVector() * 4);
            Vector3 motion = still.Position + rng.Vector(-1.5, 1.5);
            TaperedBody moving = a.At(pose), target = b.At(still);
            double way = ((Double3)motion).Length;
            double truth = Meeting(t => target.Distance(moving.Moved((Double3)motion * (t / way))), way);
            CastResult hit = ConvexQuery.Cast(a.Shape, pose, motion, b.Shape, still, default);
            Assert.True(
                hit.Status == CastStatus.Hit ? Math.Abs(hit.Fraction * way - truth) <= 2e-7 * way : truth >= way,
                $"seed {seed}: {a.Shape}, {b.Shape}, {hit}, truly {truth / way:R}");
            if (hit.Status == CastStatus.Hit) hits++;
        }

        Assert.InRange(hits, 0.3 * count, 0.7 * count);
    }

    /// <summary>Their core is a segment with the same vertices, so the bits are the same.</summary>
    [Fact]
    public void EqualBallsAreACapsule()
    {
        for (ulong seed = 0; seed < 300; seed++)
        {
            TestPair p = Generators.Pair(50_000 + seed, Generators.AllKinds);
            float radius = new Rng(seed).Float(0, 1);
            ConvexShape tapered = ConvexShape.TaperedCapsule(radius, radius, 0.7f);
            ConvexShape capsule = ConvexShape.Capsule(radius, 0.7f);
            Assert.Equal(
                ResultBits.Of(ConvexQuery.SignedDistance(capsule, p.PoseA, p.B.Shape, p.PoseB)),
                ResultBits.Of(ConvexQuery.SignedDistance(tapered, p.PoseA, p.B.Shape, p.PoseB)));
            Assert.Equal(
                ResultBits.Of(ConvexQuery.Distance(p.B.Shape, p.PoseB, capsule, p.PoseA)),
                ResultBits.Of(ConvexQuery.Distance(p.B.Shape, p.PoseB, tapered, p.PoseA)));
        }
    }

    /// <summary>Also where it only just does, and where both are about one centre.</summary>
    [Theory]
    [InlineData(2, 0.5f, 0.7f, 1)]
    [InlineData(0.5f, 2, 0.7f, -1)]
    [InlineData(2, 0.5f, 0.75f, 1)]
    [InlineData(0.25f, 1, 0, 0)]
    [InlineData(1, 1, 0, 0)]
    [InlineData(0, 0, 0, 0)]
    public void ABallThatHoldsTheOtherIsASphere(float top, float bottom, float half, int side)
    {
        ConvexShape tapered = ConvexShape.TaperedCapsule(top, bottom, half);
        Assert.Equal(new Double3(0, side * (double)half, 0), tapered.Center);
        Assert.Equal(tapered.Margin, tapered.BoundingRadius);
        ConvexShape sphere = ConvexShape.Sphere(Math.Max(top, bottom))
            .Placed(new RigidPose(new Vector3(0, side * half, 0)));
        for (ulong seed = 0; seed < 200; seed++)
        {
            TestPair p = Generators.Pair(60_000 + seed, [.. Generators.PolytopeKinds]);
            float expected = ConvexQuery.SignedDistance(sphere, p.PoseA, p.B.Shape, p.PoseB).Distance;
            float found = ConvexQuery.SignedDistance(tapered, p.PoseA, p.B.Shape, p.PoseB).Distance;
            Assert.True(
                Math.Abs(found - (double)expected) <= Accuracy.Band(Math.Abs(expected), 4),
                $"seed {seed}: {found:R}, of the sphere {expected:R}");
            RayCastResult hit = ConvexQuery.RayCast(tapered, p.PoseA, p.PoseB.Position, Vector3.UnitY);
            Assert.Equal(ConvexQuery.RayCast(sphere, p.PoseA, p.PoseB.Position, Vector3.UnitY).Status, hit.Status);
        }
    }

    [Fact]
    public void TheSameNumbersAreEqual()
    {
        var one = ConvexShape.TaperedCapsule(0.5f, 0.25f, 1);
        Assert.Equal(one, ConvexShape.TaperedCapsule(0.5f, 0.25f, 1));
        Assert.Equal(one.GetHashCode(), ConvexShape.TaperedCapsule(0.5f, 0.25f, 1).GetHashCode());
        Assert.NotEqual(one, ConvexShape.TaperedCapsule(0.25f, 0.5f, 1));
        Assert.Equal("tapered capsule, radii 0.5 and 0.25, half height 1", one.ToString());
        ConvexShape decorated = one.Scaled(new Vector3(1, -2, 3)).Rounded(0.1f).Placed(Shifted);
        foreach (ConvexShape shape in new[] { one, decorated, ConvexShape.TaperedCapsule(2, 0.5f, 0.25f) })
        {
            var record = new QueryRecord(shape, Shifted, one, Shifted);
            Assert.Equal(shape, QueryRecord.Parse(record.ToString()).A);
        }
    }

    [Fact]
    public void TheBoundsAreTheBalls()
    {
        Aabb box = new ShapeBounds(ConvexShape.TaperedCapsule(0.5f, 0.25f, 1)).BoxAt(RigidPose.Identity);
        Assert.Equal(0, Vector3.Distance(new Vector3(-0.5f, -1.25f, -0.5f), box.Min), 1e-6f);
        Assert.Equal(0, Vector3.Distance(new Vector3(0.5f, 1.5f, 0.5f), box.Max), 1e-6f);
    }

    private static void Check(double truth, double found, string what)
    {
        double allowed = truth > 0 ? Accuracy.DistanceRatio * truth + Apart * 3 : Deep * 3;
        Assert.True(Math.Abs(found - truth) <= allowed, $"{what}: found {found:R}");
    }

    /// <summary>Where a way first has the distance 0, by steps that are no longer than the distance.</summary>
    private static double Meeting(Func<double, double> distance, double reach)
    {
        double way = 0, step = 1;
        while (way < reach && step > 1e-13) way += step = distance(way);
        return way;
    }

    /// <summary>With unequal balls, nearly equal ones, one that the other nearly holds, and tips.</summary>
    private readonly record struct Sizes(float Top, float Bottom, float Half)
    {
        public ConvexShape Shape => ConvexShape.TaperedCapsule(Top, Bottom, Half);

        public static Sizes Any(Rng rng)
        {
            ConvexShape shape = Generators.Shape(rng, "taperedCapsule").Shape;
            return new(shape.TopRadius, shape.BottomRadius, shape.HalfHeight);
        }

        public TaperedBody At(in RigidPose pose) => new(Top, Bottom, Half, pose);
    }
}
