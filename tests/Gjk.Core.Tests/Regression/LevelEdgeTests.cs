namespace Gjk.Core.Tests.Regression;

/// <summary>Two boxes flush but for 4e-14 rad: rounding preferred the axis across two edges to that of the face, and
/// the edges were such as do not pass each other, so that the point of A lay a third of its size beside it. Found by
/// fuzz.</summary>
public class LevelEdgeTests
{
    private const string Record =
        "gjk1 box 1 1 1 @ 0 4.96396922E-07 0 1 -1.2230339E-09 -1.20429231E-08 -2.23685745E-08 box 1 1 1 @ "
        + "3.51005639E-07 3.51005639E-07 0.707106769 0.707106769 -0.0327550285 0.494656384 -1.99996495";

    [Fact]
    public void PointsLieOnBothBoxes()
    {
        QueryRecord pair = QueryRecord.Parse(Record);
        DistanceResult r = ConvexQuery.SignedDistance(pair.A, pair.PoseA, pair.B, pair.PoseB);
        CheckedAnswer check = AnswerCheck.SignedDistance(pair.A, pair.PoseA, pair.B, pair.PoseB, r);
        Assert.Equal((GjkStatus.Overlapping, -3.503738e-5f), (r.Status, r.Distance));
        Assert.True(check.Status == CheckStatus.ProvedAtMost, $"{check}: {r}");
    }
}
