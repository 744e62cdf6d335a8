namespace Gjk.Core.Tests.Solvers;

/// <summary>The tolerances of casts, each from both sides; the numbers are written out.</summary>
public class CastToleranceTests
{
    /// <summary>A rounding in double, 2^-53.</summary>
    private const double U = 1.0 / (1L << 53);

    /// <summary>Two balls of radius 1 in all, three apart on a line through both centres.</summary>
    [Fact]
    public void TheLineIsKnownToThirtyTwoRoundings()
    {
        CastLine line = Line();
        Assert.Equal(MotionVerdict.Hit, CastLine.Make(Frame(), new Double3(4, 0, 0), out _));
        Assert.InRange(line.Error, 20 * U * (1 + 3), 45 * U * (1 + 3));
    }

    /// <summary>The balls are a millionth of a millionth too large, and cores that touch with them are apart
    /// there.</summary>
    [Fact]
    public void TheBallsAreTakenALittleLarger() => Assert.InRange(Line().HalfChord - 1, 0.6e-12, 1.6e-12);

    /// <summary>A way so long, and a motion so short, that no fraction leads to its middle.</summary>
    [Fact]
    public void ALineWithoutAMiddleIsAPoint()
    {
        PairFrame frame = Frame();
        frame.Translation = new Double3(1e150, 0, 0);
        Assert.Equal(MotionVerdict.Undecided, CastLine.Make(frame, new Double3(1e-161, 0, 0), out CastLine line));
        Assert.Equal(default, line.Axis);
    }

    [Theory]
    [InlineData(8, false)]
    [InlineData(32, true)]
    public void AFractionIsBeyondBySixteenRoundings(double roundings, bool isBeyond) =>
        Assert.Equal(isBeyond, CastSolver.IsBeyond(0.75 * (1 + roundings * U), 0.75));

    /// <summary>A plane is crossed, and nothing is behind it: where it was crossed by no more than four times the
    /// line's error, they have met.</summary>
    [Theory]
    [InlineData(2, true)]
    [InlineData(8, false)]
    public void APlaneThatIsCrossedByLittleIsMet(double errors, bool isMet)
    {
        CastLine line = Line();
        PairFrame frame = Frame();
        CastJump.Make(line, 1, out CastJump place);
        CastFinding cast = default;
        Assert.False(place.TryEnd(Apart(1, 0.5), frame, line, 0, ref cast));
        Assert.True(place.TryEnd(Apart(-1, errors * line.Error), frame, line, 0, ref cast));
        Assert.Equal(isMet ? MotionVerdict.Hit : MotionVerdict.Miss, cast.Outcome);
    }

    /// <summary>Two balls, of radius 1 in all, that pass each other on a way of 1, a little further apart.</summary>
    [Theory]
    [InlineData(16, CastStatus.Hit)]
    [InlineData(64, CastStatus.Miss)]
    public void BallsThatPassByThirtyTwoRoundingsTouch(double roundings, CastStatus status)
    {
        float aside = (float)Math.Sqrt(2 * roundings * U * (1 + 1));
        CastResult r = ConvexQuery.Cast(
            new SphereShape(0.5f), RigidPose.Identity, default, new SphereShape(0.5f),
            new RigidPose(new Vector3(-1, 1, aside)), new Vector3(2, 0, 0));
        Assert.Equal(status, r.Status);
    }

    private static PairFrame Frame() => new() { RadiusA = 1, Translation = new Double3(-3, 0, 0) };

    private static CastLine Line()
    {
        CastLine.Make(Frame(), new Double3(4, 0, 0), out CastLine line);
        return line;
    }

    /// <summary>A distance that is a plane square to the line.</summary>
    /// <param name="slope">1 where B moves towards it, -1 where away.</param>
    /// <param name="gap">To the plane.</param>
    private static SolverState Apart(double slope, double gap)
    {
        SolverState state = default;
        state.Verdict = Verdict.Apart;
        state.Feature = new ClosestFeature { Normal = new Double3(slope, 0, 0), Height = gap, NormalSquared = 1 };
        state.Plane.Set(state.Feature, gap);
        return state;
    }
}
