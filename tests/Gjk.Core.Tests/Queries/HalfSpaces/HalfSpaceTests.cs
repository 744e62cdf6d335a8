using Gjk.Exact.Fuzz;

namespace Gjk.Core.Tests.Queries;

/// <summary>The distance of a half-space and any shape is what exact arithmetic says.</summary>
public class HalfSpaceTests
{
    /// <summary>Ratios to the distance and to the size: a rounding to float, and the promised 1e-14.</summary>
    private const double OfDistance = 1.2e-7, OfSize = 1e-14;

    public static TheoryData<string> Polytopes => [.. Generators.PolytopeKinds];

    public static TheoryData<string> Curved => [.. Generators.CurvedKinds, .. Generators.LaterKinds];

    public static TheoryData<string> Kinds =>
        [.. Generators.PolytopeKinds, .. Generators.CurvedKinds, .. Generators.LaterKinds];

    [Theory]
    [MemberData(nameof(Polytopes))]
    public void TheDistanceIsTheExactOne(string kind)
    {
        for (ulong seed = 1; seed <= (ulong)Budget.Whole(400); seed++)
        {
            var rng = new Rng(seed);
            HalfSpaceSetup s = HalfSpaceSetup.Random(rng, kind);
            double exact = s.ExactGap();
            DistanceResult signed = s.SignedDistance();
            double band = OfDistance * Math.Abs(exact) + OfSize * s.Other.LongestSide;
            Assert.True(Math.Abs(signed.Distance - exact) <= band, $"{kind}, seed {seed}: {signed} for {exact:R}");
            Assert.True(signed.LowerBound <= exact, $"{kind}, seed {seed}: {signed.LowerBound:R} for {exact:R}");
            Assert.True(
                signed.LowerBound >= exact - 2 * band - 1e-7 * Math.Abs(exact), $"{kind}, seed {seed}: the bound");
        }
    }

    [Theory]
    [MemberData(nameof(Curved))]
    public void TheDistanceOfCurvedShapesIsTheirSupport(string kind)
    {
        for (ulong seed = 1; seed <= 200; seed++)
        {
            HalfSpaceSetup s = HalfSpaceSetup.Random(new Rng(seed), kind, far: 1);
            Double3 normal = s.OutwardInOther(out double height);
            double expected = height - new CurvedHeights(s.Other.Shape).Of(-normal) - s.Other.Shape.Margin;
            DistanceResult signed = s.SignedDistance();
            double band = OfDistance * Math.Abs(expected) + 1e-12 * s.Other.LongestSide;
            Assert.True(Math.Abs(signed.Distance - expected) <= band, $"{kind}, seed {seed}: {signed}, {expected:R}");
        }
    }

