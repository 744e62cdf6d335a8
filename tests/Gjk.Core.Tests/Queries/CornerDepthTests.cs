namespace Gjk.Core.Tests.Queries;

/// <summary>A corner on the axis of a round body, or in the middle of one that is nearly a ball: many ways out are
/// equally long, and the search for the shortest one ended without an answer.</summary>
public class CornerDepthTests
{
    /// <summary>Supports of all searches together, for two hundred corners.</summary>
    private const int Few = 4000;

    /// <summary>The corner is in the middle, or beside it by up to a tenth; upright, and turned.</summary>
    [Theory]
    [InlineData("cylinder")]
    [InlineData("cone")]
    [InlineData("spheroid")]
    [InlineData("ball")]
    [InlineData("nearly a ball")]
    [InlineData("nearly a spheroid")]
    [InlineData("ellipsoid")]
    public void NoneEndsAtTheLimit(string kind)
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(60); seed++)
        {
            var rng = new Rng(79_000 + seed);
            TestShape round = Round(rng, kind), cornered = Cornered(rng, out Vector3 corner);
            Vector3 aside = seed % 3 == 0 ? Vector3.Zero : rng.UnitVector() * rng.LogFloat(1e-9, 1e-1);
            RigidPose pose = seed % 4 == 0 ? RigidPose.Identity : new RigidPose(rng.Rotation(), default);
            Quaternion turn = seed % 4 == 0 ? Quaternion.Identity : rng.Rotation();
            Vector3 at = Vector3.Transform(aside, pose.Rotation) - Vector3.Transform(corner, turn);
            AssertDepth(new TestPair($"{kind} {seed}", round, pose, cornered, new RigidPose(turn, at)), seed);
        }
    }

    /// <summary>Meshes of many corners, one of them in the middle of what is nearly a ball.</summary>
    [Fact]
    public void ManyCornersAreSeen()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(20); seed++)
        {
            var rng = new Rng(80_000 + seed);
            var points = new Vector3[200];
            for (int i = 0; i < points.Length; i++) points[i] = rng.UnitVector();
            TestShape ball = Round(rng, "nearly a ball"), mesh = TestShape.Mesh(points);
            Quaternion turn = rng.Rotation();
            var at = new RigidPose(turn, -Vector3.Transform(points[0], turn));
            AssertDepth(new TestPair($"{seed}", ball, RigidPose.Identity, mesh, at), seed);
        }
    }

    /// <summary>Of a ball, however it is written, the depth at a corner is the sphere's.</summary>
    [Fact]
    public void ABallIsABall()
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(60); seed++)
        {
            var rng = new Rng(81_000 + seed);
            float radius = rng.Float(0.2, 1);
            TestShape cornered = Cornered(rng, out Vector3 corner);
            var at = new RigidPose(rng.UnitVector() * 0.01f - corner);
            DistanceResult ball = ConvexQuery.SignedDistance(
                ConvexShape.Ellipsoid(new Vector3(radius)), RigidPose.Identity, cornered.Shape, at);
            DistanceResult sphere = ConvexQuery.SignedDistance(
                ConvexShape.Sphere(radius), RigidPose.Identity, cornered.Shape, at);
            Assert.True(Math.Abs(ball.Distance - sphere.Distance) <= 1e-6, $"{ball}, sphere {sphere}: {seed}");
        }
    }

    private static void AssertDepth(TestPair pair, ulong seed)
    {
        WarmStart kept = default;
        double band = 1e-6 * pair.Scale;
        DistanceResult cold = pair.SignedDistance(), swapped = pair.Swapped.SignedDistance();
        ConvexQuery.SignedDistance(pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, ref kept);
        DistanceResult warm = ConvexQuery.SignedDistance(
            pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, ref kept);
        Assert.True(cold.IsOverlapping && swapped.IsOverlapping && warm.IsOverlapping, $"{cold}: {pair}");
        Assert.True(cold.Iterations <= Few, $"{cold}, {cold.Iterations}: {pair}");
        Assert.True(Math.Abs(cold.Distance - swapped.Distance) <= band, $"{cold}, swapped {swapped}: {pair}");
        Assert.True(Math.Abs(cold.Distance - warm.Distance) <= band, $"{cold}, warm {warm}: {pair}");
        string? problem = Certificate.ProblemOfSigned(
            pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, cold, pair.Scale, curved: true);
        Assert.True(problem is null, $"{problem}\n{pair}");
        double truth = CheapestWay.Of(pair, cold.Normal, seed);
        Assert.True(-cold.Distance <= truth + band, $"{cold}, but a way costs {truth:R}: {pair}");
    }

    private static TestShape Round(Rng rng, string kind)
    {
        float r = rng.Float(0.2, 1), h = rng.Float(0.2, 1);
        return kind switch
        {
            "cylinder" => TestShape.Cylinder(r, h),
            "cone" => TestShape.Cone(r, h),
            "spheroid" => TestShape.Ellipsoid(new(r, h, r)),
            "ball" => TestShape.Ellipsoid(new(r)),
            "nearly a ball" => TestShape.Ellipsoid(
                new Vector3(r) + r * rng.LogFloat(1e-7, 1e-1) * rng.Vector(-1, 1)),
            "nearly a spheroid" => TestShape.Ellipsoid(new(r, h, r * (1 + rng.LogFloat(1e-7, 1e-1)))),
            _ => TestShape.Ellipsoid(rng.Vector(0.2, 1)),
        };
    }

    private static TestShape Cornered(Rng rng, out Vector3 corner)
    {
        Vector3 half = rng.Vector(0.1, 1);
        corner = half;
        switch (rng.Below(4))
        {
            case 0:
                return TestShape.Box(half);
            case 1:
                corner = new Vector3(0, half.Y, 0);
                return TestShape.Capsule(half.X, half.Y);
            case 2:
                return TestShape.Triangle(half, rng.Vector(-1, 1), rng.Vector(-1, 1));
            default:
                Vector3[] points = [.. Enumerable.Range(0, 4 + rng.Below(16)).Select(_ => rng.UnitVector())];
                corner = points[0];
                return TestShape.Mesh(points);
        }
    }
}
