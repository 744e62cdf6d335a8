namespace Gjk.Core.Tests.Regression;

/// <summary>Round hulls about one centre with corners that are level in many ways: poles, symmetric rings, copies of a
/// corner. Along an arc rounding missed a change of the furthest corner, and the depth ended at the limit. Found by
/// fuzz.</summary>
public class LevelCornerTests
{
    private static readonly QueryRecord[] Records =
    [
        .. CaseFamily.Read("level_corners.txt").Split('\n', StringSplitOptions.RemoveEmptyEntries)
            .Select(QueryRecord.Parse)
    ];

    [Fact]
    public void EachPairHasADepth()
    {
        Assert.Equal(4, Records.Length);
        foreach (QueryRecord p in Records)
        {
            DistanceResult r = ConvexQuery.SignedDistance(p.A, p.PoseA, p.B, p.PoseB);
            DistanceResult swapped = ConvexQuery.SignedDistance(p.B, p.PoseB, p.A, p.PoseA);
            CheckedAnswer check = AnswerCheck.SignedDistance(p.A, p.PoseA, p.B, p.PoseB, r);
            Assert.True(check.Status == CheckStatus.ProvedAtMost, $"{check}: {r}");
            Assert.Equal(GjkStatus.Overlapping, swapped.Status);
            Assert.Equal(r.Distance, swapped.Distance, Math.Abs(r.Distance) * 2e-7);
        }
    }

    [Fact]
    public void NoWayOutIsShorter()
    {
        QueryRecord p = Records[0];
        TestShape a = Shape(p.A.Hull!), b = Shape(p.B.Hull!);
        DistanceResult r = ConvexQuery.SignedDistance(p.A, p.PoseA, p.B, p.PoseB);
        double truth = CheapestWay.Of(new TestPair("record", a, p.PoseA, b, p.PoseB), r.Normal, 1);
        Assert.True(-r.Distance <= truth + 1e-6, $"{r}, but a way costs {truth:R}");
    }

    private static TestShape Shape(ConvexHull hull) =>
        TestShape.Mesh("hull", hull, [.. Enumerable.Range(0, hull.VertexCount).Select(hull.GetVertex)]);
}
