namespace Gjk.Core.Tests.Regression;

/// <summary>The support of a shape far from its local origin compared dot products of absolute coordinates, whose
/// rounding grows with the offset. A lower bound was above the true distance, because the plane went through the wrong
/// vertex.</summary>
public class FarLocalOriginTests
{
    [Theory]
    [InlineData("segment", 5.8e6)]
    [InlineData("triangle", 5.8e6)]
    [InlineData("mesh", 5.8e6)]
    [InlineData("mesh", 1e3)]
    [InlineData("triangle", 1e3)]
    public void TheAnswerIsExact(string kind, double offset)
    {
        int count = Budget.Count(200), separated = 0;
        for (ulong seed = 0; seed < (ulong)count; seed++)
        {
            var rng = new Rng(310_000 + seed);
            Vector3 away = rng.UnitVector() * (float)offset;
            TestShape far = Far(rng, kind, away), box = TestShape.Box(rng.Vector(0.4, 1.5));
            RigidPose turned = Generators.Pose(rng, default);
            Double3 center = new RotationD(turned.Rotation).Rotate(far.Shape.Center);
            var pose = new RigidPose(turned.Rotation, (Vector3)((Double3)rng.UnitVector() * rng.Range(1, 4) - center));
            var pair = new TestPair($"{kind} {offset}, seed {seed}", far, pose, box, RigidPose.Identity);
            string? problem = OracleVerdict.Problem(pair, out ExactAnswer exact) ?? OracleVerdict.Problem(
                pair.Swapped, out _);
            Assert.True(problem is null, $"{problem}\n{pair}");
            separated += exact.Overlap ? 0 : 1;
        }

        Assert.InRange(separated, 0.05 * count, 0.98 * count);
    }

    /// <summary>Coordinates are rounded to float at the offset, which flattens or repeats some vertices; that is
    /// fine.</summary>
    private static TestShape Far(Rng rng, string kind, Vector3 away) => kind switch
    {
        "segment" => TestShape.Segment(away + rng.Vector(-2, 2), away + rng.Vector(-2, 2)),
        "triangle" => TestShape.Triangle(away + rng.Vector(-2, 2), away + rng.Vector(-2, 2), away + rng.Vector(-2, 2)),
        _ => TestShape.Mesh(System.Array.ConvertAll(Clouds.InBox(rng, 10, new Vector3(2)), p => away + p)),
    };
}
