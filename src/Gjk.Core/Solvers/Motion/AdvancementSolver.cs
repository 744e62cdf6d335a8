namespace Gjk.Core;

/// <summary>When two cores with margins that move and turn first touch, to within a tolerance: conservative
/// advancement (Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996) along planes that turn with
/// the features (after Catto, "Continuous Collision", 2013).</summary>
/// <remarks>
/// <para>Each round asks for the distance at the fraction reached, which comes with a plane that separates the shapes.
/// The plane goes on turning as the nearest feature does (<see cref="TurningPlane"/>). A step is tried that should end
/// just before the gap along it does; a support on each shape at its end, and a bound on how far the gap can sag in
/// between, prove the step, or the part of it that they can. The next round begins there.</para>
/// <para>Mirtich's bound is the largest speed of any point, so that steps shrink with the gap. The chord with its sag
/// is of second order: steps towards a contact are Newton's, and past a near miss they go with the gap's square root.
/// Catto's root finder trusts samples; here nothing that is not proved is passed over.</para>
/// <para>It terminates because a step leaves no less than a floor, and a gap above the tolerance is several floors: so
/// each step has a length that does not depend on the round. MaxSteps bounds their number where bodies spin closely
/// past each other for many turns.</para>
/// <para>Verdicts. Hit: at the fraction they are within the tolerance, or they touch at the start. Miss: they are not
/// up to the end. Undecided: the steps ran out, and they are apart up to the fraction. Contradiction: as the distance
/// has it.</para>
/// </remarks>
internal static class AdvancementSolver<TA, TB>
    where TA : struct, ISupportMap
    where TB : struct, ISupportMap
{
    /// <summary>Counts: after so many steps, and after each four times as many, it pays to measure how far the bodies
    /// reach from their axes, by twice as many supports as there were steps. Larger factors would only cost time.
    /// Pinned by TimeOfImpactTests.AWheelPassesAFloor.</summary>
    private const int MeasureAfter = 8, MeasureFactor = 4, SupportsPerStep = 2;

    /// <summary>Ratio to a fraction: 2^-23, at least the distance to the float before. Pinned by
    /// ImpactToleranceTests.</summary>
    private const double FloatStep = 1.0 / (1 << 23);

    /// <summary>Moves the pair until it touches; the state and the frame are those of the end.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">The pair at the begin.</param>
    /// <param name="motion">How it moves.</param>
    /// <param name="interval">From which fraction to which; apart outside.</param>
    /// <param name="tolerance">The largest gap of a hit, in solver units, well above what rounding does.</param>
    /// <param name="floor">The gap that each step is proved to leave: a part of the tolerance.</param>
    /// <param name="leaves">Whether what is within the tolerance and parts goes on.</param>
    /// <param name="warmStart">Where the first round begins; updated.</param>
    /// <param name="impact">What was found.</param>
    /// <param name="state">Of the last round.</param>
    public static void Solve(
        ref TA a, ref TB b, ref PairFrame frame, ref PairMotion motion, in FractionInterval interval, double tolerance,
        double floor, bool leaves, ref WarmStart warmStart, out Impact impact, out SolverState state)
    {
        impact = default;
        impact.Fraction = interval.Begin;
        double speed = motion.Speed;
        int measure = MeasureAfter;
        while (TryMeasure(ref a, ref b, frame, ref warmStart, ref impact, out state, out double gap))
        {
            double accepted = Math.Max(
                Math.Min(tolerance - speed * impact.Fraction * FloatStep, Impact.MostAccepted * tolerance),
                Impact.LeastAccepted * tolerance);
            bool isNear = gap <= accepted;
            TurningPlane.Choose(
                state, frame, motion, impact.Fraction, interval.End, isNear ? 0 : 0.5 * accepted,
                out TurningPlane plane);
            double next;
            if (isNear)
            {
                double rounding = motion.Rounding(interval.End, frame.Margins);
                if (!leaves || !TryLeave(
                    ref a, ref b, ref frame, motion, plane, interval.End, 2 * accepted, rounding, out next))
                {
                    return;
                }
            }
            else if (!TrySweep(
                ref a, ref b, ref frame, motion, plane, interval.End, floor, impact.Steps >= MeasureAfter, out next))
            {
                next = Advance(ref a, ref b, ref frame, motion, plane, interval.End, floor);
            }

            if (!impact.TryGoTo(next, interval.End)) return;
            if (impact.Steps < measure) continue;
            motion.A.Measure(ref a, SupportsPerStep * measure);
            motion.B.Measure(ref b, SupportsPerStep * measure);
            measure *= MeasureFactor;
        }
    }

    /// <summary>Goes along the plane as far as is proved; the frame is that of the fraction returned.</summary>
    internal static double Advance(
        ref TA a, ref TB b, ref PairFrame frame, in PairMotion motion, in TurningPlane plane, double end, double floor)
    {
        double next = Math.Min(plane.Start + plane.Step, end), step = next - plane.Start;
        motion.MoveTo(next, ref frame);
        double gap = plane.GapAt(ref a, ref b, frame, next);
        if (plane.IsProved(step, gap, floor)) return next;
        next = plane.Start + step * plane.ProvedPart(step, gap, floor);
        motion.MoveTo(next, ref frame);
        return next;
    }

    /// <summary>Goes on as long as the plane, if it stands still, separates all that the bodies can turn to: a wheel
    /// passes a wall in one step.</summary>
    /// <returns>False where the other way goes further.</returns>
    internal static bool TrySweep(
        ref TA a, ref TB b, ref PairFrame frame, in PairMotion motion, in TurningPlane plane, double end, double floor,
        bool isMeasured, out double next)
    {
        next = plane.Start;
        if (!isMeasured) return false;
        Double3 normal = plane.Normal;
        double gap = -Double3.Dot(normal, motion.Between(plane.Start)) - frame.Margins;
        gap -= Reach(ref a, motion.A, frame.RotationA.InverseRotate(-normal), -normal);
        gap -= Reach(ref b, motion.B, frame.Rotation.InverseRotate(frame.RotationA.InverseRotate(normal)), normal);
        if (!(gap > floor)) return false;
        double rate = -Double3.Dot(normal, motion.Velocity);
        next = rate < 0 ? Math.Min(plane.Start + (gap - floor) / -rate, end) : end;
        if (!(next >= Math.Min(plane.Start + plane.Step, end))) return false;
        motion.MoveTo(next, ref frame);
        return true;
    }

    /// <summary>How far a body reaches from its pivot in a direction, if it turns, whatever way it is turned.</summary>
    private static double Reach<T>(ref T shape, in TurningBody body, in Double3 local, in Double3 world)
        where T : struct, ISupportMap
    {
        if (body.IsTurning) return body.SweptReach(world);
        shape.Support(local, out Double3 point);
        return Double3.Dot(local, point);
    }

    /// <summary>Shapes that are within the tolerance and on their way apart do not hit: resting or just parted ones
    /// could not be moved at all. They leave if a step is proved that ends well outside the tolerance, or at the
    /// end.</summary>
    private static bool TryLeave(
        ref TA a, ref TB b, ref PairFrame frame, in PairMotion motion, in TurningPlane plane, double end,
        double outside, double floor, out double next)
    {
        next = plane.Start;
        if (!(plane.Rate >= 0) || !(plane.Gap > floor)) return false;
        PairFrame here = frame;
        next = plane.Rate > 0 ? Math.Min(plane.Start + outside / plane.Rate, end) : end;
        motion.MoveTo(next, ref frame);
        double gap = plane.GapAt(ref a, ref b, frame, next);
        bool isProved = plane.IsProved(next - plane.Start, gap, floor) && (next >= end || gap >= 0.5 * outside);
        if (!isProved) frame = here;
        return isProved;
    }

    /// <summary>Asks for the distance where the pair is now.</summary>
    /// <returns>False where that is the end: they touch, or there is no distance.</returns>
    private static bool TryMeasure(
        ref TA a, ref TB b, in PairFrame frame, ref WarmStart warmStart, ref Impact impact, out SolverState state,
        out double gap)
    {
        SolverState.Make<TA, TB>(frame, out state);
        NoTrace trace = default;
        if (frame.ArePoints)
        {
            GjkDistance.SolvePoints(frame, ref state);
        }
        else
        {
            warmStart.Seed(ref a, ref b, frame, ref state);
            GjkDistance.Solve(ref a, ref b, frame, double.PositiveInfinity, ref state, ref trace);
            GjkExtendedPrecision.Settle(ref a, ref b, frame, double.PositiveInfinity, true, ref state, ref trace);
            warmStart.Save(state);
            SideNormal<TA, TB, NoTrace>.Sharpen(ref a, ref b, frame, ref state, ref trace);
        }

        impact.Iterations += state.Iterations;
        impact.Steps++;
        gap = 0;
        impact.Outcome = (MotionVerdict)state.Verdict;
        if (state.Verdict != Verdict.Apart) return false;
        gap = Proofs.DistanceOf(state, frame, 1 / Math.Sqrt(state.Feature.NormalSquared));
        impact.Outcome = MotionVerdict.Hit;
        if (Proofs.IsTouching(state, gap)) return false;
        impact.Normal = state.Plane.Normal * (-1 / Math.Sqrt(state.Plane.NormalSquared));
        return true;
    }
}

