namespace Gjk.Core.Tests.Regression;

/// <summary>A cylinder that reaches into another shape by some 1e-12 of its size was overlapping for Overlaps and apart
/// for Distance: the tolerance that ends the walk along a curved support was larger than the distance, so that the walk
/// ended before it had either separated the shapes or enclosed the origin. Found by fuzz.</summary>
public class CurvedContactTests
{
    [Theory]
    [InlineData(
        "gjk1 cylinder 0.84 0.6378294825553894 0 @ 0.289169073 -0.643011332 -0.262170017 0.658261001 0 0 0 box "
        + "0.9 0.97551357746124268 0.4 @ 0.389855593 0.0107831359 0.0190912187 0.920138478 -0.556473017 "
        + "1.38442838 0.885531664")]
    [InlineData(
        "gjk1 cylinder 0.8 0.89276957511901855 0 @ -0.302854657 -0.365206003 -0.230524793 0.849565744 "
        + "-0.665035427 0.468094319 -0.844379663 cylinder 0.7584 0.73917365074157715 0 @ -0.0511449464 0.3424941 "
        + "-0.377156228 0.858973384 -1.90570545 -0.3495498 -0.00447800057")]
    [InlineData(
        "gjk1 cylinder 0.7 0.25204184651374817 0 @ 0.183734357 0.266413093 -0.721838713 -0.612342834 "
        + "0.491055638 0.541494668 0.31253159 mesh 3 1 -0.557574093 0 -0.5 -0.557574093 -0.865999997 -1 "
        + "0.600000024 -0.899999976 @ 0.640097201 -0.244517714 -0.380354792 -0.621141672 -0.397175461 0.900664508 "
        + "0.0647380799")]
    public void OverlapsSaysWhatDistanceSays(string record)
    {
        QueryRecord q = QueryRecord.Parse(record);
        bool flag = ConvexQuery.Overlaps(q.A, q.PoseA, q.B, q.PoseB, out GjkStatus status);
        DistanceResult r = q.Distance();
        Assert.True(
            flag == r.IsOverlapping && status == r.Status,
            $"Overlaps {flag} ({status}), Distance {r.Status} {r.Distance:R}");
    }

    [Fact]
    public void TheTwoQueriesAgreeAtEveryDepthOfContact()
    {
        foreach (double gap in new[] { 0, 1e-13, 1e-11, 1e-9, -1e-13, -1e-11, -1e-9 })
        {
            for (ulong seed = 0; seed < (ulong)Budget.Count(300); seed++)
            {
                TestPair pair = Generators.NearPair(
                    230_000 + seed, ["cylinder", "cone", "ellipsoid", "box", "hull"], gap);
                bool flag = ConvexQuery.Overlaps(
                    pair.A.Shape, pair.PoseA, pair.B.Shape, pair.PoseB, out GjkStatus status);
                DistanceResult r = pair.Distance();
                Assert.True(
                    flag == r.IsOverlapping && status == r.Status,
                    $"Overlaps {flag} ({status}), Distance {r.Status} {r.Distance:R}\n{pair}");
            }
        }
    }
}
