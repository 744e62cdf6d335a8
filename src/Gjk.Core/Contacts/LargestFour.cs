namespace Gjk.Core;

/// <summary>Four corners of a convex outline that span a large area: an end of the outline, the corner furthest from
/// it, the one that makes the largest triangle with these two, and the one that adds most to that triangle (Gregorius,
/// "Robust contact creation for physics simulation", GDC 2015).</summary>
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

    /// <summary>Ratio of an area to the length's square: below it the corners are on a line.</summary>
    private const double Flat = 1e-9;

    /// <summary>Chooses among candidates that run around a convex outline.</summary>
    /// <param name="candidates">The candidates.</param>
    /// <param name="chosen">Gets the numbers of the chosen ones, rising.</param>
    /// <returns>How many they are: all of up to four; of more four, or the two ends where all are on a line.</returns>
    public static int Choose(in ContactCandidates candidates, int* chosen)
    {
        int count = candidates.Count;
        for (int i = 0; i < Math.Min(count, ContactManifold.Capacity); i++) chosen[i] = i;
        if (count <= ContactManifold.Capacity) return count;
        double* values = stackalloc double[ContactCandidates.Capacity];
        for (int i = 0; i < count; i++) values[i] = 1;
        int p = First(candidates, values), q = Furthest(candidates, Furthest(candidates, p, values), values);
        p = Furthest(candidates, q, values);
        for (int i = 0; i < count; i++)
            values[i] = Math.Abs(Candidate.Area(candidates[p], candidates[q], candidates[i]));
        int r = First(candidates, values);
        (chosen[0], chosen[1], chosen[2]) = (p, q, r);
        int found = 2;
        if (values[r] > Flat * candidates[p].SquaredTo(candidates[q]))
        {
            found = 3;
            if (Candidate.Area(candidates[p], candidates[q], candidates[r]) < 0) (p, q) = (q, p);
            for (int i = 0; i < count; i++) values[i] = Beyond(candidates, p, q, r, candidates[i]);
            chosen[3] = First(candidates, values);
            if (values[chosen[3]] > 0) found = 4;
        }

        Sort(chosen, found);
        return found;
    }

    /// <summary>Makes one candidate a chosen one: a fifth takes the place of the one that leaves the largest
    /// area.</summary>
    /// <returns>How many there are.</returns>
    public static int Hold(in ContactCandidates candidates, int* chosen, int count, int held)
    {
        for (int i = 0; i < count; i++)
            if (chosen[i] == held) return count;
        int* five = stackalloc int[ContactManifold.Capacity + 1];
        for (int i = 0; i < count; i++) five[i] = chosen[i];
        five[count] = held;
        Sort(five, count + 1);
        int left = -1;
        double most = -1;
        for (int i = 0; i <= count && count == ContactManifold.Capacity; i++)
        {
            if (five[i] == held) continue;
            double area = Math.Abs(
                Candidate.Area(At(candidates, five, i + 1), At(candidates, five, i + 2), At(candidates, five, i + 3))
                + Candidate.Area(
                    At(candidates, five, i + 1), At(candidates, five, i + 3), At(candidates, five, i + 4)));
            if (!(area > most)) continue;
            most = area;
            left = i;
        }

        int kept = 0;
        for (int i = 0; i <= count; i++)
            if (i != left) chosen[kept++] = five[i];
        return kept;
    }

    private static ref Candidate At(in ContactCandidates candidates, int* five, int index) =>
        ref candidates[five[index % (ContactManifold.Capacity + 1)]];

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
