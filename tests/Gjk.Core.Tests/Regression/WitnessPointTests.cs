namespace Gjk.Core.Tests.Regression;

/// <summary>Closest points at great ratios of size or distance: the weights of needle triangles lost their digits (4e-3
/// of the larger size off at 1e10), and the point on B was found by walking the distance from A (3e-4 outside a unit
/// box that is 1e12 away).</summary>
public class WitnessPointTests
{
    [Theory]
    [InlineData(1e8f)]
    [InlineData(1e10f)]
    [InlineData(1e12f)]
    public void ASmallShapeBesideALargeOneKeepsItsPoint(float ratio)
    {
        int separated = 0, count = Budget.Count(300);
        for (ulong seed = 0; seed < (ulong)count; seed++)
        {
            var rng = new Rng(320_000 + seed);
            TestShape large = TestShape.Mesh(Clouds.InBox(rng, 8, new Vector3(ratio)));
            TestShape small = TestShape.Mesh(Clouds.InBox(rng, 8, Vector3.One));
            RigidPose pose = Generators.Pose(rng, rng.UnitVector() * rng.Float(0.2, 1.5) * ratio);
            var pair = new TestPair(
                $"seed {seed}, ratio {ratio}", large, Generators.Pose(rng, rng.Vector(-1, 1)), small, pose);
            foreach (TestPair p in new[] { pair, pair.Swapped })
            {
                DistanceResult r = p.Distance();
                string? problem = OracleVerdict.Problem(p, r, out ExactAnswer exact) ?? Certificate.Problem(
                    p.A.Shape, p.PoseA, p.B.Shape, p.PoseB, r, p.Scale);
                Assert.True(problem is null, $"{problem}\n{p}");
                separated += exact.Overlap ? 0 : 1;
            }
        }

        Assert.InRange(separated, 0.2 * count, 2 * count);
    }

    [Theory]
    [InlineData(1e6f)]
    [InlineData(1e9f)]
    [InlineData(1e12f)]
    [InlineData(1e20f)]
    public void LocalPointsOfShapesFarApartLieOnThem(float distance)
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(200); seed++)
        {
            var rng = new Rng(330_000 + seed);
            TestShape a = TestShape.Box(rng.Vector(0.1, 1));
            TestShape b = Generators.Shape(rng, new[] { "box", "hull", "capsule", "triangle" }[rng.Below(4)]);
            RigidPose poseA = Generators.Pose(rng, rng.Vector(-1, 1));
            RigidPose poseB = Generators.Pose(rng, rng.UnitVector() * distance);
            DistanceResult r = ConvexQuery.Distance(a.Shape, poseA, b.Shape, poseB);
            double outsideA = new Body<ConvexShape>(a.Shape, poseA).Outside(r.LocalPointA);
            double outsideB = new Body<ConvexShape>(b.Shape, poseB).Outside(r.LocalPointB);
            Assert.True(
                Math.Max(outsideA, outsideB) <= 5e-7, $"{outsideA:R} outside A, {outsideB:R} outside B, seed {seed}");

            // The same with B at the origin: its world point is as near as a float there allows.
            DistanceResult s = ConvexQuery.Distance(b.Shape, poseB, a.Shape, poseA);
            double off = (new Body<ConvexShape>(a.Shape, poseA).ToWorld(s.LocalPointB) - s.PointB).Length;
            Assert.True(off <= 1e-6, $"PointB {off:R} off the world position of LocalPointB, seed {seed}");
        }
    }

    /// <summary>The point on a cylinder was moved round its side to face the other shape, and beyond the side's end
    /// where that was beside the rim.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void BesideARimThePointStaysOnTheCylinder(bool isExchanged)
    {
        ConvexShape cylinder = ConvexShape.Cylinder(0.8f, 1);
        for (int i = 0; i < 400; i++)
        {
            var rng = new Rng((ulong)i);
            float past = rng.Float(-1, 1) * 1e-5f, angle = rng.Float(-3, 3), gap = rng.Float(0.01, 0.2);
            Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, angle);
            Vector3 end = Vector3.Transform(new Vector3(0.8f + gap, 1 + past, 0), turn);
            ConvexShape edge = ConvexShape.Segment(end, end + Vector3.Transform(new Vector3(0.3f, past, 0.2f), turn));
            DistanceResult d = isExchanged
                ? ConvexQuery.Distance(edge, RigidPose.Identity, cylinder, RigidPose.Identity)
                : ConvexQuery.Distance(cylinder, RigidPose.Identity, edge, RigidPose.Identity);
            Vector3 p = isExchanged ? d.LocalPointB : d.LocalPointA;
            Assert.True(
                p.Y <= 1 + 5e-7f && MathF.Sqrt(p.X * p.X + p.Z * p.Z) <= 0.8f + 5e-7f,
                $"{i}: {p} with the edge's end {past:R} above the rim");
        }
    }
}
