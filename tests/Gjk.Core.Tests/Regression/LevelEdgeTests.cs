namespace Gjk.Core.Tests.Regression;

/// <summary>Two boxes flush but for 4e-14 rad: rounding preferred the axis across two edges to that of the face, and
/// the edges were such as do not pass each other, so that the point of A lay a third of its size beside it. And boxes
/// that are turned alike but for 1e-7 rad: the deepest edge lies along the rim of the face, outside it by more than
/// rounding, so that the rim cut off all but the wrong end. Found by fuzz.</summary>
public class LevelEdgeTests
{
    [Theory]
    [InlineData(
        "gjk1 box 1 1 1 @ 0 4.96396922E-07 0 1 -1.2230339E-09 -1.20429231E-08 -2.23685745E-08 box 1 1 1 @ "
        + "3.51005639E-07 3.51005639E-07 0.707106769 0.707106769 -0.0327550285 0.494656384 -1.99996495", -3.503738e-5f)]
    [InlineData(
        "gjk1 box 0.043202887321076799 0.011621068020527481 0.002735628221790673 @ -0.0883122087 -0.406576246 "
        + "0.355301231 0.837053001 6.43225251E-10 2.16597532E-10 -1.99382066E-10 box 0.043202887321076799 "
        + "0.011621068020527481 0.002735628221790673 @ -0.0883121863 -0.406576276 0.355301231 0.837053001 "
        + "0.0162204448 -0.0162382722 0.00657437602", -1.892239e-6f)]
    [InlineData(
        "gjk1 box 0.62668651342391968 0.030321491882205009 0.013881335034966469 @ -0.425211102 0.586152375 "
        + "-0.208636403 -0.657336831 0 0 0 box 0.62668651342391968 0.030321491882205009 0.013881335034966469 @ "
        + "-0.425211102 0.586152494 -0.208636403 -0.657336831 0.0173770115 -0.0464569107 -0.0151247531", -9.49498e-8f)]
    [InlineData(
        "gjk1 box 0.015397151932120323 0.018683897331357002 0.96593213081359863 @ 0.0903158337 0.819067657 "
        + "-0.259524763 0.503605127 0 0 0 box 0.060695908963680267 0.056910324841737747 0.18653583526611328 @ "
        + "0.0903158337 0.819067657 -0.259524941 0.503605068 0.601136565 -0.346703261 -0.37066707", -9.9458646e-8f)]
    public void PointsLieOnBothBoxes(string record, float distance)
    {
        QueryRecord pair = QueryRecord.Parse(record);
        DistanceResult r = ConvexQuery.SignedDistance(pair.A, pair.PoseA, pair.B, pair.PoseB);
        CheckedAnswer check = AnswerCheck.SignedDistance(pair.A, pair.PoseA, pair.B, pair.PoseB, r);
        Assert.Equal((GjkStatus.Overlapping, distance), (r.Status, r.Distance));
        Assert.True(check.Status == CheckStatus.ProvedAtMost, $"{check}: {r}");
    }
}
