namespace Gjk.Core.Tests.Regression;

/// <summary>A swapped result negated its normal with System.Numerics, which makes -0 of 0 on .NET and 0 on Mono: a cast
/// of a point that overlaps at the start had other bits there.</summary>
public class SwappedZeroTests
{
    [Fact]
    public void ZerosOfASwappedNormalAreZeros()
    {
        ConvexShape point = ConvexShape.Point(), ball = ConvexShape.Capsule(1, 1);
        CastResult cast = ConvexQuery.Cast(
            point, RigidPose.Identity, Vector3.UnitX, ball, RigidPose.Identity, Vector3.Zero);
        Assert.Equal(CastStatus.OverlappingAtStart, cast.Status);
        HasPlainZeros(cast.Swapped.Normal);
        DistanceResult distance = ConvexQuery.Distance(point, RigidPose.Identity, ball, RigidPose.Identity);
        HasPlainZeros(distance.Swapped.Normal);
        HasPlainZeros(default(ContactManifold).Swapped.Normal);
    }

    private static void HasPlainZeros(Vector3 v)
    {
        foreach (float x in new[] { v.X, v.Y, v.Z })
            Assert.True(x != 0 || BitConverter.SingleToInt32Bits(x) == 0, "a component is -0");
    }
}
