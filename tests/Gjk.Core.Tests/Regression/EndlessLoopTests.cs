namespace Gjk.Core.Tests.Regression;

/// <summary>Muratori's boolean step, trusted on rounded numbers, went to and fro between two faces of a tetrahedron for
/// ever: on 1 to 14 of 100,000 random pairs, and on flush or coincident faces. Here the boolean solver has a round
/// limit after which the distance solver decides, and that one's distance falls strictly.</summary>
public class EndlessLoopTests
{
    [Fact]
    public void TwoTrianglesThatShareTheirPlaneInEveryQuarterTurnEnd()
    {
        TestShape a = TestShape.Triangle(new(-1, 0, -1), new(1, 0, -1), new(0, 0, 1));
        TestShape b = TestShape.Triangle(new(-1, 0, 0), new(1, 0, 0), new(0, 0, 2));
        for (int x = -6; x <= 6; x++)
        {
            for (int z = -6; z <= 6; z++)
            {
                for (int turn = 0; turn < 4; turn++)
                    AssertEnds(
                        new TestPair(
                            $"{x} {z} {turn}", a, RigidPose.Identity, b,
                            new RigidPose(
                                Quaternion.CreateFromYawPitchRoll(turn * 1.5707964f, 0, 0),
                                new Vector3(x * 0.5f, 0, z * 0.5f))));
            }
        }
    }

    [Fact]
    public void TetrahedraFaceToFaceEnd()
    {
        TestShape up = TestShape.Mesh(new(-1, 0, -1), new(1, 0, -1), new(0, 0, 1), new(0, 1, 0));
        TestShape down = TestShape.Mesh(new(-1, 0, -1), new(1, 0, -1), new(0, 0, 1), new(0, -1, 0));
        foreach (float gap in new[] { 0, 1e-15f, 1e-8f, -1e-8f, 1e-3f, -1e-3f })
        {
            for (int shift = -4; shift <= 4; shift++)
            {
                AssertEnds(
                    new TestPair(
                        $"{gap} {shift}", down, RigidPose.Identity, up,
                        new RigidPose(new Vector3(shift * 0.25f, gap, shift * 0.125f))));
            }
        }
    }

    [Fact]
    public void TheOriginOnAnEdgeOrACornerOfTheDifferenceEnds()
    {
        TestShape cube = TestShape.Mesh(TestShape.Corners(new Vector3(0.5f)));
        foreach (Vector3 at
            in new Vector3[] { new(1, 0, 0), new(1, 1, 0), new(1, 1, 1), new(-1, 0, 1), new(0.5f, 1, 0.5f), default })
            AssertEnds(new TestPair($"{at}", cube, RigidPose.Identity, cube, new RigidPose(at)));
    }

    /// <summary>So many that the reported rate would show; with GJK_LONG=1 a hundred times as many.</summary>
    [Fact]
    public void RandomTetrahedraEnd()
    {
        for (ulong i = 0; i < (ulong)Budget.Count(20_000); i++)
        {
            TestPair pair = Generators.Pair(i, ["hull"]);
            bool flag = ConvexQuery.Overlaps(pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, out GjkStatus status);
            Assert.True(
                status is GjkStatus.Separated or GjkStatus.Overlapping && flag == pair.Distance().IsOverlapping,
                $"{status}\n{pair}");
        }
    }

    private static void AssertEnds(TestPair pair)
    {
        bool flag = ConvexQuery.Overlaps(pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, out GjkStatus status);
        DistanceResult r = pair.Distance();
        string? problem = OracleVerdict.Problem(pair, r, out ExactAnswer exact);
        Assert.True(
            problem is null && flag == r.IsOverlapping && status == r.Status,
            $"{problem}; Overlaps {flag} ({status}), Distance {r.Status}, truly {exact}\n{pair}");
        Assert.InRange(r.Iterations, 1, 40);
    }
}
