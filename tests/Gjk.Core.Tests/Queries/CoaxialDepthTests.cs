namespace Gjk.Core.Tests.Queries;

/// <summary>Round shapes about one axis, or nearly: a pin in its hole, a point on the axis of a cone, two equal
/// cylinders in one place. All ways out around the axis are equally long, and the search for the shortest one ended
/// without an answer.</summary>
public class CoaxialDepthTests
{
    /// <summary>Supports that no such pair needs but two balls about one centre.</summary>
    private const int Few = 400;

    private static readonly string[] RoundKinds =
    [
        "cylinder", "cone", "spheroid", "ball", "capsule", "sphere", "point", "rounded", "scaled", "placed",
    ];

    [Fact]
    public void APinInItsHole()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(200); seed++)
        {
            var rng = new Rng(61_000 + seed);
            float r = rng.Float(0.1, 1), s = rng.Float(0.1, 1), h = rng.Float(0.1, 2), k = rng.Float(0.1, 2);
            Quaternion q = rng.Rotation();
            Vector3 axis = Vector3.Transform(Vector3.UnitY, q), at = rng.Vector(-5, 5);
            float shift = seed % 2 == 0 ? 0 : rng.Float(-0.3, 0.3) * Math.Min(h, k);
            Quaternion turned = (seed % 4) switch
            {
                0 => q,
                1 => q * Quaternion.CreateFromAxisAngle(Vector3.UnitY, rng.Float(0, 6)),
                2 => q * Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI),
                _ => -q,
            };
            var pair = new TestPair(
                $"seed {seed}", TestShape.Cylinder(r, h), new RigidPose(q, at), TestShape.Cylinder(s, k),
                new RigidPose(turned, at + axis * shift));
            double depth = Math.Min((double)r + s, (double)h + k - Math.Abs(shift));
            AssertDepth(pair, depth, RoundingOf(pair.PoseB.Position));
        }
    }

    [Fact]
    public void TwoEqualCylindersInOnePlace()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(100); seed++)
        {
            var rng = new Rng(62_000 + seed);
            float r = rng.Float(0.1, 1), h = rng.Float(0.1, 2);
            RigidPose pose = Generators.Pose(rng, rng.Vector(-5, 5));
            TestShape cylinder = TestShape.Cylinder(r, h);
            AssertDepth(new TestPair($"seed {seed}", cylinder, pose, cylinder, pose), 2.0 * Math.Min(r, h));
        }
    }

    [Fact]
    public void PointsOnTheAxes()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(500); seed++)
        {
            var rng = new Rng(63_000 + seed);
            float r = rng.Float(0.1, 1), h = rng.Float(0.1, 2), y = rng.Float(-0.99, 0.99) * h;
            var at = new RigidPose(new Vector3(0, y, 0));
            AssertDepth(
                new TestPair($"seed {seed}", TestShape.Cylinder(r, h), RigidPose.Identity, TestShape.Point(), at),
                Math.Min(r, h - Math.Abs(y)));
            double slant = Math.Sqrt(r * r + 4.0 * h * h), toSide = (h - (double)y) * r / slant;
            AssertDepth(
                new TestPair($"seed {seed}", TestShape.Cone(r, h), RigidPose.Identity, TestShape.Point(), at),
                Math.Min(toSide, (double)y + h));
            AssertCheapest(
                new TestPair(
                    $"seed {seed}", TestShape.Ellipsoid(new(r, h, rng.Float(0.1, 1))), RigidPose.Identity,
                    TestShape.Sphere(rng.Float(0.1, 1)), at),
                seed);
        }
    }

    /// <summary>Coaxial, parallel and nearly so, by every way that a round shape can be written.</summary>
    [Fact]
    public void NoWayOutIsShorter()
    {
        int inPlane = 0, count = Budget.Count(500);
        for (ulong seed = 0; seed < (ulong)count; seed++)
        {
            TestPair pair = Round(seed);
            AssertCheapest(pair, seed);
            if (pair.SignedDistance() is { IsOverlapping: true, Iterations: < Few }) inPlane++;
        }

        Assert.InRange(inPlane, 0.7 * count, count);
    }

    [Fact]
    public void WarmAndSwappedQueriesAgree()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(200); seed++)
        {
            TestPair pair = Round(seed);
            var warm = default(WarmStart);
            DistanceResult cold = pair.SignedDistance(), swapped = pair.Swapped.SignedDistance();
            double band = 2 * pair.Band(Math.Abs(cold.Distance));
            Assert.Equal(cold.Distance, swapped.Distance, band);
            for (int i = 0; i < 3; i++)
            {
                DistanceResult r = ConvexQuery.SignedDistance(
                    pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, ref warm);
                Assert.True(cold.Status == r.Status && Math.Abs(cold.Distance - r.Distance) <= band, $"{r}: {pair}");
            }
        }
    }

    [Fact]
    public void TypedShapesGiveTheSameBits()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(100); seed++)
        {
            var rng = new Rng(64_000 + seed);
            float r = rng.Float(0.1, 1), h = rng.Float(0.1, 2);
            Vector3 radii = rng.Vector(0.1, 1), even = new(radii.X, radii.Y, radii.X);
            RigidPose at = new(rng.Rotation(), rng.Vector(-0.1, 0.1)), placed = new(rng.Rotation(), rng.Vector(-1, 1));
            Same(new CylinderShape(r, h), ConvexShape.Cylinder(r, h), new PointShape(), ConvexShape.Point());
            Same(new ConeShape(r, h), ConvexShape.Cone(r, h), new SphereShape(r), ConvexShape.Sphere(r));
            Same(new EllipsoidShape(radii), ConvexShape.Ellipsoid(radii), new SphereShape(r), ConvexShape.Sphere(r));
            Same(new CapsuleShape(r, h), ConvexShape.Capsule(r, h), new ConeShape(h, r), ConvexShape.Cone(h, r));
            Same(
                new Rounded<CylinderShape>(new CylinderShape(r, h), 0.1f), ConvexShape.Cylinder(r, h).Rounded(0.1f),
                new Scaled<ConeShape>(new ConeShape(r, h), even), ConvexShape.Cone(r, h).Scaled(even));
            Same(
                new Placed<EllipsoidShape>(new EllipsoidShape(even), placed),
                ConvexShape.Ellipsoid(even).Placed(placed), new PointShape(), ConvexShape.Point());

            void Same<TA, TB>(in TA a, in ConvexShape closedA, in TB b, in ConvexShape closedB)
                where TA : struct, ISupportMap
                where TB : struct, ISupportMap
            {
                var poseB = new RigidPose(at.Rotation, at.Position + (Vector3)closedA.Center);
                DistanceResult typed = ConvexQuery.SignedDistance(a, at, b, poseB);
                DistanceResult closed = ConvexQuery.SignedDistance(closedA, at, closedB, poseB);
                Assert.True(ResultBits.AreSame(typed, closed), $"seed {seed}: {typed}, closed {closed}");
            }
        }
    }

    [Theory]
    [InlineData(1e-30f)]
    [InlineData(1e30f)]
    public void ASizeIsOnlyAFactor(float factor)
    {
        var pair = new TestPair(
            "pin", TestShape.Cylinder(0.5f, 1), RigidPose.Identity, TestShape.Cylinder(0.25f, 2),
            new RigidPose(new Vector3(0, 0.5f, 0)));
        AssertDepth(pair.Resized(factor), 0.75 * factor);
        var point = new TestPair(
            "point", TestShape.Ellipsoid(new(0.5f, 1, 2)), RigidPose.Identity, TestShape.Point(),
            new RigidPose(new Vector3(0, 0, 0.25f)));
        DistanceResult usual = point.SignedDistance(), resized = point.Resized(factor).SignedDistance();
        Assert.Equal(usual.Distance * factor, resized.Distance, 1e-6 * factor);
    }

    /// <summary>Balls that are written as ellipsoids need a support for each root of what the bounds may leave, and
    /// half of the most that are asked.</summary>
    [Fact]
    public void BallsAboutOneCentreTakeThousandsOfSupports()
    {
        TestShape ball = TestShape.Ellipsoid(Vector3.One);
        var pair = new TestPair("balls", ball, RigidPose.Identity, ball, new RigidPose(new(0.6f, 0, 0, 0.8f), default));
        AssertDepth(pair, 2);
        Assert.InRange(pair.SignedDistance().Iterations, 3000, 5000);
    }

    /// <summary>Axes that are parallel but for the rounding of their quaternions, far from each other: one plane is
    /// searched.</summary>
    [Fact]
    public void RoundedQuaternionsAreParallel()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(200); seed++)
        {
            var rng = new Rng(65_000 + seed);
            Quaternion q = rng.Rotation(), turned = q * Quaternion.CreateFromAxisAngle(Vector3.UnitY, rng.Float(0, 6));
            Vector3 aside = Vector3.Transform(new Vector3(0.3f, 0.1f, 0), q);
            var pair = new TestPair(
                $"seed {seed}", TestShape.Cone(0.5f, 1), new RigidPose(q, default), TestShape.Cone(0.5f, 1),
                new RigidPose(turned, aside));
            DistanceResult r = pair.SignedDistance();
            Assert.True(r.IsOverlapping && r.Iterations <= 32, $"{r}, {r.Iterations}: {pair}");
        }
    }

    /// <summary>Leaning cones: how far they lean changes the shortest way out by as much, and where around the axis it
    /// is.</summary>
    [Theory]
    [InlineData(2e-7)]
    [InlineData(8e-7)]
    [InlineData(1e-6)]
    [InlineData(1e-5)]
    [InlineData(3e-5)]
    public void NearlyCoaxialShapesAreSearchedAllAround(double lean)
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(20); seed++)
        {
            var rng = new Rng(66_000 + seed);
            float angle = rng.Float(0, 6);
            Vector3 across = new(MathF.Cos(angle), 0, MathF.Sin(angle));
            var turned = new Quaternion(across * (float)(lean / 2), 1);
            TestShape a = seed % 2 == 0 ? TestShape.Cone(0.4f, 1) : TestShape.Cylinder(0.3f, 1);
            var pair = new TestPair(
                $"lean {lean}, seed {seed}", a, RigidPose.Identity, TestShape.Cone(0.5f, 1.1f),
                new RigidPose(turned, new Vector3(0, rng.Float(-0.2, 0.2), 0)));
            DistanceResult r = pair.SignedDistance();
            double truth = CheapestWay.Of(pair, r.Normal, seed);
            Assert.True(r.IsOverlapping && r.Iterations <= 3000, $"{r}: {pair}");
            Assert.True(-r.Distance - truth <= 5e-7, $"{-r.Distance:R}, but a way costs {truth:R}: {pair}");
        }
    }

    /// <param name="pair">Coaxial.</param>
    /// <param name="depth">Of the pair, were its position not rounded.</param>
    /// <param name="rounding">Length: how far the rounding may have moved B off the axis; the true depth may be less by
    /// as much.</param>
    private static void AssertDepth(TestPair pair, double depth, double rounding = 0)
    {
        foreach (TestPair p in new[] { pair, pair.Swapped })
        {
            DistanceResult r = p.SignedDistance();
            double band = 1e-6 * p.Scale;
            Assert.True(r.Status == GjkStatus.Overlapping, $"{r}: {p}");
            Assert.True(Math.Abs(r.Distance + depth) <= band, $"{r.Distance:R}, depth {depth:R}: {p}");
            double bound = rounding - depth + Math.Max(1e-7 * depth, 1e-7 * p.Scale);
            Assert.True(r.LowerBound <= bound, $"{r.LowerBound:R}: {p}");
            AssertCertified(p, r);
        }
    }

    /// <summary>Length: half a unit in the last place of the largest coordinate, by three axes, is less than a whole
    /// one.</summary>
    private static double RoundingOf(Vector3 position)
    {
        float largest = Math.Max(Math.Abs(position.X), Math.Max(Math.Abs(position.Y), Math.Abs(position.Z)));
        return MathF.BitIncrement(largest) - largest;
    }

    private static void AssertCheapest(TestPair pair, ulong seed)
    {
        DistanceResult r = pair.SignedDistance();
        Assert.True(r.Status is GjkStatus.Overlapping or GjkStatus.Separated, $"{r}: {pair}");
        AssertCertified(pair, r);
        if (!r.IsOverlapping || r.Distance == 0) return;
        double truth = CheapestWay.Of(pair, r.Normal, seed), slack = 1e-6 * pair.Scale;
        Assert.True(-r.Distance <= truth + slack, $"{-r.Distance:R}, but a way costs {truth:R}: {pair}");
    }

    private static void AssertCertified(TestPair pair, in DistanceResult r)
    {
        string? problem = Certificate.ProblemOfSigned(
            pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, r, pair.Scale, curved: true);
        Assert.True(problem is null, $"{problem}\n{pair}");
    }

    private static TestPair Round(ulong seed)
    {
        var rng = new Rng(67_000 + seed);
        TestShape a = Shape(rng, RoundKinds[rng.Below(RoundKinds.Length)]);
        TestShape b = Shape(rng, RoundKinds[rng.Below(RoundKinds.Length)]);
        Quaternion q = seed % 3 == 0 ? Quaternion.Identity : rng.Rotation();
        Vector3 y = Vector3.Transform(Vector3.UnitY, q), position = rng.Vector(-2, 2);
        Vector3 offset = (seed % 4) switch
        {
            0 => default,
            1 => y * rng.Float(-0.4, 0.4),
            2 => rng.Vector(-0.3, 0.3),
            _ => rng.UnitVector() * rng.LogFloat(1e-9, 1e-2),
        };
        Quaternion turned = rng.Below(4) switch
        {
            0 => q * Quaternion.CreateFromAxisAngle(Vector3.UnitY, rng.Float(0, 6)),
            1 => q * Quaternion.CreateFromAxisAngle(Vector3.UnitX, rng.LogFloat(1e-9, 2e-5)),
            _ => q,
        };
        return new TestPair(
            $"seed {seed}", a, new RigidPose(q, position), b, new RigidPose(turned, position + offset));
    }

    private static TestShape Shape(Rng rng, string kind)
    {
        float r = rng.Float(0.1, 1), h = rng.Float(0.1, 1);
        return kind switch
        {
            "spheroid" => TestShape.Ellipsoid(new(r, h, r)),
            "ball" => TestShape.Ellipsoid(new(r, r, r)),
            "rounded" => TestShape.Cylinder(r, h).Decorated(s => s.Rounded(0.1f), "Rounded(0.1f)"),
            "scaled" => TestShape.Cone(r, h).Scaled(new Vector3(-2, 0.7f, 2)),
            "placed" => TestShape.Ellipsoid(new(h, r, r)).Decorated(
                s => s.Placed(new RigidPose(new Quaternion(0, 0, MathF.Sqrt(0.5f), MathF.Sqrt(0.5f)), default)),
                "Placed(...)"),
            _ => Generators.Shape(rng, kind),
        };
    }
}
