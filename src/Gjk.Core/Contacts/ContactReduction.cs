namespace Gjk.Core;

/// <summary>Which four of many contact points stay, by which names, and in which order.</summary>
/// <remarks>
/// <para>The four span a large area (<see cref="LargestFour"/>). If none of them is as deep as the deepest point, that
/// one takes the place of another, with a name of its own: the others, and their names, stay. Of a round outline, whose
/// corners are not bodies' own, a name stands for a quarter, so that a can that rocks on its rim and touches everywhere
/// in turn keeps its four (<see cref="QuarterNames"/>).</para>
/// <para>The points are sorted by name, so that their order stays too. A and B count alike, so that it stays
/// where <see cref="PairOrder"/> changes.</para>
/// </remarks>
internal static unsafe class ContactReduction
{
    /// <summary>Leaves what stays.</summary>
    /// <param name="candidates">In order around what is shared.</param>
    /// <param name="deepest">A deepest point; its name is used if no other has been there before.</param>
    /// <param name="quarters">The names of a round outline's points; null where it is not round.</param>
    /// <param name="asDeep">Length: a gap that is wider by less is as deep.</param>
    /// <param name="reach">Length: a candidate that is nearer to the deepest point takes its place.</param>
    public static void Reduce(
        ref ContactCandidates candidates, in Candidate deepest, Candidate* quarters, double asDeep, double reach)
    {
        int* four = stackalloc int[ContactManifold.Capacity + 1];
        if (candidates.Count <= ContactManifold.Capacity) quarters = null;
        int count = LargestFour.Choose(candidates, four);
        if (!HasDeepest(candidates, four, count, deepest.Gap + asDeep))
        {
            int before = candidates.Count, at = Put(ref candidates, deepest, reach);
            for (int i = 0; i < count && candidates.Count > before; i++)
                if (four[i] >= at) four[i]++;
            count = LargestFour.Hold(candidates, four, count, at);
        }

        candidates.Keep(four, count);
        if (quarters != null && count == ContactManifold.Capacity) Rename(ref candidates, quarters);
        candidates.Sort(byPlace: false);
    }

    private static bool HasDeepest(in ContactCandidates candidates, int* chosen, int count, double mostGap)
    {
        for (int i = 0; i < count; i++)
            if (candidates[chosen[i]].Gap <= mostGap) return true;
        return false;
    }

    /// <summary>Puts the deepest point among the others, where it belongs around the outline.</summary>
    /// <returns>Its index.</returns>
    private static int Put(ref ContactCandidates candidates, in Candidate deepest, double reach)
    {
        int nearest = -1, after = candidates.Count;
        double least = reach * reach, u = deepest.U, v = deepest.V, most = double.NegativeInfinity, sum = 0;
        for (int i = 0; i < candidates.Count; i++)
        {
            ref Candidate p = ref candidates[i], q = ref candidates[i + 1 < candidates.Count ? i + 1 : 0];
            sum += Candidate.Area(candidates[0], p, q);
            double squared = p.SquaredTo(deepest);
            if (!(squared <= least)) continue;
            least = squared;
            nearest = i;
        }

        if (nearest >= 0)
        {
            candidates[nearest] = deepest.Named(candidates[nearest].Id);
            return nearest;
        }

        // Beyond the side that it is furthest outside of.
        for (int i = 0; i < candidates.Count; i++)
        {
            ref Candidate p = ref candidates[i], q = ref candidates[i + 1 < candidates.Count ? i + 1 : 0];
            double length = Math.Sqrt(p.SquaredTo(q)), outside = -Candidate.Area(p, q, deepest) / length;
            if (sum < 0) outside = -outside;
            if (!(outside > most)) continue;
            most = outside;
            after = i + 1;
        }

        candidates.Insert(after, deepest);
        return after;
    }

    /// <summary>Gives the points the names of four others, as both run around the outline.</summary>
    private static void Rename(ref ContactCandidates candidates, Candidate* others)
    {
        QuarterNames.Match(others, candidates.Pointer, out int turn, out int step);
        for (int i = 0; i < candidates.Count; i++)
            candidates[i] = candidates[i].Named(others[QuarterNames.At(i, turn, step)].Id);
    }
}
