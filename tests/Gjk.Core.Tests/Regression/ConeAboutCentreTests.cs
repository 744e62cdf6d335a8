namespace Gjk.Core.Tests.Regression;

/// <summary>A flat cone about the centre of a ball left it along a normal that was shorter than 1, and with a depth of
/// it: across the cone's axis there was only rounding, which leant along the axis.</summary>
public class ConeAboutCentreTests
{
    private const int Pairs = 3000;

    [Theory]
    [InlineData("gjk1 cone 0.0080666560679674149 2.0201168808853254E-05 0 "
        + "* 75.208648681640625 75.208648681640625 75.208648681640625 @ 0 0 0 1 0 0 0 "
        + "point 4.1456995010375977 @ 0 0 0 1 0 0 0 ~ 12.6469145 4.67700338 -9.12939072 0 0 0")]
    [InlineData("gjk1 point 0.82546943426132202 @ 0.100991972 0.279336333 0.634373486 -0.713682115 0 0 0 "
        + "cone 0.0014931318582966924 2.4838095669110771E-06 0 "
        + "* 0.1000790074467659 0.1000790074467659 0.1000790074467659 "
        + "@ -0.11610999 -0.885464132 0.446845025 0.0529281534 0 0 0 ~ -2.20971417 -16.4007874 -10.8035545 0 0 0")]
    [InlineData("gjk1 cone 0.19417504966259003 0.00030820610118098557 0 + 0.38424676656723022 "
        + "@ -0.0140472809 -0.0182757806 0.0123283993 -0.999658287 0 0 0 "
        + "point 0.031391382217407227 @ 0 0 0 1 0 0 0 ~ 16.61763 -8.26396751 -3.73843527 0 0 0")]
    public void TheWayOutIsAcrossTheSide(string record)
    {
        QueryRecord r = QueryRecord.Parse(record);
        CastResult cast = r.Cast();
        Assert.Equal(CastStatus.OverlappingAtStart, cast.Status);
        Assert.Equal(1, cast.Normal.Length(), 1e-6f);
        CheckedAnswer check = AnswerCheck.Cast(
            r.A, r.PoseA, r.MotionA.Velocity, r.B, r.PoseB, r.MotionB.Velocity, cast);
        Assert.NotEqual(CheckStatus.Refuted, check.Status);
    }

    [Fact]
    public void TheDepthIsThatOfTheSide()
    {
        var rng = new Rng(44);
        for (int i = 0; i < Pairs; i++)
        {
            float radius = rng.LogFloat(1e-3, 10), half = radius * rng.LogFloat(1e-3, 0.1);
            float ball = radius * rng.LogFloat(0.1, 100);
            var pose = new RigidPose(rng.Rotation(), default);
            DistanceResult r = ConvexQuery.SignedDistance(
                new ConeShape(radius, half), pose, new SphereShape(ball), RigidPose.Identity);
            double side = (double)half * radius / Math.Sqrt((double)radius * radius + 4.0 * half * half);
            string where = $"{r}: cone {radius:R}, {half:R}, ball {ball:R}, {pose.Rotation}";
            Assert.True(Math.Abs(ball + side + r.Distance) <= 2e-7 * (ball + radius), where);
            Assert.True(Math.Abs(((Double3)r.Normal).Length - 1) <= 1e-6, where);
        }
    }
}
