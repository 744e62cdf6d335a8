namespace Gjk.Core.Tests.Regression;

/// <summary>Two triangles all but equal, 9e-10 apart, were called touching from a warm start: the remembered simplex
/// was a needle, its normal mostly rounding, and its height nothing. Found by fuzz.</summary>
public class NeedleTouchTests
{
    private const string Record =
        "gjk1 triangle 0.016834042966365814 -0.25153779983520508 0.26785826683044434 0.85669392347335815 "
        + "0.48990499973297119 -0.65739220380783081 0.3013974130153656 -0.86923521757125854 -0.79121577739715576 "
        + "@ 0.342607945 -0.688456476 0.264896691 0.581787944 0 0 0 triangle 0.016834042966365814 "
        + "-0.25153779983520508 0.26785826683044434 0.85669392347335815 0.48990499973297119 -0.65739220380783081 "
        + "0.3013974130153656 -0.86923521757125854 -0.79121577739715576 @ 0.342607945 -0.688456476 0.264896691 "
        + "0.581787944 1.10893728E-09 -4.02878259E-10 -1.60159253E-09";

    /// <summary>Two triangles 1.4e-13 apart, and a nearest needle whose own point lies 9e-10 beside it: of the weights
    /// a negative one was left out, which moved the point along the needle by a tenth of its size.</summary>
    private const string Beside =
        "gjk1 mesh 3 -0.0634876043 -0.292635649 -0.0367245227 0.132109478 0.608936846 0.0764189661 0.105490625 "
        + "0.486241639 0.061021246 @ 0.227198884 -0.892888844 -0.222106248 0.319059461 2.91091573E-09 5.34563283E-09 "
        + "4.14130952E-09 mesh 3 -0.0634876043 -0.292635649 -0.0367245227 0.132109478 0.608936846 0.0764189661 "
        + "0.105490625 0.486241639 0.061021246 @ 0.227198884 -0.892888844 -0.222106248 0.319059461 -0.172537759 "
        + "0.246031627 0.192339465";

    [Fact]
    public void PointsBesideANeedleAreNear()
    {
        QueryRecord pair = QueryRecord.Parse(Beside);
        DistanceResult r = pair.Distance();
        CheckedAnswer check = AnswerCheck.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB, r);
        Assert.True(r.Status == GjkStatus.Separated && check.Status != CheckStatus.Refuted, $"{check}: {r}");
    }

    [Fact]
    public void AWarmStartFromElsewhereFindsTheGap()
    {
        QueryRecord pair = QueryRecord.Parse(Record);
        DistanceResult cold = pair.Distance();
        Assert.Equal(GjkStatus.Separated, cold.Status);
        for (ulong seed = 0; seed < 2000; seed++)
        {
            var rng = new Rng(seed);
            var warm = default(WarmStart);
            Vector3 position = seed == 0
                ? new Vector3(0.013591403f, 0.013591402f, 0.0135914f)
                : pair.PoseB.Position + rng.UnitVector() * rng.LogFloat(1e-9, 1);
            var elsewhere = new RigidPose(Quaternion.Conjugate(pair.PoseB.Rotation), position);
            ConvexQuery.Distance(pair.A, pair.PoseA, pair.B, elsewhere, ref warm);
            DistanceResult r = ConvexQuery.Distance(pair.A, pair.PoseA, pair.B, pair.PoseB, ref warm);
            Assert.True(
                r.Status == GjkStatus.Separated
                    && Math.Abs((double)r.Distance - cold.Distance) <= 2 * Accuracy.Band(cold.Distance, 1),
                $"seed {seed}: {r.Status} {r.Distance:R}, cold {cold.Distance:R}");
        }
    }
}
