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
            Double3 between = (Double3)b.Pose.Position - a.Pose.Position;
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
        Assert.Equal(new Double3(0, -3, 0), frame.FirstNormal);
        Assert.Equal(new Double3(1, 0, 0), Compose(apart, apart).FirstNormal);
    }

    /// <summary>A normal that a query has kept has the length 1 but for float's rounding, and is taken.</summary>
    [Fact]
    public void AKeptNormalIsTheFirst()
    {
        var warm = default(WarmStart);
        PairFrame frame = default;
        Assert.Equal(frame.FirstNormal, warm.FirstNormal(frame));
        warm.SetNormal(new Double3(0, 3, 4));
        Assert.Equal(new Double3(0, 0.6f, 0.8f), warm.FirstNormal(frame));
    }

    /// <summary>Four to sixteen radii from their local origins, two centres that nearly coincide: double would lose
    /// their difference.</summary>
    [Fact]
    public void CentersThatAreEightRadiiOffAreFar()
    {
        int count = 0;
        for (ulong seed = 0; seed < 200; seed++)
        {
            var rng = new Rng(seed);
            Posed a = Any(rng, default, 5), b = Any(rng, default, 5);
            double ratio = (a.Shape.Center.SumOfMagnitudes + b.Shape.Center.SumOfMagnitudes)
                / (a.Shape.BoundingRadius + b.Shape.BoundingRadius);
            if (ratio < 4.5 || ratio > 15) continue;
            count++;
            Double3 between = new RotationD(a.Pose.Rotation).Rotate(a.Shape.Center)
                - new RotationD(b.Pose.Rotation).Rotate(b.Shape.Center);
            a = a with { Pose = new RigidPose(a.Pose.Rotation, Vector3.Zero) };
            b = b with { Pose = new RigidPose(b.Pose.Rotation, (Vector3)between) };
            AssertTranslation(a, b, Compose(a, b), 1e-20);
        }

        Assert.InRange(count, 50, 200);
    }

    /// <summary>Beside centres of 1, a difference of 2^-90 is what double-double loses, and one of 2^-88 is
    /// not.</summary>
    [Theory]
    [InlineData(-90, 0)]
    [InlineData(-88, 1)]
    public void CentersThatNearlyCoincideDo(int exponent, double factor)
    {
        var away = new Vector3((float)Math.ScaleB(1, exponent), 0, 0);
        Double3 center = new(0, 1, 0);
        Double3 between = PairFrame.BetweenCenters(RigidPose.Identity, center, new RigidPose(away), center);
        Assert.Equal((Double3)away * factor, between);
    }

    [Theory]
    [InlineData(5e149, GjkStatus.Separated)]
    [InlineData(2e150, GjkStatus.InvalidInput)]
    public void LengthsEndAtTheLargestMagnitude(double length, GjkStatus status)
    {
        var shape = new ScriptedShape([new Double3(length, 0, 0)]);
        Assert.Equal(
            status,
            ConvexQuery.Distance(shape, RigidPose.Identity, new PointShape(), new RigidPose(Vector3.UnitX)).Status);
    }

    [Theory]
    [InlineData(-61, false)]
    [InlineData(-59, true)]
    [InlineData(59, true)]
    [InlineData(61, false)]
    public void SizesOfUpToSixtyPowersOfTwoAreOrdinary(int exponent, bool isOrdinary)
    {
        double length = Math.ScaleB(1, exponent);
        Assert.Equal(isOrdinary, PairFrame.IsOrdinarySize(length * length));
        Assert.Equal(isOrdinary, new PairFrame { Magnitude = length }.IsOrdinary);
    }

    /// <summary>What a shape of a user says of its size is an upper bound only: what counts are the points that it
    /// gives, with its margin, and no more than its radius.</summary>
    [Theory]
    [InlineData(3, 5, 3.5 + 5.25)]
    [InlineData(30, 5, 8 + 5.25)]
    [InlineData(3, 50, 3.5 + 9)]
    public void TheSizeIsThatOfThePointsSeen(double reachA, double reachB, double size)
    {
        var frame = new PairFrame { RadiusA = 8, RadiusB = 9, MarginA = 0.5, MarginB = 0.25 };
        PairSize.Make<ScriptedShape, ScriptedShape>(frame, out PairSize seen);
        Assert.Equal(0.75, seen.Value);
        seen.Observe(frame, new Double3(reachA, 0, 0), new Double3(0, reachB, 0));
        Assert.Equal(size, seen.Value);
        seen.Observe(frame, default, default);
        Assert.Equal(size, seen.Value);
        PairSize.Make<BoxShape, PointShape>(frame, out PairSize told);
        Assert.Equal(17, told.Value);
    }

    /// <summary>A bounding radius that may be generous is measured, on either side; a tight one stays.</summary>
    [Fact]
    public void GenerousRadiiAreTightened()
    {
        var generous = new ScriptedShape([new Double3(1, 0, 0)], radius: 8);
        var box = new BoxShape(Vector3.One);
        PairFrame.Compose(ref generous, RigidPose.Identity, ref box, RigidPose.Identity, out PairFrame frame);
        frame.TightenRadii(ref generous, ref box);
        Assert.Equal((1.0, box.BoundingRadius), (Math.Round(frame.RadiusA, 12), frame.RadiusB));
        PairFrame.Compose(ref box, RigidPose.Identity, ref generous, RigidPose.Identity, out frame);
        frame.TightenRadii(ref box, ref generous);
        Assert.Equal((box.BoundingRadius, 1.0), (frame.RadiusA, Math.Round(frame.RadiusB, 12)));
        Assert.Equal(frame.Radius, frame.Magnitude);
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
            Vector3 place = rng.UnitVector() * (float)position;
            Posed a = Any(rng, place, offset), b = Any(rng, place, offset);
            examine(a, b, Compose(a, b));
        }
    }

    private static Posed Any(Rng rng, Vector3 place, double offset)
    {
        Vector3 middle = rng.UnitVector() * (float)offset;
        Vector3[] cloud = Clouds.InBox(rng, 8, Vector3.One);
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