/// <summary>A part of a motion.</summary>
internal readonly struct FractionInterval(double begin, double end)
{
    public readonly double Begin = begin, End = end;
}

/// <summary>What an advancement found.</summary>
internal struct Impact
{
    /// <summary>Count: the largest number of distances that a query asks for. Random motions of up to ten turns take 4
    /// in the median and some hundreds at worst. A backstop: more would only cost time, and a quarter is enough for all
    /// that the tests move.</summary>
    public const int MaxSteps = 1024;

    /// <summary>Ratios to the tolerance: steps leave a proved gap of the floor, and aim at half of the gap that is
    /// accepted. The rest is left for rounding the fraction to a float. Pinned by ImpactToleranceTests.</summary>
    public const double FloorRatio = 1.0 / 64, MostAccepted = 1.0 / 2, LeastAccepted = 1.0 / 8;

    /// <summary>Hit where the shapes come within the tolerance, Miss where they do not.</summary>
    public MotionVerdict Outcome;

    /// <summary>Up to here they are apart.</summary>
    public double Fraction;

    /// <summary>From A to B in A's frame, of unit length; zero where they touch at the start.</summary>
    public Double3 Normal;

    /// <summary>Support calls made on each shape.</summary>
    public int Iterations;

    /// <summary>Distances asked for.</summary>
    public int Steps;

    /// <summary>Takes a fraction up to which the shapes are apart.</summary>
    /// <returns>False where that is the end, or no later than the last, or there were too many steps.</returns>
    public bool TryGoTo(double fraction, double end)
    {
        Iterations++;
        Outcome = fraction >= end ? MotionVerdict.Miss : MotionVerdict.Undecided;
        bool isLater = fraction > Fraction;
        Fraction = Math.Max(Fraction, Math.Min(fraction, end));
        return isLater && Outcome != MotionVerdict.Miss && Steps < MaxSteps;
    }
}
