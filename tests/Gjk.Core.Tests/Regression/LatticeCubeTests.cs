namespace Gjk.Core.Tests.Regression;

/// <summary>Unit cubes on a lattice of a quarter unit, 11 places along each axis: 41 of the 1,331 overlaps were missed,
/// where faces are flush and the origin lies on a face, edge or corner of the simplex, so that a strict comparison
/// sends the walk the wrong way. The distance is known: per axis the excess over 1.</summary>
public class LatticeCubeTests
{
    private const float Step = 0.25f;
    private const int Reach = 5;

    public static TheoryData<string> Forms => ["box", "mesh of 8", "mesh of 24", "scaled mesh"];

    [Theory]
    [MemberData(nameof(Forms))]
    public void AllPlacesHaveTheRightFlagAndTheRightDistance(string form)
    {
        ConvexShape cube = Cube(form);
        int count = 0;
        for (int x = -Reach; x <= Reach; x++)
        {
            for (int y = -Reach; y <= Reach; y++)
            {
                for (int z = -Reach; z <= Reach; z++, count++)
                {
                    var pose = new RigidPose(new Vector3(x, y, z) * Step);
                    double dx = Excess(x), dy = Excess(y), dz = Excess(z), d = Math.Sqrt(dx * dx + dy * dy + dz * dz);
                    DistanceResult r = ConvexQuery.Distance(cube, RigidPose.Identity, cube, pose);
                    string place = $"{form} at {x} {y} {z}: {r.Status} {r.Distance}, truly {d}";
                    Assert.True(r.IsOverlapping == (d == 0) && r.Distance == (float)d, place);
                    Assert.True(ConvexQuery.Overlaps(cube, RigidPose.Identity, cube, pose) == (d == 0), place);
                }
            }
        }

        Assert.Equal(1331, count);
    }

    /// <summary>The same lattice turned in space: contact in floats is no contact exactly, so the exact answer
    /// decides.</summary>
    [Fact]
    public void TurnedTogetherTheyHaveTheExactAnswer()
    {
        TestShape cube = TestShape.Mesh(TestShape.Corners(new Vector3(0.5f)));
        for (ulong seed = 0; seed < (ulong)Budget.Count(300); seed++)
        {
            var rng = new Rng(seed);
            Quaternion q = rng.Rotation();
            Vector3 at = Vector3.Transform(new Vector3(rng.Below(9) - 4, rng.Below(9) - 4, rng.Below(9) - 4) * Step, q);
            var pair = new TestPair($"seed {seed}", cube, new RigidPose(q, default), cube, new RigidPose(q, at));
            string? problem = OracleVerdict.Problem(pair, out _);
            Assert.True(problem is null, $"{problem}\n{pair}");
        }
    }

    private static double Excess(int steps) => Math.Max(0, Math.Abs(steps) * Step - 1);

    private static ConvexShape Cube(string form)
    {
        Vector3[] corners = TestShape.Corners(new Vector3(0.5f));
        return form switch
        {
            "box" => ConvexShape.Box(new Vector3(0.5f)),
            "mesh of 8" => ConvexShape.Mesh(corners),
            "mesh of 24" => ConvexShape.Mesh([.. corners, .. corners, .. corners]),
            _ => ConvexShape.Mesh(TestShape.Corners(new Vector3(2))).Scaled(new Vector3(0.25f)),
        };
    }
}
