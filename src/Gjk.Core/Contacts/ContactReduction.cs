namespace Gjk.Core;

/// <summary>Which four of many contact points stay, by which names, and in which order.</summary>
/// <remarks>
/// <para>The four span the largest area, to within a fiftieth (<see cref="LargestFour"/>). If none of them is as deep
/// as the deepest point, the largest four that hold that point take their places, and their names stay: a can that
/// rocks on its rim touches everywhere in turn, and what a solver knows of each quarter of the rim must not get lost. A
/// name then stands for the part of the outline around the corner that it names.</para>
/// <para>The points are sorted by name, so that their order stays too. A and B count alike, so that the order is that
/// of the exchanged pair.</para>
/// </remarks>
internal static unsafe class ContactReduction
{
    /// <summary>Count: of more corners, which only finely rounded outlines have, those are left out first that hardly
    /// stand out, so that the time does not grow with the square. Pinned by ContactAreaTests.</summary>
    private const int Many = 24;

    /// <summary>Leaves what stays.</summary>
    /// <param name="candidates">In order around what is shared.</param>
    /// <param name="deepest">A deepest point; its name is used if no other has been there before.</param>
    /// <param name="quarters">The names of a round outline's points; null where it is not round.</param>
    /// <param name="asDeep">Length: a gap that is wider by less is as deep.</param>
    /// <param name="reach">Length: a candidate that is nearer to the deepest point takes its place.</param>
    public static void Reduce(
        ref ContactCandidates candidates, in Candidate deepest, Candidate* quarters, double asDeep, double reach)
    {
        int* four = stackalloc int[ContactManifold.Capacity];
        if (candidates.Count <= ContactManifold.Capacity) quarters = null;
        if (candidates.Count > Many) candidates.KeepCorners(reach);
        int count = LargestFour.Choose(candidates.Pointer, candidates.Count, -1, four);
        Candidate* before = stackalloc Candidate[ContactManifold.Capacity];
        if (!HasDeepest(candidates, four, count, deepest.Gap + asDeep))
        {
            for (int i = 0; i < count; i++) before[i] = candidates[four[i]];
            if (quarters == null && count == ContactManifold.Capacity) quarters = before;
            int at = Put(ref candidates, deepest, reach);
            count = LargestFour.Choose(candidates.Pointer, candidates.Count, at, four);
        }

        candidates.Keep(four, count);
        if (quarters != null && count == ContactManifold.Capacity) Rename(ref candidates, quarters);
        Sort(ref candidates);
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

    private static void Sort(ref ContactCandidates candidates)
    {
        for (int i = 1; i < candidates.Count; i++)
        {
            Candidate moved = candidates[i];
            int k = i;
            for (; k > 0 && ContactFeature.IsBefore(moved.Id, candidates[k - 1].Id); k--)
                candidates[k] = candidates[k - 1];
            candidates[k] = moved;
        }
    }
}
