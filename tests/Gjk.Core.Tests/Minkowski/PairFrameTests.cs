using System;
using System.Linq;
using System.Numerics;
using Gjk.Core.Tests.Support;

namespace Gjk.Core.Tests.Minkowski;

/// <summary>The relative pose of a pair, against its composition in fractions.</summary>
public class PairFrameTests
{
    private const int Tries = 300;

    /// <summary>Ratio: some dozens of roundings to double (2^-53 each).</summary>
    private const double Rounding = 64.0 / (1L << 53);

    /// <summary>Ratio to how far the centres are from their local origins: what is lost in double-double.</summary>
    private static readonly double OffsetRounding = Math.ScaleB(1, -90);

    [Fact]
    public void RotationsAreThoseOfThePoses() => ForPairs(1, 1, (a, b, frame) =>
    {
        var exactA = new ExactPose(a.Pose);
        var exactB = new ExactPose(b.Pose);
        for (int i = 0; i < 9; i++)
        {
            Fraction relative = Enumerable.Range(0, 3).Select(k => exactA[k, i / 3] * exactB[k, i % 3])
                .Aggregate((Fraction)0, (sum, x) => sum + x);
            AssertNear(relative, Entry(frame.Rotation, i), Rounding, a);
            AssertNear(exactA[i / 3, i % 3], Entry(frame.RotationA, i), Rounding, a);
        }
    });

    /// <summary>Far from the origin of the world, both positions cancel before anything is rounded.</summary>
    [Theory]
    [InlineData(1, 1)]
    [InlineData(1e6, 1)]
    [InlineData(1e30, 1)]
    public void TheTranslationIsRoundedByNoMoreThanItsParts(double position, double offset) =>
        ForPairs(position, offset, (a, b, frame) =>
        {
            Vector3D between = (Vector3D)b.Pose.Position - a.Pose.Position;
            double parts = between.Length + a.Shape.Center.Length + b.Shape.Center.Length;
            AssertTranslation(a, b, frame, Rounding * parts);
        });

    /// <summary>Far from the local origins, the centres are turned in double-double.</summary>
    [Theory]
    [InlineData(1, 1e4)]
    [InlineData(1e6, 1e6)]
    public void FarCentersAreRotatedWithoutLoss(double position, double offset) =>
        ForPairs(position, offset, (a, b, frame) => AssertTranslation(
            a, b, frame,
            Rounding * frame.Translation.Length + OffsetRounding * (a.Shape.Center.Length + b.Shape.Center.Length)));

    [Fact]
    public void TheMagnitudeIsAboveEveryLengthAndUnitSizeBringsItBetweenOneAndTwo() =>
        ForPairs(100, 10, (a, b, frame) =>
    {
        double longest = new[]
        {
            frame.Translation.Length, a.Shape.BoundingRadius, b.Shape.BoundingRadius, a.Shape.Margin, b.Shape.Margin,
        }.Max();
        Assert.InRange(frame.Magnitude, longest, 10 * longest);
        double magnitude = frame.Magnitude, distance = frame.Translation.Length;
        frame.ToUnitSize(frame.UnitFactor);
        Assert.InRange(frame.Magnitude, 1, 2);
        Assert.Equal(magnitude, frame.Magnitude * frame.Unit);
        Assert.Equal(distance, frame.Translation.Length * frame.Unit, Rounding * distance);
    });

    [Fact]
    public void OnlyRotationsAndShapesWithSizesAreValid()
    {
        var sphere = ConvexShape.Sphere(1);
        ConvexShape none = default;
        Assert.True(Compose(new Posed(sphere, RigidPose.Identity), new Posed(sphere, RigidPose.Identity)).IsValid);
        Assert.False(Compose(new Posed(sphere, default), new Posed(sphere, RigidPose.Identity)).IsValid);
        Assert.False(Compose(new Posed(sphere, RigidPose.Identity), new Posed(sphere, default)).IsValid);
        Assert.True(Compose(new Posed(sphere, RigidPose.Identity), new Posed(sphere, RigidPose.Identity)).ArePoints);
        Assert.Equal(0, none.Margin);
    }

    [Fact]
    public void TheFirstNormalPointsFromTheSecondCenterToTheFirst()
    {
        var sphere = ConvexShape.Sphere(1);
        var apart = new Posed(sphere, new RigidPose(new Vector3(0, 3, 0)));
        PairFrame frame = Compose(new Posed(sphere, RigidPose.Identity), apart);
        Assert.Equal(new Vector3D(0, -3, 0), frame.FirstNormal);
        Assert.Equal(new Vector3D(1, 0, 0), Compose(apart, apart).FirstNormal);
    }

    private static void AssertTranslation(Posed a, Posed b, in PairFrame frame, double allowed)
    {
        Fraction[] placeA = new ExactPose(a.Pose).Place(a.Shape.Center);
        Fraction[] placeB = new ExactPose(b.Pose).Place(b.Shape.Center);
        Fraction[] exact = new ExactPose(a.Pose).InverseRotate([.. placeB.Zip(placeA, (y, x) => y - x)]);
        AssertNear(exact[0], frame.Translation.X, allowed, a);
        AssertNear(exact[1], frame.Translation.Y, allowed, a);
        AssertNear(exact[2], frame.Translation.Z, allowed, a);
    }

    private static void AssertNear(Fraction expected, double actual, double allowed, Posed a) =>
        Assert.True((expected - actual).Absolute <= allowed, $"{actual:R} is off by more than {allowed:R}: {a.Pose}");

    private static double Entry(in RotationD m, int i) =>
        new[] { m.M00, m.M01, m.M02, m.M10, m.M11, m.M12, m.M20, m.M21, m.M22 }[i];

    /// <summary>Hulls around a place far from their own origin, at two places near each other in the world.</summary>
    private static void ForPairs(double position, double offset, Action<Posed, Posed, PairFrame> examine)
    {
        for (ulong seed = 0; seed < (ulong)Budget.Count(Tries); seed++)
        {
            var rng = new Rng(seed);
            Vector3 place = rng.Direction() * (float)position;
            Posed a = Any(rng, place, offset), b = Any(rng, place, offset);
            examine(a, b, Compose(a, b));
        }
    }

    private static Posed Any(Rng rng, Vector3 place, double offset)
    {
        Vector3 middle = rng.Direction() * (float)offset;
        Vector3[] cloud = Generators.Cloud(rng, 8, Vector3.One);
        var shape = ConvexShape.Mesh([.. cloud.Select(p => p + middle)]);
        return new Posed(shape, new RigidPose(rng.Rotation(), place + rng.Vector(-3, 3)));
    }

    private static PairFrame Compose(Posed a, Posed b)
    {
        ConvexShape shapeA = a.Shape, shapeB = b.Shape;
        PairFrame.Compose(ref shapeA, a.Pose, ref shapeB, b.Pose, out PairFrame frame);
        return frame;
    }

    private sealed record Posed(ConvexShape Shape, RigidPose Pose);
}
