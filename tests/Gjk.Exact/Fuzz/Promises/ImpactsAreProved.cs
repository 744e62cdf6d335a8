namespace Gjk.Exact.Fuzz.Promises;

/// <summary>A time of impact of the pair when it turns as well: before the fraction nothing overlaps, at it the shapes
/// are within the tolerance, and where they miss, nothing overlaps at all.</summary>
/// <remarks>The motion is looked at in steps, and more closely before the fraction, at poses rounded to float. So an
/// overlap counts where it is deeper than that rounding, and a gap where it is wider than the tolerance by as
/// much.</remarks>
internal static class ImpactsAreProved
{
    /// <summary>Looks at the whole way, and at its last parts, each half of the one before.</summary>
    private const int Looks = 24, CloserLooks = 16;

    /// <summary>Ratio: what rounding a pose to float moves its points by, relative to their distances.</summary>
    private const double PoseRounding = 4e-7;

    /// <summary>Ratio of the pair's scale: the tolerance that is used where none is given.</summary>
    private const double Tolerance = 1e-5;

    /// <summary>Ratio of the pair's scale: longer ways leave poses in float too few digits to check anything.</summary>
    private const double LongestWay = 1e4;

    public static string? Broken(FuzzPair pair)
    {
        if (!(pair.Scale > 0) || pair.Motion.Length > LongestWay * pair.Scale) return null;
        (RigidMotion a, RigidMotion b) = Turning.Of(pair);
        return Problem(pair, a, b, ConvexQuery.TimeOfImpact(pair.A, a, pair.B, b));
    }

    /// <summary>What is wrong with an answer, which may be a lie.</summary>
    public static string? Problem(FuzzPair pair, in RigidMotion a, in RigidMotion b, in CastResult r)
    {
        bool starts = r.Status == CastStatus.OverlappingAtStart;
        bool mayStart = pair.Answer.IsOverlapping || pair.Answer.Distance <= 4 * pair.Noise;
        if (starts ? !mayStart : CastPromises.IsDeep(pair))
            return Say.Line($"{r} of {Text(a, b)}, but Distance says {pair.Answer.Status}");
        if (starts) return null;

        // A touch at the start, to rounding, is passed where it gets no deeper than the tolerance.
        double passed = mayStart ? 2 * Tolerance * pair.Scale : 0;
        if (r.Status is not (CastStatus.Hit or CastStatus.Miss or CastStatus.IterationLimit))
            return Say.Line($"{r} of {Text(a, b)}");
        double end = r.Fraction;
        for (int i = 1; i < Looks + CloserLooks; i++)
        {
            double fraction = i < Looks ? end * i / Looks : end * (1 - Math.ScaleB(1, Looks - i - 4));
            double depth = -Signed(pair, a, b, fraction);
            if (depth > Slack(pair, a, b, fraction) + passed)
                return Say.Line($"{r} of {Text(a, b)}, but at {fraction:R} they overlap by {depth:G3}");
        }

        if (r.Status != CastStatus.Hit) return null;

        // From a float to the one before, the bodies move and turn on. Points have no size, but arms.
        double step = 1.2e-7 * end * (Speed(a, pair.BodyA) + Speed(b, pair.BodyB));
        bool arePoints = pair.BodyA.LongestSide + pair.BodyB.LongestSide == 0;
        double size = arePoints ? Arm(pair.BodyA) + Arm(pair.BodyB) : pair.Scale;
        double most = Tolerance * size + 2 * step + Slack(pair, a, b, end), gap = Signed(pair, a, b, end);
        return gap <= most ? null : Say.Line($"{r} of {Text(a, b)}, but {gap:G3} apart then, not {most:G3}");
    }

    private static double Signed(FuzzPair pair, in RigidMotion a, in RigidMotion b, double fraction)
    {
        RigidPose poseA = Turning.At(a, fraction), poseB = Turning.At(b, fraction);
        DistanceResult d = ConvexQuery.Distance(pair.A, poseA, pair.B, poseB);
        return d.IsOverlapping ? ConvexQuery.SignedDistance(pair.A, poseA, pair.B, poseB).Distance : d.Distance;
    }

    /// <summary>What rounding the poses to float does to the distance.</summary>
    private static double Slack(FuzzPair pair, in RigidMotion a, in RigidMotion b, double fraction) =>
        PoseRounding * (Far(a, fraction) + Far(b, fraction) + Arm(pair.BodyA) + Arm(pair.BodyB)) + 2e-6 * pair.Scale
            + 2 * Accuracy.LeastFloat;

    private static double Far(in RigidMotion motion, double fraction) =>
        ((Double3)motion.Pose.Position).Length + fraction * ((Double3)motion.Velocity).Length;

    /// <summary>How far a body reaches from the point that it turns about.</summary>
    private static double Arm(PosedShape body) => body.Center.Length + 2 * body.LongestSide;

    private static double Speed(in RigidMotion motion, PosedShape body) =>
        ((Double3)motion.Velocity).Length + ((Double3)motion.AngularVelocity).Length * Arm(body);

    private static string Text(in RigidMotion a, in RigidMotion b) =>
        Say.Line($"velocities {a.Velocity} and {b.Velocity}, turning {a.AngularVelocity} and {b.AngularVelocity}");
}
