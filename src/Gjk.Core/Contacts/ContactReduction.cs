using System;

namespace Gjk.Core;

/// <summary>
/// Which four of many contact points stay: the deepest, and with it those that span the largest area, one after the
/// other (Gregorius 2015).
/// </summary>
/// <remarks>
/// Equally good ones are told apart by their order, which is that of the shapes' corners, not by rounding: so the same
/// four stay while a body rests or slides.
/// </remarks>
internal static class ContactReduction
{
    /// <summary>
    /// Ratio of lengths and areas: what is less than this better is as good. More than rounding and a resting body's
    /// unrest move a point, less than matters to what stands on it. Pinned by ContactTests.
    /// </summary>
    private const double AsGood = 1e-4;

    /// <summary>Brings the points that stay to the front, the deepest first.</summary>
    /// <returns>How many stay: all of up to four; fewer of more where they are on a line.</returns>
    public static int Reduce(ref ContactCandidates candidates, double size)
    {
        Choose(ref candidates, 0, new Deepest(size));
        if (candidates.Count <= ContactManifold.Capacity) return candidates.Count;
        Choose(ref candidates, 1, default(Furthest));
        if (!Choose(ref candidates, 2, default(LargestTriangle))) return 2;
        return Choose(ref candidates, 3, default(LargestGain)) ? 4 : 3;
    }

    /// <summary>Swaps the best of those that are left to a place; false when none is any good.</summary>
    private static bool Choose<TMerit>(ref ContactCandidates candidates, int place, TMerit merit)
        where TMerit : struct, IMerit
    {
        double most = double.NegativeInfinity;
        for (int i = place; i < candidates.Count; i++) most = Math.Max(most, merit.Of(candidates, i));
        double enough = merit.Enough(most);
        for (int i = place; i < candidates.Count; i++)
        {
            if (!(merit.Of(candidates, i) >= enough)) continue;
            Candidate best = candidates[i];
            for (int k = i; k > place; k--) candidates[k] = candidates[k - 1];
            candidates[place] = best;
            return most > 0;
        }

        return false;
    }

    private static double Area(in Candidate p, in Candidate q, in Candidate r) =>
        (q.U - p.U) * (r.V - p.V) - (q.V - p.V) * (r.U - p.U);

    /// <summary>How good a candidate is beside those that were chosen.</summary>
    private interface IMerit
    {
        double Of(in ContactCandidates candidates, int index);

        double Enough(double most);
    }

    /// <summary>How deep it lies, to within what contact points are exact to.</summary>
    private readonly struct Deepest(double size) : IMerit
    {
        public double Of(in ContactCandidates candidates, int index) => -candidates[index].Gap;

        public double Enough(double most) => most - ContactCandidates.Slack * size;
    }

    private readonly struct Furthest : IMerit
    {
        public double Of(in ContactCandidates candidates, int index)
        {
            double u = candidates[index].U - candidates[0].U, v = candidates[index].V - candidates[0].V;
            return Math.Sqrt(u * u + v * v);
        }

        public double Enough(double most) => most * (1 - AsGood);
    }

    private readonly struct LargestTriangle : IMerit
    {
        public double Of(in ContactCandidates candidates, int index) =>
            Math.Abs(Area(candidates[0], candidates[1], candidates[index]));

        public double Enough(double most) => most * (1 - AsGood);
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

        public double Enough(double most) => most * (1 - AsGood);
    }
}
