namespace Gjk.Core.Tests.Regression;

/// <summary>Shapes with parallel faces a small gap apart were called overlapping: v, the difference of two nearly equal
/// points, is mostly rounding there, and a support along it finds the wrong corner. Normals come from the feature here,
/// not from v. The gaps are B's position, so a float holds them exactly.</summary>
public class ParallelFaceTests
{
    private static readonly float[] Gaps =
        [1e-12f, 1e-10f, 1e-9f, 1e-8f, 1e-7f, 1e-6f, 1e-5f, 1e-4f, 1e-3f, 1e-2f, 0.1f, 1];

    public static TheoryData<string> Bodies => ["cubes", "prisms", "plates"];

    [Theory]
    [MemberData(nameof(Bodies))]
    public void TheGapIsTheDistanceAndItsNegativeIsAnOverlap(string bodies)
    {
        // A lies below y = 0 and B above it; both are wide enough that the sideways shift leaves faces opposite each
        // other.
        TestShape a = Below(bodies, -1), b = Below(bodies, 1);
        foreach (float gap in Gaps)
        {
            foreach (float side in new[] { 0, 0.3f, 0.5f })
            {
                DistanceResult apart = Distance(a, b, new Vector3(side, gap, -side));
                DistanceResult within = Distance(a, b, new Vector3(side, -gap, -side));
                bool exact = Math.Abs(apart.Distance - (double)gap) <= Accuracy.Band(gap, 4);
                Assert.True(
                    apart.Status == GjkStatus.Separated && exact,
                    $"{bodies}, gap {gap}, side {side}: {apart.Status} {apart.Distance:R}");
                Assert.True(Math.Abs(apart.Normal.Y - 1) < 1e-6, $"{bodies}, gap {gap}: normal {apart.Normal}");
                if (gap < Thickness(bodies))
                {
                    Assert.True(
                        within.IsOverlapping,
                        $"{bodies}, depth {gap}, side {side}: {within.Status} {within.Distance:R}");
                }
            }
        }
    }

    [Fact]
    public void TurnedTogetherTheyHaveTheExactAnswer()
    {
        TestShape a = Below("cubes", -1), b = Below("cubes", 1);
        for (ulong seed = 0; seed < (ulong)Budget.Count(200); seed++)
        {
            var rng = new Rng(seed);
            Quaternion q = rng.Rotation();
            Vector3 up = Vector3.Transform(Vector3.UnitY, q);
            foreach (float gap in new[] { 1e-9f, -1e-9f, 1e-6f, -1e-6f, 1e-3f })
            {
                var pair = new TestPair(
                    $"seed {seed}, gap {gap}", a, new RigidPose(q, default), b, new RigidPose(q, up * gap));
                string? problem = OracleVerdict.Problem(pair, out _);
                Assert.True(problem is null, $"{problem}\n{pair}");
            }
        }
    }

    private static DistanceResult Distance(TestShape a, TestShape b, Vector3 at) =>
        ConvexQuery.Distance(a.Shape, RigidPose.Identity, b.Shape, new RigidPose(at));

    private static float Thickness(string bodies) => bodies == "plates" ? 2e-3f : 2;

    private static TestShape Below(string bodies, float side)
    {
        float height = Thickness(bodies) * side;
        if (bodies != "prisms")
            return TestShape.Mesh(
                new(-1, 0, -1), new(1, 0, -1), new(-1, 0, 1), new(1, 0, 1), new(-1, height, -1), new(1, height, -1),
                new(-1, height, 1), new(1, height, 1));
        return TestShape.Mesh(
            new(-2, 0, -1), new(2, 0, -1), new(0, 0, 2), new(-2, height, -1), new(2, height, -1), new(0, height, 2));
    }
}
