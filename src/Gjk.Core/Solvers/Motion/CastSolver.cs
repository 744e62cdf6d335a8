namespace Gjk.Core;

/// <summary>When two cores with margins, one of which is translated, first touch: a ray from the origin against the
/// Minkowski difference A - B (van den Bergen, "Ray casting against general convex objects with application to
/// continuous collision detection", 2004).</summary>
/// <remarks>
/// <para>Bounding balls first: along most lines they never meet, and before they do nothing can touch. Polytopes then
/// go through <see cref="CastPortal"/>, which ends with a certificate or hands over. The rest is done here. Each round
/// asks for the distance where B is now. Its answer comes with a plane that separates the shapes, proved by the
/// supports on both sides; until B has crossed the gap along that plane's normal, the two cannot touch. So B moves on
/// by that much, which is Newton's step for a distance that is convex along the line, and the next round begins at the
/// simplex where this one ended. Where B moves along the plane or away from it, they never touch.</para>
/// <para>The source moves the ray inside the distance's own loop. Here the distance is solved to its proof before
/// anything moves, in extended precision where rounding could turn it: so a hit that is missed, or met too early, is no
/// more possible than a wrong distance. Round shapes jump to where the line meets the margin about the nearest feature
/// (<see cref="CastJump"/>), and what the distance says there is believed: it touches there, or the jump is taken
/// back.</para>
/// <para>It terminates because the place up to which they are apart moves on from round to round, or a double cannot
/// tell the next one from it; a jump that fails is followed by a step that is proved. Towards a curved core the steps
/// are Newton's. MaxRounds is a backstop for a line that is tangent to one.</para>
/// <para>Verdicts. Hit: they touch at the fraction, which is 0 at the start. Miss: they do not up to the most.
/// Undecided: the rounds ran out, and they are apart up to the fraction. Contradiction: as the distance has it.</para>
/// </remarks>
internal static class CastSolver
{
    /// <summary>Count: a tangent to a curved core halves the way in each round, so that some 30 end it. A backstop:
    /// four times as many would only cost time, and a quarter still is enough for all that the tests cast.</summary>
    private const int MaxRounds = 128;

    /// <summary>Ratio to the radii: how far behind the first contact a jump may have gone, along the line. A thousandth
    /// of the promise. Pinned by CastJumpTests.</summary>
    private const double JumpGap = 1e-10;

    /// <summary>Ratio to the largest fraction: 16 roundings, what a contact exactly at the end may be told beyond it.
    /// Pinned by CastToleranceTests.</summary>
    private const double LastPlaces = 16 * RoundOff.Unit;

