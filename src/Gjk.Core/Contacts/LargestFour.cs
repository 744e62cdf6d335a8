namespace Gjk.Core;

/// <summary>Four corners of a convex outline that span a large area: an end of the outline, the corner furthest from
/// it, the one that makes the largest triangle with these two, and the one that adds most to that triangle (Gregorius,
/// "Robust contact creation for physics simulation", GDC 2015). Then each moves once to where it spans the most between
/// its neighbours. Begun at the third one as well, they may span much more.</summary>
/// <remarks>Of corners that are as good the one with the first name is taken: a regular outline has many that are equal
/// but for rounding, and the same ones must stay while a body rests or slides. What is as good ends in a gap between
/// one value and the next, so that hardly one is in today and out tomorrow.</remarks>
internal static unsafe class LargestFour
{
    /// <summary>Ratio: what reaches this much of the best is as good, what reaches less than the second never is. More
    /// than a resting body's unrest changes lengths and areas, less than matters to what stands on them. Pinned by
    /// NameTests.</summary>
    private const double AsGood = 0.995, LeastGood = 0.98;

    /// <summary>Ratio: a gap that a resting body's unrest hardly crosses. Pinned by NameTests.</summary>
    private const double Gap = 0.004;

    /// <summary>Ratio of areas: where the deepest corner leaves less, the others move with it; and four that span less
    /// than this of the other four give way. More than the promised 80 %; pinned by ContactAreaTests.</summary>
    private const double LeastLeft = 0.84;

    /// <summary>Ratio of an area to the length's square: below it the corners are on a line.</summary>
    private const double Flat = 1e-9;

    /// <summary>Chooses among candidates that run around a convex outline.</summary>
    /// <param name="candidates">The candidates.</param>
    /// <param name="chosen">Gets the numbers of the chosen ones, rising; has room for one more.</param>
    /// <returns>How many they are: all of up to four; of more four, or the two ends where all are on a line.</returns>
    public static int Choose(in ContactCandidates candidates, int* chosen)
    {
        int count = candidates.Count;
        for (int i = 0; i < Math.Min(count, ContactManifold.Capacity); i++) chosen[i] = i;
        if (count <= ContactManifold.Capacity) return count;
        double* values = stackalloc double[ContactCandidates.Capacity];
        for (int i = 0; i < count; i++) values[i] = 1;
        int p = First(candidates, values), q = Furthest(candidates, Furthest(candidates, p, values), values);
        int found = Grow(candidates, q, chosen, values), third = chosen[2];
        Sort(chosen, found);
        if (found < ContactManifold.Capacity) return found;
        Exchange(candidates, chosen, -1, values);
        int* other = stackalloc int[ContactManifold.Capacity];
        if (Grow(candidates, third, other, values) < ContactManifold.Capacity) return found;
        Sort(other, found);
        Exchange(candidates, other, -1, values);
        if (Area(candidates, chosen) < LeastLeft * Area(candidates, other))
            for (int i = 0; i < found; i++) chosen[i] = other[i];
        return found;
    }

    /// <summary>Chooses a corner furthest from a start, and the third and the fourth one.</summary>
    private static int Grow(in ContactCandidates candidates, int start, int* chosen, double* values)
    {
        int p = Furthest(candidates, start, values), q = start;
        for (int i = 0; i < candidates.Count; i++)
            values[i] = Math.Abs(Candidate.Area(candidates[p], candidates[q], candidates[i]));
        int r = First(candidates, values);
        (chosen[0], chosen[1], chosen[2]) = (p, q, r);
        if (!(values[r] > Flat * candidates[p].SquaredTo(candidates[q]))) return 2;
        if (Candidate.Area(candidates[p], candidates[q], candidates[r]) < 0) (p, q) = (q, p);
        for (int i = 0; i < candidates.Count; i++) values[i] = Beyond(candidates, p, q, r, candidates[i]);
        chosen[3] = First(candidates, values);
        return values[chosen[3]] > 0 ? ContactManifold.Capacity : ContactManifold.Capacity - 1;
    }

