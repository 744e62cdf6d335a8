namespace Gjk.Core.Tests.Queries;

/// <summary>Times of impact at the ends of what can be asked: bad input, no size, more turns than steps.</summary>
public class TimeOfImpactLimitTests
{
    private static readonly ConvexShape Cube = ConvexShape.Box(Vector3.One);

    private static readonly RigidMotion Spinning = Still(new Vector3(3, 0, 0), new Vector3(0, 0.5f, 0));

    [Fact]
    public void BadInputIsInvalid()
    {
        RigidMotion still = Still(default);
        Assert.Equal(CastStatus.InvalidInput, ConvexQuery.TimeOfImpact(Cube, default, Cube, Spinning).Status);
        Assert.Equal(CastStatus.InvalidInput, ConvexQuery.TimeOfImpact(Cube, Spinning, Cube, default).Status);
        Assert.Equal(
            CastStatus.InvalidInput, ConvexQuery.TimeOfImpact(default(ConvexShape), still, Cube, Spinning).Status);
        Assert.Equal(
            CastStatus.InvalidInput, ConvexQuery.TimeOfImpact(Cube, still, Cube, Spinning, float.NaN).Status);
        Assert.Equal(
            CastStatus.InvalidInput, ConvexQuery.TimeOfImpact(Cube, still, Cube, still, float.NaN).Status);
        CastResult r = ConvexQuery.TimeOfImpact(Cube, still, Cube, Spinning, 0, float.NaN);
        Assert.Equal(CastStatus.InvalidInput, r.Status);
        Assert.True(float.IsNaN(r.Fraction) && float.IsNaN(r.Point.X) && float.IsNaN(r.Normal.X));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => new RigidMotion(RigidPose.Identity, default, new Vector3(float.NaN, 0, 0)));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => new RigidMotion(RigidPose.Identity, new Vector3(float.PositiveInfinity, 0, 0)));
    }

    [Fact]
    public void AShapeThatContradictsItselfIsInvalid()
    {
        CastResult r = ConvexQuery.TimeOfImpact(BrokenShape.OfNaN, Still(default), Cube, Spinning);
        Assert.True(r.Status is CastStatus.InvalidShape or CastStatus.InvalidInput, $"{r}");
    }

    /// <summary>A negative tolerance is the default, a larger one hits earlier, a tiny one is held to the least and a
    /// huge one to the coarsest.</summary>
    [Fact]
    public void TheToleranceIsHonoured()
    {
        var falling = new RigidMotion(
            new RigidPose(new Vector3(0, 5, 0)), new Vector3(0, -10, 0), new Vector3(0, 3, 0));
        float exact = 0.3f, usual = Fraction(0);
        Assert.Equal(usual, Fraction(-1));
        Assert.InRange(usual, exact - 2e-6, exact);
        Assert.InRange(Fraction(0.005f), exact - 0.0005, exact - 0.00005);
        Assert.InRange(Fraction(1e-30f), exact - 2e-7, exact);
        Assert.Equal(Fraction(0.1f), Fraction(1e30f));

        float Fraction(float tolerance)
        {
            CastResult r = ConvexQuery.TimeOfImpact(Cube, Still(default), Cube, falling, tolerance);
            Assert.Equal(CastStatus.Hit, r.Status);
            return r.Fraction;
        }
    }

    [Fact]
    public void TheLargestFractionIsHonoured()
    {
        var falling = new RigidMotion(
            new RigidPose(new Vector3(0, 5, 0)), new Vector3(0, -2, 0), new Vector3(0, 0.1f, 0));
        Assert.Equal((CastStatus.Miss, 1f), Asked(1));
        Assert.Equal((CastStatus.Miss, 1.4999f), Asked(1.4999f));
        Assert.Equal(CastStatus.Hit, Asked(1.5001f).Status);
        Assert.Equal(CastStatus.Hit, Asked(float.PositiveInfinity).Status);
        Assert.Equal((CastStatus.Miss, 0f), Asked(-3));

        (CastStatus Status, float Fraction) Asked(float most)
        {
            CastResult r = ConvexQuery.TimeOfImpact(Cube, Still(default), Cube, falling, 0, most);
            return (r.Status, r.Fraction);
        }
    }

    /// <summary>A round body that spins about almost its own axis sinks slowly onto a floor: the steps run out, and the
    /// fraction says how far they are proved apart. Spins that no double can follow end where the balls meet.</summary>
    [Theory]
    [InlineData(1e5f)]
    [InlineData(1e9f)]
    [InlineData(3e38f)]
    public void MoreTurnsThanStepsSaySo(float turn)
    {
        var body = ConvexShape.Ellipsoid(new Vector3(1, 0.4f, 1));
        var pose = new RigidPose(Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 2), new(0, 2.001f, 0));
        var sinking = new RigidMotion(pose, new Vector3(0, -0.0015f, 0), new Vector3(0, 0.002f, -0.9f) * turn);
        foreach (float most in new[] { 1, 1e30f, float.PositiveInfinity })
        {
            CastResult r = ConvexQuery.TimeOfImpact(Cube, Still(default), body, sinking, 0, most);
            Assert.Equal(CastStatus.IterationLimit, r.Status);
            Assert.InRange(r.Fraction, 0, 0.667);
            Assert.True(float.IsNaN(r.Point.X) && float.IsNaN(r.Normal.X));
            Assert.True(turn > 1e6f || r.Fraction > 0.01f, $"{r}");
        }

        // Out of each other's reach nothing has to be followed.
        Assert.Equal(
            CastStatus.Miss,
            ConvexQuery.TimeOfImpact(
                Cube, Still(default, new Vector3(turn, 0, 0)), Cube, Still(new Vector3(4, 0, 0), Vector3.One)).Status);
        Assert.Equal(
            CastStatus.IterationLimit,
            ConvexQuery.TimeOfImpact(
                Cube, Still(default, new Vector3(turn, 0, 0)), Cube, Still(new Vector3(2.7f, 0, 0), Vector3.One * 1e9f))
                .Status);
    }

    /// <summary>Points have no size; what they turn on has.</summary>
    [Fact]
    public void PointsMeet()
    {
        var arm = ConvexShape.Mesh([Vector3.UnitX]);
        RigidMotion turning = Still(default, new Vector3(0, 0, MathF.PI));
        CastResult r = ConvexQuery.TimeOfImpact(arm, turning, ConvexShape.Point(), Still(Vector3.UnitY));
        Assert.Equal(CastStatus.Hit, r.Status);
        Assert.InRange(r.Fraction, 0.49999, 0.5);
        Assert.True((r.Point - Vector3.UnitY).Length() < 1e-4f, $"{r}");
        r = ConvexQuery.TimeOfImpact(arm, turning, ConvexShape.Point(), Still(new Vector3(0, 1.1f, 0)));
        Assert.Equal(CastStatus.Miss, r.Status);
        r = ConvexQuery.TimeOfImpact(
            ConvexShape.Point(), Still(default, Vector3.One), ConvexShape.Point(),
            new RigidMotion(new RigidPose(Vector3.UnitX), new Vector3(-2, 0, 0)));
        Assert.Equal(CastStatus.Hit, r.Status);
        Assert.InRange(r.Fraction, 0.4999, 0.5);
    }

    /// <summary>Balls that fill the balls about their positions do not touch where these do.</summary>
    [Fact]
    public void BallsMeetAsBallsDo()
    {
        CastResult r = ConvexQuery.TimeOfImpact(
            new SphereShape(1), Still(default, Vector3.One), new SphereShape(0.5f),
            new RigidMotion(new RigidPose(new Vector3(4, 0, 0)), new Vector3(-5, 0, 0), Vector3.One));
        Assert.Equal(CastStatus.Hit, r.Status);
        Assert.Equal(1, r.Normal.X, 1e-6f);
        Assert.InRange(r.Fraction, 0.5 - 3e-6, 0.5);
        Assert.Equal(1, r.Point.X, 1e-4f);
    }

    /// <summary>Typed shapes and ConvexShape have the same bits, and nothing is allocated.</summary>
    [Fact]
    public void TypedShapesGiveTheSameBits()
    {
        var box = new BoxShape(new Vector3(0.5f, 1, 0.7f));
        var capsule = new CapsuleShape(0.3f, 1);
        var falling = new RigidMotion(
            new RigidPose(new Vector3(0.3f, 5, 0.1f)), new Vector3(0, -6, 0), new Vector3(3, 2, 1));
        CastResult typed = default, closed = default;
        ConvexShape closedBox = ConvexShape.Box(new Vector3(0.5f, 1, 0.7f));
        var closedCapsule = ConvexShape.Capsule(0.3f, 1);
        Assert.Equal(0, Allocation.Least(() =>
        {
            for (int i = 0; i < 100; i++)
            {
                typed = ConvexQuery.TimeOfImpact(box, Spinning, capsule, falling);
                closed = ConvexQuery.TimeOfImpact(closedBox, Spinning, closedCapsule, falling);
            }
        }));
        Assert.Equal(
            (closed.Status, closed.Fraction, closed.Iterations), (typed.Status, typed.Fraction, typed.Iterations));
    }

    private static RigidMotion Still(Vector3 position, Vector3 turn = default) =>
        new(new RigidPose(position), default, turn);
}