    /// <summary>Moves B until it touches A.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">The pair at the start; its translation is moved.</param>
    /// <param name="motion">Of B, seen from A, in A's frame, for the fraction 1.</param>
    /// <param name="most">The largest fraction.</param>
    /// <param name="warmStart">Where the first round begins; updated.</param>
    /// <param name="cast">What was found.</param>
    /// <remarks>Where they touch does not depend on the most: it only cuts off what is beyond it.</remarks>
    public static void Solve<TA, TB>(
        ref TA a, ref TB b, ref PairFrame frame, in Double3 motion, double most, ref WarmStart warmStart,
        out CastFinding cast)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        double beyond = most * (1 + GjkTolerances.FloatBand);
        Find(ref a, ref b, ref frame, motion, beyond, ref warmStart, out cast);
        if (cast.Outcome == MotionVerdict.Hit && IsBeyond(cast.Fraction, most)) cast.Outcome = MotionVerdict.Miss;
    }

    /// <summary>Whether a fraction is larger than the most, by more than rounding in double does.</summary>
    public static bool IsBeyond(double fraction, double most) => fraction > most * (1 + LastPlaces);

    private static void Find<TA, TB>(
        ref TA a, ref TB b, ref PairFrame frame, in Double3 motion, double most, ref WarmStart warmStart,
        out CastFinding cast)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        cast = default;
        bool mayMeet = CastLine.Make(frame, motion, out CastLine line) != MotionVerdict.Miss;
        CastJump.Make(line, most, out CastJump place);
        if (!mayMeet || place.FractionOf(line, place.Along) > most)
        {
            cast.Outcome = MotionVerdict.Miss;
            return;
        }

        SolverState.Make<TA, TB>(frame, out SolverState state);

        // A pair that begins near each other often overlaps or parts, which a distance tells at once.
        bool isPolytope = CastPortal.AppliesTo<TA, TB>(frame);
        if (place.IsPastStart && isPolytope && TryPortal(ref a, ref b, ref frame, line, most, ref cast, ref state))
            return;
        warmStart.Seed(ref a, ref b, frame, ref state);
        bool isAfterPortal = place.IsPastStart | !isPolytope;
        if (place.IsPastStart) StartLater(line, place, ref frame, ref cast, ref state);
        for (int rounds = 0; rounds < MaxRounds; rounds++)
        {
            Measure(ref a, ref b, frame, ref state);
            cast.Iterations += state.Iterations;
            cast.Outcome = (MotionVerdict)state.Verdict;
            if (state.Verdict == Verdict.Contradiction || state.Verdict == Verdict.Undecided) break;
            if (place.TryEnd(state, frame, line, JumpGap * frame.Radius, ref cast))
            {
                warmStart.Save(state);
                if (cast.Outcome == MotionVerdict.Miss) return;
                cast.OnA = state.Simplex.WitnessOnA(state.Weights);
                if (cast.Fraction == 0) cast.OnA += ToCommon(state, frame);
                else if (state.IsCurved)
                    CastNormal<TA, TB>.Sharpen(ref a, ref b, ref frame, line.Axis, ref state.Simplex, ref cast);
                return;
            }

            if (!isAfterPortal)
            {
                isAfterPortal = true;
                warmStart.Save(state);
                Double3 normal = cast.Normal;
                if (TryPortal(ref a, ref b, ref frame, line, most, ref cast, ref state)) return;
                cast.Normal = normal;
                warmStart.Seed(ref a, ref b, frame, ref state);
            }

            frame.Translation = line.At(place.Along);
            MinkowskiDifference.Retranslate(frame, ref state.Simplex);
            cast.Outcome = MotionVerdict.Undecided;
        }

        cast.Fraction = place.FractionOf(line, place.Left);
        warmStart.Save(state);
    }

    /// <summary>Looks for the entry by vertices alone; leaves the frame as it was where that tells nothing.</summary>
    private static bool TryPortal<TA, TB>(
        ref TA a, ref TB b, ref PairFrame frame, in CastLine line, double most, ref CastFinding cast,
        ref SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        Double3 before = frame.Translation;
        frame.Translation = line.Nearest;
        cast.Outcome = CastPortal.Solve(ref a, ref b, frame, line, most, ref cast, ref state);
        if (cast.Outcome == MotionVerdict.Hit) cast.OnA = state.Simplex.WitnessOnA(state.Weights);
        if (cast.Outcome != MotionVerdict.Undecided) return true;
        frame.Translation = before;
        cast.Fraction = 0;
        state.Simplex.Clear();
        return false;
    }

    /// <summary>Begins where the bounding balls touch, which is what separates them there.</summary>
    private static void StartLater(
        in CastLine line, in CastJump place, ref PairFrame frame, ref CastFinding cast, ref SolverState state)
    {
        frame.Translation = line.At(place.Along);
        cast.Normal = frame.Translation * (1 / frame.Translation.Length);
        MinkowskiDifference.Retranslate(frame, ref state.Simplex);
    }

    /// <summary>From A's core to a point of both shapes at the start: where only the margins overlap, it lies between
    /// the cores.</summary>
    private static Double3 ToCommon(in SolverState state, in PairFrame frame)
    {
        if (state.Verdict == Verdict.Enclosed || !(frame.Margins > 0)) return default;
        double share = state.Feature.Height / (state.Feature.NormalSquared * frame.Margins);
        return state.Feature.Normal * (-share * frame.MarginA);
    }

    /// <summary>The distance where B is now, from the simplex that the state holds.</summary>
    private static void Measure<TA, TB>(ref TA a, ref TB b, in PairFrame frame, ref SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        NoTrace trace = default;
        state.Iterations = 0;
        state.Verdict = Verdict.Undecided;
        state.Plane.NormalSquared = 0;
        if (!frame.ArePoints)
        {
            GjkDistance.Solve(ref a, ref b, frame, double.PositiveInfinity, ref state, ref trace);
            GjkExtendedPrecision.Settle(ref a, ref b, frame, double.PositiveInfinity, true, ref state, ref trace);
            return;
        }

        state.Simplex.Clear();
        GjkDistance.SolvePoints(frame, ref state);
    }
}
