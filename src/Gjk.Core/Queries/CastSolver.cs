using System;

namespace Gjk.Core;

/// <summary>
/// When two cores with margins, one of which is translated, first touch: a ray from the origin against the Minkowski
/// difference A - B (van den Bergen, "Ray casting against general convex objects with application to continuous
/// collision detection", 2004).
/// </summary>
/// <remarks>
/// <para>
/// Each round asks for the distance where B is now. Its answer comes with a plane that separates the shapes, proved by
/// the supports on both sides; until B has crossed the gap along that plane's normal, the two cannot touch. So B moves
/// on by just that part of the motion, and the next round begins at the simplex where this one ended. Where B moves
/// along the plane or away from it, they never touch; where the distance is nothing, they do, and the plane that was
/// crossed last is the one they touch in.
/// </para>
/// <para>
/// The source moves the ray inside the distance's own loop. Here the distance is solved to its proof before anything
/// moves, in extended precision where rounding could turn it: so a hit that is missed, or met too early, is no more
/// possible than a wrong distance.
/// </para>
/// <para>
/// It terminates because the fraction grows from round to round, or a double cannot tell the next one from it. Of
/// polytopes a round or two for each feature that the ray passes are enough; towards a curved surface the steps are
/// Newton's. MaxRounds is a backstop for a ray that is tangent to one.
/// </para>
/// <para>
/// Verdicts. Enclosed: they touch at the fraction, which is 0 at the start. Apart: they do not up to the most.
/// Undecided: the rounds ran out, and they are apart up to the fraction. Contradiction: as the distance has it.
/// </para>
/// </remarks>
internal static class CastSolver
{
    /// <summary>Count: a tangent to a curved core halves the way in each round. Pinned by CastTests.</summary>
    private const int MaxRounds = 128;

    /// <summary>Moves B until it touches A; the state and the frame are those of the end.</summary>
    /// <param name="a">The first core.</param>
    /// <param name="b">The second one.</param>
    /// <param name="frame">The pair at the start; its translation moves.</param>
    /// <param name="motion">Of B, seen from A, in A's frame, for the fraction 1.</param>
    /// <param name="most">The largest fraction.</param>
    /// <param name="warmStart">Where the first round begins; updated.</param>
    /// <param name="cast">What was found.</param>
    /// <param name="state">Of the last round.</param>
    public static void Solve<TA, TB>(
        ref TA a, ref TB b, ref PairFrame frame, in Vector3D motion, double most, ref WarmStart warmStart,
        out Cast cast, out SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        cast = default;
        Vector3D start = frame.Translation;
        for (int rounds = 0; ; rounds++)
        {
            frame.Translation = start + motion * cast.Fraction;
            Measure(ref a, ref b, frame, ref warmStart, out state);
            cast.Iterations += state.Iterations;
            cast.Outcome = state.Verdict;
            if (state.Verdict == Verdict.Contradiction || state.Verdict == Verdict.Undecided) return;
            if (IsTouching(state, frame))
            {
                cast.Outcome = Verdict.Enclosed;
                return;
            }

            double scale = 1 / Math.Sqrt(state.Plane.NormalSquared);
            Vector3D toB = state.Plane.Normal * -scale;
            double gap = state.Plane.Value * scale - frame.Margins, approach = -Vector3D.Dot(toB, motion);
            double next = cast.Fraction + gap / approach;
            cast.Outcome = Verdict.Apart;
            if (!(approach > 0) || next > most) return;
            if (!(next > cast.Fraction))
            {
                cast.Outcome = Verdict.Enclosed;
                return;
            }

            cast.Normal = toB;
            cast.Fraction = next;
            if (rounds < MaxRounds) continue;
            cast.Outcome = Verdict.Undecided;
            return;
        }
    }

    private static void Measure<TA, TB>(
        ref TA a, ref TB b, in PairFrame frame, ref WarmStart warmStart, out SolverState state)
        where TA : struct, ISupportMap
        where TB : struct, ISupportMap
    {
        SolverState.Begin<TA, TB>(frame, out state);
        NoTrace trace = default;
        if (frame.ArePoints) GjkDistance.SolvePoints(frame, ref state);
        else ConvexQuery.SolveCores(
            ref a, ref b, frame, float.PositiveInfinity, ref warmStart, true, ref state, ref trace);
    }

    private static bool IsTouching(in SolverState state, in PairFrame frame) =>
        state.Verdict == Verdict.Enclosed
        || Proofs.IsTouching(state, state.Feature.Height / Math.Sqrt(state.Feature.NormalSquared) - frame.Margins);
}

/// <summary>What a cast found.</summary>
internal struct Cast
{
    /// <summary>Enclosed where the shapes touch, Apart where they do not.</summary>
    public Verdict Outcome;

    /// <summary>Up to here they are apart.</summary>
    public double Fraction;

    /// <summary>Of the plane that was crossed last, from A to B, of unit length; zero at the start.</summary>
    public Vector3D Normal;

    /// <summary>Support calls made on each shape.</summary>
    public int Iterations;
}
