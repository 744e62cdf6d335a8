namespace Gjk.Core;

/// <summary>Whether a shape that is translated gets deeper into another one than is allowed: the least signed distance
/// on a part of a line, by cutting planes (Kelley, "The cutting-plane method for solving convex programs", 1960, with
/// one unknown).</summary>
/// <remarks>
/// <para>The signed distance to the Minkowski difference A - B, a convex set, is a convex function, inside too. So the
/// support plane that comes with each probe bounds it from below along the whole line, and the feature bounds it from
/// above at the probe. The next probe is at the lowest point that a falling and a rising plane leave open. A probe that
/// is deep enough ends the search, and so do planes that leave no room for one.</para>
/// <para>Mostly one probe is enough: the first plane decides a motion along a face or away from it, and the first place
/// ahead a motion into the shape. A slope may be allowed on top of the depth; it is added to the signed distance, which
/// stays convex.</para>
/// <para>It terminates because the room that the planes leave shrinks: a polytope has finitely many of them, and along
/// a curved shape it falls with the square of the bracket. MaxRounds is a backstop.</para>
/// <para>Verdicts. Hit: they get deeper, or nothing proves that they do not, so that no contact is lost. Miss: they do
/// not. Contradiction: as the signed distance has it.</para>
/// </remarks>
internal static class DeepeningSolver<TA, TB>
    where TA : struct, ISupportMap
    where TB : struct, ISupportMap
{
    /// <summary>Count: a bracket is halved in each round where the shapes are round, and what is left open falls by
    /// four. Random pairs take less than ten; more are harmless. Pinned by CastOptionsTests.</summary>
    private const int MaxRounds = 32;

    /// <summary>Probes the line until the answer is known.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">The pair at the fraction 0; its translation is moved.</param>
    /// <param name="motion">Of B, seen from A, in A's frame, for the fraction 1.</param>
    /// <param name="range">From where on, to where, and what is allowed, in solver units.</param>
    /// <param name="iterations">Support calls made on each shape are added.</param>
    public static MotionVerdict Solve(
        ref TA a, ref TB b, ref PairFrame frame, in Double3 motion, in DeepeningRange range, ref int iterations)
    {
        if (CastLine.Make(frame, motion, out CastLine line) != MotionVerdict.Hit) return MotionVerdict.Miss;
        double begin = (range.From - line.Middle) * line.Speed, end = (range.To - line.Middle) * line.Speed;

        // A fraction that is no float stands for where the bounding balls meet.
        if (float.IsInfinity((float)range.From)) begin = -line.HalfChord;
        if (range.From > 0) frame.Translation = line.At(begin);
        bool isSharp = range.Slope == 0;
        if (!TryProbe(ref a, ref b, frame, line.Axis, isSharp, ref iterations, out DepthProbe probe))
            return MotionVerdict.Contradiction;
        double allowed = Math.Max(range.Allowed, range.From > 0 ? 0 : -probe.Most);
        double limit = probe.Touch + probe.Noise + line.Error + allowed;
        var left = new DepthCut(begin, probe.Least, probe.Slope + range.Slope);
        if (probe.Most < -limit) return MotionVerdict.Hit;
        if (left.Slope >= 0 || !(end > begin)) return MotionVerdict.Miss;
        bool isCut = end < line.HalfChord;
        DepthCut right = isCut ? default : AtExit(line, begin, range.Slope);
        double along = end;
        for (int rounds = 0; rounds < MaxRounds; rounds++)
        {
            if (!isCut || rounds > 0)
            {
                along = DepthCut.Lowest(left, right);
                if (!(along > left.Along && along < right.Along) || left.At(along) >= -limit) return MotionVerdict.Miss;
            }

            frame.Translation = line.At(along);
            if (!TryProbe(ref a, ref b, frame, line.Axis, isSharp, ref iterations, out probe))
                return MotionVerdict.Contradiction;
            double added = range.Slope * (along - begin);
            if (probe.Most + added < -limit - probe.Noise) return MotionVerdict.Hit;
            var cut = new DepthCut(along, probe.Least + added, probe.Slope + range.Slope);
            double known = left.At(along);
            if (rounds > 0 && probe.Most + added - known <= 2 * probe.Noise) return MotionVerdict.Miss;
            if (cut.Slope >= 0) right = cut;
            else if (along == end) return MotionVerdict.Miss;
            else left = cut;
        }

        return MotionVerdict.Hit;
    }

    /// <summary>Where the bounding balls part they are apart, and go on parting.</summary>
    private static DepthCut AtExit(in CastLine line, double begin, double slope)
    {
        Double3 between = line.At(line.HalfChord);
        double parting = Double3.Dot(between, line.Axis) / between.Length;
        return new DepthCut(line.HalfChord, slope * (line.HalfChord - begin), parting + slope);
    }

    /// <summary>The signed distance where B is now, and the plane that bounds it.</summary>
    private static bool TryProbe(
        ref TA a, ref TB b, in PairFrame frame, in Double3 axis, bool isSharp, ref int iterations,
        out DepthProbe probe)
    {
        SolverState.Make<TA, TB>(frame, out SolverState state);
        WarmStart unused = default;
        NoPolytopeTrace trace = default;
        if (frame.ArePoints) GjkDistance.SolvePoints(frame, ref state);
        else SignedSolver<TA, TB, NoPolytopeTrace>.Solve(ref a, ref b, frame, ref unused, false, ref state, ref trace);
        iterations += state.Iterations;
        probe = default;
        if (state.Verdict == Verdict.Contradiction) return false;
        probe.Touch = GjkTolerances.TouchOf(state.IsCurved) * state.Size.Value;
        probe.Noise = state.DepthNoise;
        double scale = 1 / Math.Sqrt(state.Feature.NormalSquared);
        double planeScale = 1 / Math.Sqrt(state.Plane.NormalSquared);
        probe.Most = state.Feature.Height * scale - frame.Margins;
        probe.Least = Math.Min(state.Plane.Value * planeScale - frame.Margins, probe.Most);
        probe.Slope = -Double3.Dot(state.Plane.Normal, axis) * planeScale;
        if (state.Verdict == Verdict.Enclosed)
        {
            // Centres that coincide: every direction is as good as the others, also the one ahead.
            probe.Most = probe.Least = -frame.Margins;
            probe.Slope = 1;
        }

        // A depth that was searched without room enough may be as much as it is at most.
        if (state.Verdict == Verdict.Undecided) probe.Most = probe.Least;
        if (isSharp && state.IsCurved && state.Verdict == Verdict.Apart)
            Sharpen(ref a, ref b, frame, axis, state, ref iterations, ref probe);
        return true;
    }

    /// <summary>Of curved cores: a distance leaves less open than a depth does, and a depth that is hardly more than
    /// touching is looked at from outside. Where a slope is allowed, it is more than all that.</summary>
    private static void Sharpen(
        ref TA a, ref TB b, in PairFrame frame, in Double3 axis, in SolverState state, ref int iterations,
        ref DepthProbe probe)
    {
        CastFinding touch = default;
        bool isSharp = probe.Most > probe.Touch;
        if (!isSharp && CastNormal<TA, TB>.TryMeasureGap(ref a, ref b, frame, state, ref touch, out double gap))
        {
            probe.Most = probe.Least = Math.Max(gap, probe.Least);
            probe.Slope = Double3.Dot(touch.Normal, axis);
            isSharp = true;
        }

        if (isSharp) probe.Noise = GjkTolerances.NoiseCurved * state.Size.Value;
        iterations += touch.Iterations;
    }

    /// <summary>What was seen at a place of the line.</summary>
    private struct DepthProbe
    {
        /// <summary>Bounds of the signed distance, and how the lower one changes along the line.</summary>
        public double Most, Least, Slope;

        /// <summary>Lengths: what counts as touching, and what is left open between the bounds.</summary>
        public double Touch, Noise;
    }
}

/// <summary>A part of a line, and how deep shapes may get there. Lengths in solver units.</summary>
internal readonly struct DeepeningRange(double from, double to, double allowed, double slope)
{
    /// <summary>The fractions; from 0 on the shapes may be as deep as they are there.</summary>
    public readonly double From = from, To = to;

    /// <summary>How deep they may get at least, and how much for each length of the way on top of it.</summary>
    public readonly double Allowed = allowed, Slope = slope;
}

/// <summary>A lower bound of a convex function of a length, by its value at a place and its slope.</summary>
internal readonly struct DepthCut(double along, double value, double slope)
{
    public readonly double Along = along, Value = value, Slope = slope;

    public double At(double along) => Value + Slope * (along - Along);

    /// <summary>Where a falling and a rising bound meet.</summary>
    public static double Lowest(in DepthCut falling, in DepthCut rising)
    {
        double share = falling.At(rising.Along) - rising.Value;
        return rising.Along + share / (rising.Slope - falling.Slope);
    }
}
