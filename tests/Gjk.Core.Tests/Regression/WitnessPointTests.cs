using System;
using System.Numerics;
using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests.Regression;

/// <summary>
/// Closest points at great ratios of size or distance: the weights of needle triangles lost their digits (4e-3 of the
/// larger size off at 1e10), and the point on B was found by walking the distance from A (3e-4 outside a unit box that
/// is 1e12 away).
/// </summary>
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
            TestShape large = TestShape.Mesh(Generators.Cloud(rng, 8, new Vector3(ratio)));
            TestShape small = TestShape.Mesh(Generators.Cloud(rng, 8, Vector3.One));
            RigidPose pose = Generators.Pose(rng, rng.Direction() * rng.Float(0.2, 1.5) * ratio);
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
            RigidPose poseB = Generators.Pose(rng, rng.Direction() * distance);
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
}
