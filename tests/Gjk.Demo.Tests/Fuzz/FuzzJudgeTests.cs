using Gjk.Exact.Fuzz;
using Gjk.Exact.Fuzz.Promises;

namespace Gjk.Demo.Tests.Fuzz;

/// <summary>Right answers that are hard to judge.</summary>
public sealed class FuzzJudgeTests
{
    /// <summary>A point on an arm comes as near as the tolerance of its arm, because points have no size.</summary>
    [Fact]
    public void PointsThatTurnHaveTheToleranceOfTheirArms() => Assert.Null(ImpactsAreProved.Broken(Of(
        "gjk1 mesh 1 0.0430401824 -0.348952204 -0.158381388 @ 0 0 0 1 0 0 0"
        + " mesh 1 -0.826645851 -0.958721638 -0.352537036 @ 0.310775518 0.916098893 -0.0389634147 0.251926839"
        + " 0.199117318 0.795615733 -0.784781456 ~ -4.81623794E-17 3.33331457E-15 -3.51336328E-15 0 0 0")));

    /// <summary>An edge of a box grazes the rim of a cap that lies in a face: the plane of the hit shows it.</summary>
    [Fact]
    public void AnEdgeThatGrazesARimIsApartBeforeTheHit() => Assert.Null(CastProof.Broken(Of(
        "gjk1 box 1 1 1 @ 0 0 0 1 0 0 0 ~ -2.00000003E-16 1.18119264 -0.470637172 0 0 0"
        + " cylinder 0.6301952600479126 0.22282838821411133 0 @ -0.5 -0.5 0.5 -0.5 -1.22282839 -0.5 -1.87759829")));

    /// <summary>The plane of the hit is known to the rounding of floats only, which turns it by more than a line leaves
    /// that grazes a cone.</summary>
    [Fact]
    public void ALineThatGrazesAConeIsApartBeforeTheHit() => Assert.Null(CastProof.Broken(Of(
        "gjk1 cone 0.24289815127849579 0.69878131151199341 0 * -0.87080585956573486 -0.99257045984268188"
        + " -1.7734049558639526 @ 0 0 0 1 0.575152397 0.832740963 0.0429912992 ~ -2.46912551 -1.82530534 0.387052238"
        + " 0 0 0 point 0 @ 0 0 0 1 0.275716007 0.920022905 0.406582862")));

    /// <summary>A plate without thickness has an inside in its own plane only, and leaves it.</summary>
    [Fact]
    public void APlateThatLeavesItsPlaneMisses() => Assert.Null(CastProof.Broken(Of(
        "gjk1 box 0 0.40000000000000002 0.5 @ 0 0 0 1 0 -0.5 2 ~ 3.99999994E-17 0 1 0 0 0"
        + " cylinder 0 0 0 @ 0 0 0 1 0 -0.899999976 3")));

    /// <summary>A point grazes the rim of a disc within its plane, which it leaves by less than a rounding.</summary>
    [Fact]
    public void APointThatGrazesADiscMisses() => Assert.Null(CastProof.Broken(Of(
        "gjk1 point 0 @ 0 0 0 1 -2 -1 -0.5 ~ 1.1257683 3.99999994E-17 1.61676168 0 0 0"
        + " cylinder 0.5 0 0 @ 0 0 0 1 -2 -1 0.375")));

    /// <summary>A depth below half the least float is a touch.</summary>
    [Fact]
    public void ADepthBelowTheFloatsIsATouch() => Assert.Null(CastProof.Broken(Of(
        "gjk1 point 5.6889634794966058E-40 @ 0 0 0 1 0 0 0 point 1.11238E-40 @ 0 0 0 1 4.96393165E-40 -3.68359327E-40"
        + " 2.83702683E-40 ~ 0 0 -7.00004635E-41 0 0 0")));

    private static FuzzPair Of(string record)
    {
        QueryRecord read = QueryRecord.Parse(record);
        var pair = new FuzzPair(read.A, read.PoseA, read.B, read.PoseB);
        return pair.Moving(new PairMotion(read.MotionA.Velocity, read.MotionB.Velocity));
    }
}