    /// <summary>Lets each of four but one go to where between its neighbours it spans the most.</summary>
    private static void Exchange(in ContactCandidates candidates, int* four, int held, double* values)
    {
        for (int i = 0; i < ContactManifold.Capacity; i++)
        {
            if (four[i] == held) continue;
            int p = four[(i + 3) % ContactManifold.Capacity], q = four[(i + 1) % ContactManifold.Capacity];
            for (int k = 0; k < candidates.Count; k++)
            {
                bool isBetween = p < q ? k > p && k < q : k > p || k < q;
                values[k] = isBetween ? Math.Abs(Candidate.Area(candidates[p], candidates[q], candidates[k])) : -1;
            }

            four[i] = First(candidates, values);
        }

        Sort(four, ContactManifold.Capacity);
    }

    /// <summary>Makes one candidate a chosen one: a fifth takes the place of the one that leaves the largest area, so
    /// that three names stay.</summary>
    /// <returns>How many there are.</returns>
    public static int Hold(in ContactCandidates candidates, int* chosen, int count, int held)
    {
        for (int i = 0; i < count; i++)
            if (chosen[i] == held) return count;
        chosen[count] = held;
        Sort(chosen, count + 1);
        if (count < ContactManifold.Capacity) return count + 1;
        int* four = stackalloc int[ContactManifold.Capacity], best = stackalloc int[ContactManifold.Capacity];
        double most = -1, before = 0;
        for (int left = 0; left <= count; left++)
        {
            for (int i = 0; i < count; i++) four[i] = chosen[i < left ? i : i + 1];
            double area = Area(candidates, four);
            if (chosen[left] == held) before = area;
            else if (area > most)
            {
                most = area;
                for (int i = 0; i < count; i++) best[i] = four[i];
            }
        }

        for (int i = 0; i < count; i++) chosen[i] = best[i];
        double* values = stackalloc double[ContactCandidates.Capacity];
        if (!(most >= LeastLeft * before)) Exchange(candidates, chosen, held, values);
        return count;
    }

    private static double Area(in ContactCandidates candidates, int* four) => Math.Abs(
        Candidate.Area(candidates[four[0]], candidates[four[1]], candidates[four[2]])
        + Candidate.Area(candidates[four[0]], candidates[four[2]], candidates[four[3]]));

    /// <summary>How much a candidate adds to a triangle that runs counter-clockwise.</summary>
    private static double Beyond(in ContactCandidates candidates, int p, int q, int r, in Candidate other) =>
        -Math.Min(
            Candidate.Area(candidates[p], candidates[q], other),
            Math.Min(
                Candidate.Area(candidates[q], candidates[r], other),
                Candidate.Area(candidates[r], candidates[p], other)));

    private static int Furthest(in ContactCandidates candidates, int from, double* values)
    {
        for (int i = 0; i < candidates.Count; i++) values[i] = candidates[i].SquaredTo(candidates[from]);
        return First(candidates, values);
    }

    /// <summary>The first by name of those whose values are as good as the largest.</summary>
    private static int First(in ContactCandidates candidates, double* values)
    {
        double enough = Enough(values, candidates.Count);
        int first = -1;
        for (int i = 0; i < candidates.Count; i++)
        {
            if (!(values[i] >= enough)) continue;
            if (first < 0 || ContactFeature.IsBefore(candidates[i].Id, candidates[first].Id)) first = i;
        }

        return Math.Max(first, 0);
    }

    /// <summary>Where what is as good ends: in the first gap between two values that is wide enough.</summary>
    private static double Enough(double* values, int count)
    {
        double most = 0;
        for (int i = 0; i < count; i++) most = Math.Max(most, values[i]);
        double from = AsGood * most, least = LeastGood * most, gap = Gap * most;
        while (true)
        {
            // The least value that is less than a gap away, and the largest one beyond.
            double near = from, beyond = least;
            for (int i = 0; i < count; i++)
            {
                if (!(values[i] < near && values[i] > beyond)) continue;
                if (from - values[i] >= gap) beyond = values[i];
                else near = values[i];
            }

            if (!(near < from)) return (from + beyond) / 2;
            from = near;
        }
    }

    private static void Sort(int* numbers, int count)
    {
        for (int i = 1; i < count; i++)
            for (int k = i; k > 0 && numbers[k] < numbers[k - 1]; k--)
                (numbers[k], numbers[k - 1]) = (numbers[k - 1], numbers[k]);
    }
}
