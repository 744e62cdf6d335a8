using System;
using System.Numerics;

namespace Gjk.Core.Tests.Regression;

/// <summary>
/// A swapped result negated its normal with System.Numerics, which makes -0 of 0 on .NET and 0 on Mono: a cast of a
/// point that overlaps at the start had other bits there.
/// </summary>
public class SwappedZeroTests
{
    [Fact]
    public void ZerosOfASwappedNormalAreZeros()
    {
        ConvexShape point = ConvexShape.Point(), ball = ConvexShape.Capsule(1, 1);
        CastResult cast = ConvexQuery.Cast(
            point, RigidPose.Identity, Vector3.UnitX, ball, RigidPose.Identity, Vector3.Zero);
        Assert.Equal(CastStatus.OverlappingAtStart, cast.Status);
        AreZeros(cast.Normal);
        AreZeros(cast.Swapped.Normal);
        DistanceResult distance = ConvexQuery.Distance(point, RigidPose.Identity, ball, RigidPose.Identity);
        AreZeros(distance.Swapped.Normal);
        AreZeros(default(ContactManifold).Swapped.Normal);
    }

    private static void AreZeros(Vector3 v)
    {
        Assert.Equal(0, BitConverter.SingleToInt32Bits(v.X));
        Assert.Equal(0, BitConverter.SingleToInt32Bits(v.Y));
        Assert.Equal(0, BitConverter.SingleToInt32Bits(v.Z));
    }
}
