using System;

namespace Gjk.Core;

/// <summary>The four corners of a convex polygon that span the largest area, to within a fiftieth.</summary>
/// <remarks>
/// <para>
/// Four corners are two triangles on both sides of a diagonal. While the diagonal's other end goes round, the best
/// corner on either side moves on and never back, so all four that hold a given corner are seen in as many steps as
/// there are corners, and all there are in the square of that (Shamos 1978, by rotating calipers).
/// </para>
/// <para>
/// Of those that are as good the one with the first name is taken, corner by corner: a regular outline has many that
/// are equal but for rounding, and the same ones must stay while a body rests or slides. What is as good ends in a gap
/// between one area and the next, so that hardly one is in today and out tomorrow.
/// </para>
/// </remarks>
internal readonly unsafe ref struct LargestFour
{
    /// <summary>
    /// Ratio of areas: four that span this much of the largest are as good, none that spans less than the second.
    /// More than a resting body's unrest changes areas, less than matters to what stands on them. Pinned by NameTests.
    /// </summary>
    private const double AsGood = 0.995, LeastGood = 0.98;

    /// <summary>Ratio of areas: a gap that a resting body's unrest hardly crosses. Pinned by NameTests.</summary>
    private const double Gap = 0.004;

    /// <summary>Ratio of an area to the length's square: below it the corners are on a line.</summary>
    private const double Flat = 1e-9;

    /// <summary>The corners, twice round, so that no index need be wrapped; they run counter-clockwise.</summary>
    private readonly double* _u, _v;

    private readonly Candidate* _candidates;
    private readonly int _count;

    /// <summary>Whether the corners run the other way round than the candidates.</summary>
    private readonly bool _isTurned;

    private LargestFour(Candidate* candidates, int count, double* memory)
    {
        _candidates = candidates;
        _count = count;
        _u = memory;
        _v = memory + 2 * count;
        double area = 0;
        for (int i = 1; i + 1 < count; i++)
            area += Candidate.Area(candidates[0], candidates[i], candidates[i + 1]);
        _isTurned = area < 0;
        for (int i = 0; i < count; i++)
        {
            ref Candidate candidate = ref candidates[Number(i)];
            _u[i] = _u[i + count] = candidate.U;
            _v[i] = _v[i + count] = candidate.V;
        }
    }

    /// <summary>Chooses among candidates that run around a convex outline.</summary>
    /// <param name="candidates">The candidates.</param>
    /// <param name="count">How many there are.</param>
    /// <param name="held">One that must be among those that are chosen; -1 for none.</param>
    /// <param name="chosen">Gets the numbers of the chosen ones, rising.</param>
    /// <returns>How many they are: all of up to four; of more four, or the two ends where all are on a line.</returns>
    public static int Choose(Candidate* candidates, int count, int held, int* chosen)
    {
        if (count <= ContactManifold.Capacity)
        {
            for (int i = 0; i < count; i++) chosen[i] = i;
            return count;
        }

        double* memory = stackalloc double[6 * ContactCandidates.Capacity];
        var corners = new LargestFour(candidates, count, memory);
        return corners.Choose(held < 0 ? -1 : corners.Number(held), memory + 4 * count, chosen);
    }

    private int Choose(int held, double* areas, int* chosen)
    {
        double length = 0, most = 0;
        for (int i = 0; i < _count; i++)
        {
            double u = _u[i] - _u[0], v = _v[i] - _v[0];
            length = Math.Max(length, u * u + v * v);
            areas[i] = 0;
        }

        int end = held < 0 ? _count : held + 1;
        for (int i = Math.Max(held, 0); i < end; i++) Through(i, held >= 0, areas);
        for (int i = 0; i < _count; i++) most = Math.Max(most, areas[i]);
        if (!(most > Flat * length)) return Ends(held < 0 ? Furthest(0) : held, chosen);
        int first = held < 0 ? First(areas, most) : held;
        for (int i = 0; i < _count; i++) areas[i] = 0;
        Through(first, true, areas);
        areas[first] = 0;
        int across = First(areas, most), next = across < first ? across + _count : across;
        Complete(first, next, areas[across], most, areas, chosen);
        chosen[0] = Number(first);
        chosen[2] = Number(across);
        for (int i = 1; i < ContactManifold.Capacity; i++)
            for (int k = i; k > 0 && chosen[k] < chosen[k - 1]; k--)
                (chosen[k], chosen[k - 1]) = (chosen[k - 1], chosen[k]);
        return ContactManifold.Capacity;
    }

    /// <summary>Chooses the corners on both sides of a diagonal, the one with the first name first.</summary>
    private void Complete(int from, int to, double whole, double most, double* areas, int* chosen)
    {
        int end = from + _count;
        double most1 = FillBetween(from, to, areas), most2 = FillBetween(to, end, areas);
        int left = FirstBetween(from, to, whole - most1, most, areas);
        int right = FirstBetween(to, end, whole - most2, most, areas);
        if (IsBefore(Wrapped(left), Wrapped(right))) right = FirstBetween(to, end, Area(from, left, to), most, areas);
        else left = FirstBetween(from, to, Area(to, right, end), most, areas);
        chosen[1] = Number(Wrapped(left));
        chosen[3] = Number(Wrapped(right));
    }

    /// <summary>
    /// Finds for each corner across one the largest area of four that hold both, and takes note of it at the other.
    /// </summary>
    /// <param name="first">The corner.</param>
    /// <param name="isAll">Whether corners before it are looked at too; else the diagonal was seen from there.</param>
    /// <param name="areas">The largest area that is known of each corner; those of both ends may grow.</param>
    private void Through(int first, bool isAll, double* areas)
    {
        int left = first + 1, right = first + 3, end = first + _count;
        int last = isAll ? end - 2 : Math.Min(_count - 1, end - 2);
        for (int k = first + 2; k <= last; k++)
        {
            // Both triangles have the diagonal as their base, so their heights over it are all that matters.
            double u = _u[k] - _u[first], v = _v[k] - _v[first];
            double least = u * _v[left] - v * _u[left];
            while (left + 1 < k)
            {
                double next = u * _v[left + 1] - v * _u[left + 1];
                if (!(next <= least)) break;
                least = next;
                left++;
            }

            right = Math.Max(right, k + 1);
            double most = u * _v[right] - v * _u[right];
            while (right + 1 < end)
            {
                double next = u * _v[right + 1] - v * _u[right + 1];
                if (!(next >= most)) break;
                most = next;
                right++;
            }

            double area = most - least;
            if (area > areas[first]) areas[first] = area;
            int across = Wrapped(k);
            if (area > areas[across]) areas[across] = area;
        }
    }

    /// <summary>The first by name of those whose areas are as good as the largest.</summary>
    private int First(double* areas, double most)
    {
        double enough = Enough(areas, most);
        int first = -1;
        for (int i = 0; i < _count; i++)
            if (areas[i] >= enough && (first < 0 || IsBefore(i, first))) first = i;
        return first;
    }

    /// <summary>Where what is as good ends: in the first gap between two areas that is wide enough.</summary>
    private double Enough(double* areas, double most)
    {
        double from = 0;
        for (int i = 0; i < _count; i++) from = Math.Max(from, areas[i]);
        from = Math.Min(from, AsGood * most);
        double least = Math.Min(from, LeastGood * most);
        while (true)
        {
            double next = least;
            for (int i = 0; i < _count; i++)
                if (areas[i] < from) next = Math.Max(next, areas[i]);
            if (from - next >= Gap * most || !(next > least)) return (from + next) / 2;
            from = next;
        }
    }

    /// <summary>Writes the areas of the triangles over a diagonal, and 0 for all other corners.</summary>
    /// <returns>The largest.</returns>
    private double FillBetween(int from, int to, double* areas)
    {
        double most = 0;
        for (int i = 0; i < _count; i++) areas[i] = 0;
        for (int i = from + 1; i < to; i++)
        {
            double area = Area(from, i, to);
            areas[Wrapped(i)] = area;
            most = Math.Max(most, area);
        }

        return most;
    }

    /// <summary>The corner over a diagonal with the first name of those that make the four large enough.</summary>
    private int FirstBetween(int from, int to, double other, double most, double* areas)
    {
        FillBetween(from, to, areas);
        for (int i = from + 1; i < to; i++) areas[Wrapped(i)] += other;
        int first = First(areas, most);
        return first <= from ? first + _count : first;
    }

    /// <summary>One end of what lies on a line, or one that must stay, and the one that is furthest from it.</summary>
    private int Ends(int from, int* chosen)
    {
        int to = Furthest(from);
        chosen[0] = Math.Min(Number(from), Number(to));
        chosen[1] = Math.Max(Number(from), Number(to));
        return from == to ? 1 : 2;
    }

    private int Furthest(int from)
    {
        int furthest = from;
        double most = 0;
        for (int i = 0; i < _count; i++)
        {
            double u = _u[i] - _u[from], v = _v[i] - _v[from], squared = u * u + v * v;
            if (!(squared > most)) continue;
            most = squared;
            furthest = i;
        }

        return furthest;
    }

    /// <summary>Twice the area of a triangle.</summary>
    private double Area(int p, int q, int r) =>
        (_u[q] - _u[p]) * (_v[r] - _v[p]) - (_v[q] - _v[p]) * (_u[r] - _u[p]);

    private int Wrapped(int corner) => corner < _count ? corner : corner - _count;

    /// <summary>The candidate that is a corner, or the corner that is a candidate.</summary>
    private int Number(int corner) => _isTurned ? _count - 1 - corner : corner;

    private bool IsBefore(int i, int k) =>
        ContactFeature.IsBefore(_candidates[Number(i)].Id, _candidates[Number(k)].Id);
}
