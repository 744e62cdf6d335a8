namespace Gjk.Core;

/// <summary>The four corners of a convex polygon that span the largest area, to within a fiftieth.</summary>
/// <remarks>
/// <para>Four corners are two triangles on both sides of a diagonal. While the diagonal's other end goes round, the
/// best corner on either side moves on and never back (Shamos 1978, by rotating calipers). The area is at most the
/// diagonal's length times the polygon's width, so diagonals that are too short for a large one are left out: of a
/// disc's all but the few across the middle.</para>
/// <para>Of those that are as good the one with the first name is taken, corner by corner: a regular outline has many
/// that are equal but for rounding, and the same ones must stay while a body rests or slides. What is as good ends in a
/// gap between one area and the next, so that hardly one is in today and out tomorrow.</para>
/// </remarks>
internal readonly unsafe ref struct LargestFour
{
    /// <summary>Ratio of areas: four that span this much of the largest are as good, none that spans less than the
    /// second. More than a resting body's unrest changes areas, less than matters to what stands on them. Pinned by
    /// NameTests.</summary>
    private const double AsGood = 0.995, LeastGood = 0.98;

    /// <summary>Ratio of areas: a gap that a resting body's unrest hardly crosses. Pinned by NameTests.</summary>
    private const double Gap = 0.004;

    /// <summary>The cosine of an eighth of a turn, and one over that of a sixteenth: what an extent along one of eight
    /// directions may miss.</summary>
    private const double HalfRoot = 0.70710678118654752, Slanted = 1.0823922002923938;

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
        double most = 0, width = Width();
        for (int i = 0; i < _count; i++) areas[i] = 0;
        Through(Math.Max(held, 0), held < 0 ? _count : held + 1, width, areas, ref most);
        if (!(most > Flat * width * width)) return Ends(held < 0 ? Furthest(0) : held, chosen);
        int first = held < 0 ? First(areas, 0, _count, most, 0, most) : held;
        if (held < 0)
        {
            for (int i = 0; i < _count; i++) areas[i] = 0;
            Through(first, first + 1, width, areas, ref most);
        }

        double best = areas[first];
        areas[first] = 0;
        int across = First(areas, 0, _count, best, 0, most);
        Complete(first, across < first ? across + _count : across, most, areas, chosen);
        chosen[0] = Number(first);
        chosen[2] = Number(across);
        for (int i = 1; i < ContactManifold.Capacity; i++)
            for (int k = i; k > 0 && chosen[k] < chosen[k - 1]; k--)
                (chosen[k], chosen[k - 1]) = (chosen[k - 1], chosen[k]);
        return ContactManifold.Capacity;
    }

    /// <summary>Chooses the corners on both sides of a diagonal, the one with the first name first.</summary>
    private void Complete(int from, int to, double most, double* areas, int* chosen)
    {
        int end = from + _count;
        double most1 = FillBetween(from, to, areas), most2 = FillBetween(to, end, areas);
        int left = First(areas, from + 1, to, most1, Math.Max(0, most2), most);
        int right = First(areas, to + 1, end, most2, Math.Max(0, most1), most);
        if (IsBefore(left, right)) right = First(areas, to + 1, end, most2, areas[left], most);
        else left = First(areas, from + 1, to, most1, areas[right], most);
        chosen[1] = Number(Wrapped(left));
        chosen[3] = Number(Wrapped(right));
    }

    /// <summary>Finds for each two corners, of which one is given, the largest area of four that hold both, and takes
    /// note of it at both.</summary>
    /// <param name="from">The first of the corners.</param>
    /// <param name="to">Behind the last one: all corners, or a single one.</param>
    /// <param name="width">No two corners are further apart; diagonals too short for a large area are left out.</param>
    /// <param name="areas">The largest area that is known of each corner.</param>
    /// <param name="most">The largest of all.</param>
    private void Through(int from, int to, double width, double* areas, ref double most)
    {
        for (int first = from; first < to; first++)
        {
            int last = first + _count - 2;
            if (to - from > 1) last = Math.Min(last, _count - 1);
            double length = LeastGood * most / width, squared = length * length;
            for (int k = first + 2; k <= last; k++)
            {
                double u = _u[k] - _u[first], v = _v[k] - _v[first];
                if (u * u + v * v < squared) continue;
                double area = AreaOver(u, v);
                most = Math.Max(most, area);
                areas[first] = Math.Max(areas[first], area);
                int across = Wrapped(k);
                areas[across] = Math.Max(areas[across], area);
            }
        }
    }

    /// <summary>Twice the largest area over a diagonal: it is the base of both triangles, so their heights are all that
    /// matters, and those are the furthest corners on its two sides.</summary>
    private double AreaOver(double u, double v)
    {
#if NET
        // The corners run on behind the last one, and one that is seen twice does not matter.
        Vector256<double> up = Vector256.Create(double.NegativeInfinity), down = up;
        for (int i = 0; i < _count; i += Vector256<double>.Count)
        {
            Vector256<double> alongV = Vector256.Load(_v + i) * u, alongU = Vector256.Load(_u + i) * v;
            up = Larger(up, alongV - alongU);
            down = Larger(down, alongU - alongV);
        }

        Vector256<double> first = Vector256.Create(up.GetLower(), down.GetLower());
        Vector256<double> both = Larger(first, Vector256.Create(up.GetUpper(), down.GetUpper()));
        return Math.Max(both[0], both[1]) + Math.Max(both[2], both[3]);
#else
        double least = _v[0] * u - _u[0] * v, most = least;
        for (int i = 1; i < _count; i++)
        {
            double height = _v[i] * u - _u[i] * v;
            least = Math.Min(least, height);
            most = Math.Max(most, height);
        }

        return most - least;
#endif
    }

