namespace Gjk.Core.Tests.Queries;

/// <summary>The tolerances of times of impact, each from both sides; the numbers are written out.</summary>
public class ImpactToleranceTests
{
    private const float StartGap = 1.0f / (1 << 10);

    /// <summary>A step aims at a quarter of the tolerance. The cube falls so short a way that its float is finer than
    /// that.</summary>
    [Fact]
    public void ATinyToleranceIsAHundredMillionthOfTheSize()
    {
        RigidMotion falling = Falling(2 + StartGap, 1);
        CastResult r = ConvexQuery.TimeOfImpact(Cube, Still, Cube, falling, 1e-30f);
        Assert.Equal(CastStatus.Hit, r.Status);
        double size = 2 * Math.Sqrt(3);
        Assert.InRange((StartGap - (double)r.Fraction) / (1e-8 * size), 0.15, 0.4);
    }

    /// <summary>However far apart the cubes are at the start, what is asked for.</summary>
    [Theory]
    [InlineData(0.1f)]
    [InlineData(1)]
    [InlineData(float.PositiveInfinity)]
    public void AHugeToleranceIsTwoThousandthsOfTheSize(float tolerance)
    {
        const float gap = 0.5f;
        CastResult r = ConvexQuery.TimeOfImpact(Cube, Still, Cube, Falling(2 + gap, 1), tolerance);
        Assert.Equal(CastStatus.Hit, r.Status);
        double size = 2 * Math.Sqrt(3);
        Assert.InRange((gap - (double)r.Fraction) / (2e-3 * size), 0.15, 0.4);
    }

    /// <summary>The tip of a segment turns into a floor, at most a million radians far: so long a way rounds by more
    /// than that.</summary>
    [Fact]
    public void ATinyToleranceIsSixtyFourRoundingsOfTheWay()
    {
        var hand = ConvexShape.Segment(Vector3.Zero, Vector3.UnitX);
        var floor = ConvexShape.Box(new Vector3(2, 1, 2));
        CastResult r = ConvexQuery.TimeOfImpact(
            hand, new RigidMotion(RigidPose.Identity, default, Vector3.UnitZ), floor,
            new RigidMotion(new RigidPose(new Vector3(0, 1 + StartGap, 0)), default), 1e-30f, 1e6f);
        Assert.Equal(CastStatus.Hit, r.Status);
        double way = 1e6, rounding = 16.0 / (1L << 53) * way;
        Assert.InRange((StartGap - Math.Sin(r.Fraction)) / (64 * rounding), 0.15, 0.4);
    }

    /// <summary>Of the tolerance, a gap is accepted that leaves room for the fraction's own float, which is 2^-23 of
    /// the way at most: no more than a half, and no less than an eighth. A step aims at half of that.</summary>
    [Theory]
    [InlineData(0.1, 0.5)]
    [InlineData(0.82, 0.18)]
    [InlineData(10, 0.125)]
    public void TheGapThatIsAcceptedLeavesRoomForTheFraction(double ratio, double accepted)
    {
        var cube = new BoxShape(Vector3.One);
        RigidMotion falling = Falling(12, 20);
        PairFrame.Compose(ref cube, RigidPose.Identity, ref cube, falling.Pose, out PairFrame frame);
        PairMotion.Make(Still, falling, frame, out PairMotion motion);
        double fraction = 0.5, tolerance = motion.Speed * fraction / (1 << 23) / ratio;
        WarmStart warm = default;
        AdvancementSolver<BoxShape, BoxShape>.Solve(
            ref cube, ref cube, ref frame, ref motion, new FractionInterval(0, 1), tolerance,
            Impact.FloorRatio * tolerance, leaves: true, ref warm, out Impact impact, out _);
        Assert.Equal(MotionVerdict.Hit, impact.Outcome);
        Assert.InRange((10 - 20 * impact.Fraction) / tolerance, 0.4 * accepted, 0.6 * accepted);
    }

    private static ConvexShape Cube => ConvexShape.Box(Vector3.One);

    private static RigidMotion Still => new(RigidPose.Identity, default);

    /// <summary>It turns about the way that it falls, so that the gap does not depend on the turn.</summary>
    private static RigidMotion Falling(float from, float speed) =>
        new(new RigidPose(new Vector3(0, from, 0)), new Vector3(0, -speed, 0), new Vector3(0, 1e-3f, 0));
}
