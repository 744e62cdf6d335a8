using System;

namespace Gjk.Core;

/// <summary>
/// Which four of many contact points stay: those that span the largest area, one of them as deep as any (Gregorius
/// 2015).
/// </summary>
/// <remarks>
/// One after the other is chosen, the deepest, the furthest from it, the one that makes the largest triangle and the
/// one that adds the most; then each is exchanged for a better one as long as there is any. Equally good ones are told
/// apart by their order, which is that of the shapes' corners, not by rounding: so the same four stay while a body
/// rests or slides. It ends because the area grows with each exchange.
/// </remarks>
internal static class ContactReduction
{
    /// <summary>
    /// Ratio of lengths and areas: what is less than this better is as good. More than rounding and a resting body's
    /// unrest move a point, less than matters to what stands on it. Pinned by ContactPropertyTests.
    /// </summary>
    private const double AsGood = 1e-4;

    /// <summary>Count: a backstop; two or three rounds of exchanges are the rule.</summary>
    private const int MostRounds = 8;

    /// <summary>Brings the points that stay to the front, the deepest first.</summary>
    /// <returns>How many stay: all of up to four; fewer of more where they are on a line.</returns>
    public static int Reduce(ref ContactCandidates candidates, double size)
    {
        double deepest = double.PositiveInfinity;
        for (int i = 0; i < candidates.Count; i++) deepest = Math.Min(deepest, candidates[i].Gap);
        deepest += ContactCandidates.Slack * size;
        int first = 0;
        while (!(candidates[first].Gap <= deepest)) first++;
        candidates.MoveTo(first, 0);
        if (candidates.Count <= ContactManifold.Capacity) return candidates.Count;
        Choose(ref candidates, 1, default(Furthest));
        if (!Choose(ref candidates, 2, default(LargestTriangle))) return 2;
        if (!Choose(ref candidates, 3, default(LargestGain))) return 3;
        for (int i = 0; i < MostRounds && Exchange(ref candidates, deepest); i++)
        {
        }

        for (first = 0; !(candidates[first].Gap <= deepest);) first++;
        candidates.MoveTo(first, 0);
        return ContactManifold.Capacity;
    }

    /// <summary>Moves the best of those that are left to a place; false when none is any good.</summary>
    private static bool Choose<TMerit>(ref ContactCandidates candidates, int place, TMerit merit)
        where TMerit : struct, IMerit
    {
        double most = 0;
        for (int i = place; i < candidates.Count; i++) most = Math.Max(most, merit.Of(candidates, i));
        int best = place;
        while (!(merit.Of(candidates, best) >= most * (1 - AsGood))) best++;
        candidates.MoveTo(best, place);
        return most > 0;
    }

    /// <summary>Exchanges each of the four for the first one that makes the area larger; true when any was.</summary>
    private static bool Exchange(ref ContactCandidates candidates, double deepest)
    {
        bool any = false;
        double area = Area(candidates);
        for (int i = 0; i < ContactManifold.Capacity; i++)
        {
            for (int k = ContactManifold.Capacity; k < candidates.Count; k++)
            {
                candidates.Swap(i, k);
                double now = Area(candidates);
                if (now > area * (1 + AsGood) && HasDeepest(candidates, deepest))
                {
                    area = now;
                    any = true;
                }
                else
                {
                    candidates.Swap(i, k);
                }
            }
        }

        return any;
    }

    private static bool HasDeepest(in ContactCandidates candidates, double deepest)
    {
        for (int i = 0; i < ContactManifold.Capacity; i++)
            if (candidates[i].Gap <= deepest) return true;
        return false;
    }

    /// <summary>
    /// Twice the area of the first four, corners of a convex polygon in any order: the cross product of its diagonals,
    /// which is the largest of the three that there can be.
    /// </summary>
    private static double Area(in ContactCandidates candidates)
    {
        ref readonly Candidate p = ref candidates[0], q = ref candidates[1], r = ref candidates[2];
        ref readonly Candidate s = ref candidates[3];
        double first = Math.Abs((q.U - p.U) * (s.V - r.V) - (q.V - p.V) * (s.U - r.U));
        double second = Math.Abs((r.U - p.U) * (s.V - q.V) - (r.V - p.V) * (s.U - q.U));
        double third = Math.Abs((s.U - p.U) * (r.V - q.V) - (s.V - p.V) * (r.U - q.U));
        return Math.Max(first, Math.Max(second, third));
    }

    private static double Area(in Candidate p, in Candidate q, in Candidate r) =>
        (q.U - p.U) * (r.V - p.V) - (q.V - p.V) * (r.U - p.U);

    /// <summary>How good a candidate is beside those that were chosen.</summary>
    private interface IMerit
    {
        double Of(in ContactCandidates candidates, int index);
    }

    private readonly struct Furthest : IMerit
    {
        public double Of(in ContactCandidates candidates, int index)
        {
            double u = candidates[index].U - candidates[0].U, v = candidates[index].V - candidates[0].V;
            return Math.Sqrt(u * u + v * v);
        }
    }

    private readonly struct LargestTriangle : IMerit
    {
        public double Of(in ContactCandidates candidates, int index) =>
            Math.Abs(Area(candidates[0], candidates[1], candidates[index]));
    }

    /// <summary>The area outside the triangle that was chosen.</summary>
    private readonly struct LargestGain : IMerit
    {
        public double Of(in ContactCandidates candidates, int index)
        {
            ref readonly Candidate p = ref candidates[0], q = ref candidates[1], r = ref candidates[2];
            ref readonly Candidate s = ref candidates[index];
            double sign = Math.Sign(Area(p, q, r));
            return Math.Max(
                Math.Max(-sign * Area(p, q, s), -sign * Area(q, r, s)), Math.Max(-sign * Area(r, p, s), 0));
        }
    }
}