    /// <summary>Expectations as those of FCL and coal: shapes of known sizes over a floor, upright and on their
    /// side.</summary>
    [Fact]
    public void ShapesOfKnownSizeStandOverAFloor()
    {
        ConvexShape floor = ConvexShape.HalfSpace(Vector3.UnitY, 0.25f);
        var side = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 2);
        (ConvexShape Shape, float Upright, float Lying)[] shapes =
        [
            (ConvexShape.Point(), 0, 0), (ConvexShape.Sphere(0.5f), 0.5f, 0.5f),
            (ConvexShape.Box(new(1, 2, 3)), 2, 1), (ConvexShape.Capsule(0.5f, 1), 1.5f, 0.5f),
            (ConvexShape.Cylinder(0.75f, 2), 2, 0.75f), (ConvexShape.Cone(0.5f, 2), 2, 0.5f),
            (ConvexShape.Ellipsoid(new(1, 2, 3)), 2, 1), (ConvexShape.Box(new(1)).Rounded(0.5f), 1.5f, 1.5f),
            (ConvexShape.Segment(-Vector3.UnitY, Vector3.UnitY), 1, 0),
            (ConvexShape.TaperedCapsule(0.25f, 0.5f, 1), 1.5f, 0.5f),
        ];
        foreach ((ConvexShape shape, float upright, float lying) in shapes)
        {
            foreach (float height in new[] { 5f, 0.5f, -3 })
            {
                DistanceResult r = ConvexQuery.SignedDistance(
                    floor, RigidPose.Identity, shape, new RigidPose(new Vector3(7, height, -2)));
                Assert.Equal(height - 0.25f - upright, r.Distance, 1e-6f);
                Assert.Equal(Vector3.UnitY, r.Normal);
                Assert.Equal(0.25f, r.PointA.Y, 1e-6f);
                r = ConvexQuery.SignedDistance(
                    floor, RigidPose.Identity, shape, new RigidPose(side, new Vector3(7, height, -2)));
                Assert.Equal(height - 0.25f - lying, r.Distance, 1e-6f);
            }
        }
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void TheExchangedPairHasTheExchangedBits(string kind)
    {
        for (ulong seed = 1; seed <= 100; seed++)
        {
            HalfSpaceSetup s = HalfSpaceSetup.Random(new Rng(seed), kind);
            ConvexShape a = s.Plane, b = s.Other.Shape;
            Assert.True(ResultBits.AreSame(
                s.SignedDistance(), ConvexQuery.SignedDistance(b, s.OtherPose, a, s.Pose).Swapped));
            Assert.True(ResultBits.AreSame(s.Distance(), ConvexQuery.Distance(b, s.OtherPose, a, s.Pose).Swapped));
            Assert.Equal(
                ConvexQuery.Overlaps(a, s.Pose, b, s.OtherPose), ConvexQuery.Overlaps(b, s.OtherPose, a, s.Pose));
        }
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void AllVerbsSayTheSame(string kind)
    {
        for (ulong seed = 1; seed <= 100; seed++)
        {
            HalfSpaceSetup s = HalfSpaceSetup.Random(new Rng(seed), kind);
            ConvexShape a = s.Plane, b = s.Other.Shape;
            DistanceResult signed = s.SignedDistance(), distance = s.Distance();
            Assert.Equal(signed.Status, distance.Status);
            Assert.Equal(Math.Max(signed.Distance, 0), distance.Distance);
            bool overlaps = ConvexQuery.Overlaps(a, s.Pose, b, s.OtherPose, out GjkStatus status);
            Assert.Equal(overlaps, distance.IsOverlapping);
            Assert.Equal(distance.Status, status);
            if (!overlaps) Assert.True(ResultBits.AreSame(signed, distance), $"{kind}, seed {seed}");
            var warm = default(WarmStart);
            Assert.True(ResultBits.AreSame(
                distance, ConvexQuery.Distance(a, s.Pose, b, s.OtherPose, ref warm)));
            Assert.True(ResultBits.AreSame(
                distance, ConvexQuery.Distance(a, s.Pose, b, s.OtherPose, out FinalSimplex simplex)));
            Assert.Equal(0, simplex.Count);
            CheckPoints(s, signed, $"{kind}, seed {seed}");
            if (!overlaps) continue;
            Assert.Equal(Vector3.Zero, distance.Normal);
            Assert.Equal(distance.PointA, distance.PointB);
        }
    }

    [Fact]
    public void ALargestDistanceEndsTheQuery()
    {
        ConvexShape floor = ConvexShape.HalfSpace(Vector3.UnitY, 0), ball = ConvexShape.Sphere(1);
        var at = new RigidPose(new Vector3(3, 5, 0));
        Assert.Equal(4, ConvexQuery.Distance(floor, RigidPose.Identity, ball, at, 4).Distance);
        DistanceResult beyond = ConvexQuery.Distance(floor, RigidPose.Identity, ball, at, 3.5f);
        Assert.Equal(GjkStatus.BeyondMaxDistance, beyond.Status);
        Assert.Equal(float.PositiveInfinity, beyond.Distance);
        Assert.Equal(Vector3.UnitY, beyond.Normal);
        Assert.InRange(beyond.LowerBound, 3.9999f, 4);
        Assert.Equal(
            GjkStatus.InvalidInput,
            ConvexQuery.Distance(floor, RigidPose.Identity, ball, at, float.NaN).Status);
    }

    /// <summary>Scaled, widened or placed it is the half-space that a pose or a margin of the other would
    /// make.</summary>
    [Fact]
    public void DecoratorsMakeAnotherHalfSpace()
    {
        for (ulong seed = 1; seed <= 300; seed++)
        {
            var rng = new Rng(seed);
            ConvexShape plane = ConvexShape.HalfSpace(rng.UnitVector() * rng.LogFloat(0.1, 10), rng.Float(-3, 3));
            Vector3 point = rng.Vector(-5, 5), scale = rng.Vector(0.3, 2);
            if (rng.Below(2) == 0) scale = -scale;
            if (rng.Below(2) == 0) scale.Y = -scale.Y;
            double gap = GapOf(plane, point), length = (double)plane.Normal.Length();
            Assert.Equal(1, length, 1e-6);
            Assert.Equal(gap - 0.75, GapOf(plane.Rounded(0.75f), point), 2e-6);
            var pose = new RigidPose(rng.Rotation(), rng.Vector(-4, 4));
            Assert.Equal(gap, GapOf(plane.Placed(pose), pose.TransformPoint(point)), 4e-6);
            ConvexShape scaled = plane.Scaled(scale);
            Assert.Equal(Math.Sign(gap), Math.Sign(GapOf(scaled, point * scale)));
            Vector3 on = point - plane.Normal * (float)gap;
            Assert.Equal(0, GapOf(scaled, on * scale), 1e-5);
            Assert.Equal(ShapeKind.HalfSpace, scaled.Rounded(1).Placed(pose).Kind);
            Assert.False(scaled.Rounded(1).Placed(pose).IsDecorated);
        }
    }

    /// <summary>What is placed far away and moved back has lost nothing.</summary>
    [Fact]
    public void PlacedFarAwayNothingIsLost()
    {
        for (ulong seed = 1; seed <= 200; seed++)
        {
            var rng = new Rng(seed);
            Vector3 far = rng.Vector(-1e7, 1e7), normal = rng.UnitVector();
            var turn = new RigidPose(rng.Rotation(), far);
            ConvexShape plane = ConvexShape.HalfSpace(normal, rng.Float(-1, 1)).Placed(new RigidPose(far)).Placed(turn);
            ConvexShape back = plane.Placed(turn.Inverse()).Placed(new RigidPose(-far));
            Assert.Equal(1, (double)plane.Normal.Length(), 1e-6);
            Assert.True(Math.Abs(back.Offset) < 10, $"seed {seed}: {back}");
            ConvexShape moved = ConvexShape.HalfSpace(normal, 0.5f).Placed(new RigidPose(far * 1e5f));
            ConvexShape same = moved.Placed(new RigidPose(far * -1e5f));
            Assert.Equal(ConvexShape.HalfSpace(normal, 0.5f).Offset, same.Offset);
        }
    }

    [Fact]
    public void ItSaysItsNumbers()
    {
        ConvexShape plane = ConvexShape.HalfSpace(new Vector3(0, 2, 0), 3);
        Assert.Equal((ShapeKind.HalfSpace, Vector3.UnitY, 1.5f), (plane.Kind, plane.Normal, plane.Offset));
        Assert.Equal("half-space, normal <0, 2, 0>, offset 3", plane.ToString());
        Assert.Equal(double.PositiveInfinity, plane.BoundingRadius);
        Assert.Equal(plane, ConvexShape.HalfSpace(new Vector3(0, 2, 0), 3));
        Assert.NotEqual(plane, ConvexShape.HalfSpace(new Vector3(0, 2, 0), 2));
        Assert.Equal((Vector3.Zero, 0f), (ConvexShape.Sphere(1).Normal, ConvexShape.Sphere(1).Offset));
    }

    private static double GapOf(in ConvexShape plane, Vector3 point) =>
        ConvexQuery.SignedDistance(plane, RigidPose.Identity, point).Distance;

    private static void CheckPoints(HalfSpaceSetup s, in DistanceResult r, string message)
    {
        float size = (float)s.Other.LongestSide + s.OtherPose.Position.Length() + s.Pose.Position.Length() + 1;
        Assert.True((r.PointA + r.Normal * r.Distance - r.PointB).Length() <= 1e-6f * size, message + ": points");
        Assert.True((s.Pose.TransformPoint(r.LocalPointA) - r.PointA).Length() <= 2e-6f * size, message + ": A's");
        Assert.True((s.OtherPose.TransformPoint(r.LocalPointB) - r.PointB).Length() <= 2e-6f * size, message + ": B's");
        Double3 n = (Double3)s.Normal * (1 / ((Double3)s.Normal).Length);
        double level = s.Offset / ((Double3)s.Normal).Length;
        Assert.Equal(0, Double3.Dot(n, r.LocalPointA) - level, 1e-6 * size);
    }
}
