namespace Gjk.Core.Tests.Regression;

/// <summary>A mesh of size 1 whose vertices lie 1e4 from its own origin, as exported levels have them, lost four digits
/// to the rotation of the offset. The offset is turned in double-double here.</summary>
public class OffsetMeshTests
{
    [Theory]
    [InlineData(10)]
    [InlineData(1e3)]
    [InlineData(1e4)]
    public void TheAnswerIsExactWhereverTheOriginIs(double offset)
    {
        int hits = 0, count = Budget.Count(200);
        for (ulong seed = 0; seed < (ulong)count; seed++)
        {
            var rng = new Rng(seed);
            TestShape a = Mesh(rng, offset), b = Mesh(rng, offset);
            RigidPose poseA = Generators.Pose(rng, rng.Vector(-1, 1)), turned = Generators.Pose(rng, default);
            Double3 centers = new RotationD(poseA.Rotation).Rotate(a.Shape.Center) - new RotationD(
                turned.Rotation).Rotate(b.Shape.Center);
            var pair = new TestPair(
                $"seed {seed}", a, poseA, b,
                new RigidPose(turned.Rotation, (Vector3)(centers + poseA.Position + (Double3)rng.Vector(-0.7, 0.7))));
            string? problem = OracleVerdict.Problem(pair, out ExactAnswer exact);
            Assert.True(problem is null, $"{problem}\n{pair}");
            hits += exact.Overlap ? 1 : 0;
        }

        Assert.InRange(hits, 0.2 * count, 0.8 * count);
    }

    private static TestShape Mesh(Rng rng, double offset)
    {
        Vector3 away = rng.UnitVector() * (float)offset;
        return TestShape.Mesh([.. Clouds.InBox(rng, 8, new Vector3(0.5f)).Select(p => p + away)]);
    }
}