#if NET
    private static Vector256<double> Larger(Vector256<double> a, Vector256<double> b) =>
        Vector256.ConditionalSelect(Vector256.GreaterThan(a, b), a, b);

#endif
    /// <summary>A length that no two corners are further apart than, by the extents along eight directions.</summary>
    private double Width()
    {
        double straight = Math.Max(AreaOver(1, 0), AreaOver(0, 1));
        double slanted = Math.Max(AreaOver(1, 1), AreaOver(1, -1)) * HalfRoot;
        return Math.Max(straight, slanted) * Slanted;
    }

    /// <summary>The first by name of those whose areas, with another's, are as good as the largest.</summary>
    private int First(double* areas, int from, int end, double best, double other, double most)
    {
        if (end - from == 1) return from;
        double enough = Enough(areas, from, end, best + other, other, most);
        int first = -1;
        for (int i = from; i < end; i++)
            if (areas[i] + other >= enough && (first < 0 || IsBefore(i, first))) first = i;
        return first;
    }

    /// <summary>Where what is as good ends: in the first gap between two areas that is wide enough.</summary>
    private static double Enough(double* areas, int begin, int end, double from, double other, double most)
    {
        from = Math.Min(Math.Max(0, from), AsGood * most);
        double least = Math.Min(from, LeastGood * most), gap = Gap * most;
        while (true)
        {
            // The least area that is less than a gap away, and the largest one beyond.
            double near = from, beyond = least;
            for (int i = begin; i < end; i++)
            {
                double area = areas[i] + other;
                if (!(area < near && area > beyond)) continue;
                if (from - area >= gap) beyond = area;
                else near = area;
            }

            if (!(near < from)) return (from + beyond) / 2;
            from = near;
        }
    }

    /// <summary>Writes the areas of the triangles over a diagonal.</summary>
    /// <returns>The largest; below 0 where a corner that must stay lies behind the line of its neighbours.</returns>
    private double FillBetween(int from, int to, double* areas)
    {
        double most = double.NegativeInfinity;
        for (int i = from + 1; i < to; i++)
        {
            double area = Area(from, i, to);
            areas[i] = area;
            if (area > most) most = area;
        }

        return most;
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
        ContactFeature.IsBefore(_candidates[Number(Wrapped(i))].Id, _candidates[Number(Wrapped(k))].Id);
}
