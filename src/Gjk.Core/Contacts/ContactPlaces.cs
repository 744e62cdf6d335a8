namespace Gjk.Core;

/// <summary>The places where two faces or edges lie opposite each other, with names that stay from frame to
/// frame.</summary>
/// <remarks>Of two faces these are the corners of what they share. Bodies that stand on each other share corners and
/// edges, but for their unrest: rounding alone decides which of two such corners lies within the other face, and a name
/// must not depend on that. So a corner that is nearer than a reach to the other's edge names the place, whichever way
/// round they lie, and two corners nearer than that to each other name it together; what gets the same name is one
/// place, the middle. Where edges cross that are as good as parallel there is none. The reach is a small part of the
/// width that is shared, so that hardly any area is lost.</remarks>
internal unsafe ref struct ContactPlaces
{
    /// <summary>Count: as many as corners, or the ends of what two edges share.</summary>
    public const int Capacity = FeatureOverlap.Capacity;

    /// <summary>Length, as a fraction of the pair's size: what lies beside an edge by less is on it, so that equal
    /// faces and parallel edges meet whatever rounding to float did to their poses. Pinned by ContactTests.</summary>
    public const double Slack = 4e-7;

    /// <summary>Ratio: the slack is at most this part of the smaller feature, and what is shared with a round side is
    /// no more than a point where it is a smaller part. Four times more or less is as good.</summary>
    private const double LeastPart = 1e-3;

    /// <summary>Ratio to the width that is shared: corners closer than this coincide. Four places that move by as much
    /// lose 3 % of the largest area; a body at rest moves by 1e-3. Pinned by NameTests.</summary>
    private const double Reach = 1.0 / 200;

    /// <summary>Ratio of the width that is shared to a disc's: below the first 16 corners leave too much of the disc
    /// out, below the second 32. Pinned by ContactAreaTests.</summary>
    private const double LittleOfDisc = 1, LeastOfDisc = 0.4;

    /// <summary>Sine: edges that cross at less are as good as parallel. Pinned by NameTests.</summary>
    public const double Parallel = 0.05;

    private readonly ContactPlace* _places;
    private readonly double _least;

    /// <param name="memory">Room for <see cref="Capacity"/> places.</param>
    /// <param name="a">What A shows.</param>
    /// <param name="b">What B shows.</param>
    /// <param name="size">Of the pair.</param>
    public ContactPlaces(ContactPlace* memory, in FlatFeature a, in FlatFeature b, double size)
    {
        _places = memory;
        _least = LeastPart * Math.Min(a.Width, b.Width);
        SlackAround = Math.Min(Slack * size, _least);
        Count = 0;
        a.JoinCorners(2 * SlackAround);
        b.JoinCorners(2 * SlackAround);
    }

    /// <summary>How many there are.</summary>
    public int Count { get; private set; }

    /// <summary>Length: places closer than this are one.</summary>
    public double ReachAround { get; private set; }

    /// <summary>Length: what lies beside a feature by less is on it.</summary>
    public readonly double SlackAround;

    /// <summary>A place; they run around what is shared.</summary>
    public readonly ref ContactPlace this[int index] => ref _places[index];

    /// <summary>Finds all places.</summary>
    public void Find(ref FlatFeature a, ref FlatFeature b)
    {
        if (a.Count == 2 && b.Count == 2)
        {
            FindAlong(ref a, ref b);
            return;
        }

        bool areFaces = a.Count > 2 && b.Count > 2, isACut = areFaces ? a.Count >= b.Count : a.Count == 2;
        double width;
        int count;
        do
        {
            count = isACut
                ? FeatureOverlap.Find(ref a, ref b, true, SlackAround, _places)
                : FeatureOverlap.Find(ref b, ref a, false, SlackAround, _places);
        }
        while (IsLittleOf(width = Measure(count, areFaces), ref a, ref b));
        int first = -1, last = -1;
        if (!areFaces) FindLeft(count, isACut, ref a, ref b, out first, out last);
        double beside = Math.Max(LengthBeside(first, isACut, a, b), LengthBeside(last, isACut, a, b));
        ReachAround = Math.Max(ReachAround, Reach * beside);
        if ((a.IsOnSide || b.IsOnSide) && Math.Max(width, beside) <= _least) return;
        for (int i = 0; i < count; i++)
            if (SharpTips.TryKeep(ref _places[i], ref a, ref b, SlackAround)) Name(ref _places[i], ref a, ref b);
        AddBeside(first, isACut, ref a, ref b);
        if (last != first) AddBeside(last, isACut, ref a, ref b);
        for (int i = 0; i < Count; i++) _places[i].TakeMiddle();
        RemoveFlat();
    }

    /// <summary>Whether so little of a disc is shared that it was shown by too few corners; it gets more
    /// then.</summary>
    private static bool IsLittleOf(double width, ref FlatFeature a, ref FlatFeature b)
    {
        bool ofA = IsLittleOf(width, ref a), ofB = IsLittleOf(width, ref b);
        if (ofA) a.Refine();
        if (ofB) b.Refine();
        return ofA || ofB;
    }

    private static bool IsLittleOf(double width, ref FlatFeature disc)
    {
        if (!disc.CanBeRefined) return false;
        bool isFirst = disc.Count == FaceCorners.Capacity / FaceCorners.DiscStep;
        return !(width >= (isFirst ? LittleOfDisc : LeastOfDisc) * disc.Width);
    }

    /// <summary>How wide the overlap is, from its area and length: what the reach is a part of.</summary>
    private double Measure(int count, bool isArea)
    {
        double area = 0, u = 0, v = 0, squared = 0;
        for (int i = 0; i < count; i++)
        {
            u += _places[i].U;
            v += _places[i].V;
        }

        u /= count;
        v /= count;
        ref ContactPlace last = ref _places[Math.Max(count - 1, 0)];
        double beforeU = last.U - u, beforeV = last.V - v;
        for (int i = 0; i < count; i++)
        {
            double atU = _places[i].U - u, atV = _places[i].V - v;
            area += beforeU * atV - beforeV * atU;
            squared = Math.Max(squared, atU * atU + atV * atV);
            (beforeU, beforeV) = (atU, atV);
        }

        double length = 2 * Math.Sqrt(squared), width = isArea ? Math.Abs(area) / length : length;
        ReachAround = Math.Max(width > 0 ? Reach * width : 0, 2 * SlackAround);
        return width;
    }

    /// <summary>Names a place, and adds it to the others: to the one that has the same name, if there is one.</summary>
    private void Name(ref ContactPlace place, ref FlatFeature a, ref FlatFeature b)
    {
        int nameA = place.CornerA, nameB = place.CornerB;
        if (nameA < 0 && nameB < 0)
        {
            nameA = NearEnd(ref a, place.EdgeA, place.U, place.V);
            nameB = NearEnd(ref b, place.EdgeB, place.U, place.V);
        }

        if (nameA >= 0 && nameB < 0) nameB = Nearest(ref b, a[nameA].U, a[nameA].V);
        else if (nameB >= 0 && nameA < 0) nameA = Nearest(ref a, b[nameB].U, b[nameB].V);
        if (nameA < 0 && nameB < 0)
        {
            place.Id = ContactFeature.Of(EdgeOf(ref a, place.EdgeA), EdgeOf(ref b, place.EdgeB));
            place.IsFlat = Sine(ref a, place.EdgeA, ref b, place.EdgeB) <= Parallel;
        }
        else
        {
            place.Id = ContactFeature.Of(CornerOf(ref a, nameA), CornerOf(ref b, nameB));
        }

        Add(place);
    }

    private void Add(in ContactPlace place)
    {
        for (int i = Count - 1; i >= 0; i--)
        {
            if (_places[i].Id != place.Id) continue;
            _places[i].Join(place);
            return;
        }

        _places[Count++] = place;
    }

    /// <summary>The edges of a face over which a round side leaves it that runs along them; -1 where there is
    /// none.</summary>
    private readonly void FindLeft(
        int count, bool isLineOfA, ref FlatFeature a, ref FlatFeature b, out int first, out int last)
    {
        first = last = -1;
        ref FlatFeature line = ref isLineOfA ? ref a : ref b;
        if (!(line.RoundnessAt(0) + line.RoundnessAt(1) > 0)) return;
        for (int i = 0; i < count; i++)
        {
            ref ContactPlace place = ref _places[i];
            bool isCrossing = place.CornerA < 0 && place.CornerB < 0;
            if (!isCrossing || Sine(ref a, place.EdgeA, ref b, place.EdgeB) > Parallel) continue;
            last = isLineOfA ? place.EdgeB : place.EdgeA;
            if (first < 0) first = last;
        }
    }

    private readonly SharedLength Beside(int edge, bool isLineOfA, in FlatFeature a, in FlatFeature b) =>
        new(a, isLineOfA ? 0 : edge, b, isLineOfA ? edge : 0, SlackAround);

    private readonly double LengthBeside(int edge, bool isLineOfA, in FlatFeature a, in FlatFeature b) =>
        edge < 0 ? 0 : Beside(edge, isLineOfA, a, b).Length;

    /// <summary>Beyond where a round side leaves a face it lies over the edge, up to where the shorter of the two
    /// ends.</summary>
    private void AddBeside(int edge, bool isLineOfA, ref FlatFeature a, ref FlatFeature b)
    {
        if (edge < 0) return;
        SharedLength shared = Beside(edge, isLineOfA, a, b);
        ref FlatFeature face = ref isLineOfA ? ref b : ref a;
        double u = face[edge].InwardU, v = face[edge].InwardV, sign = isLineOfA ? 1 : -1;
        double atBegin = sign * shared.ApartTowards(shared.Begin, u, v);
        double atEnd = sign * shared.ApartTowards(shared.End, u, v);
        if (shared.IsThere && Math.Min(atBegin, atEnd) < 0)
            AddEnd(shared, atBegin < atEnd ? shared.Begin : shared.End, ref a, ref b);
    }

    /// <summary>The end of an edge that is within reach of a place; -1 where neither is.</summary>
    private readonly int NearEnd(ref FlatFeature feature, int edge, double u, double v)
    {
        int end = feature.NearerEnd(edge, u, v);
        return feature[end].SquaredTo(u, v) <= ReachAround * ReachAround ? end : -1;
    }

    /// <summary>The corner nearest a place, within reach; -1 where none is.</summary>
    private readonly int Nearest(ref FlatFeature feature, double u, double v)
    {
        int nearest = -1;
        double least = ReachAround * ReachAround;
        for (int i = 0; i < feature.Count; i++)
        {
            ref FlatCorner corner = ref feature[i];
            double apartU = corner.U - u, apartV = corner.V - v, squared = apartU * apartU;
            if (squared > least || !((squared += apartV * apartV) <= least)) continue;
            least = squared;
            nearest = i;
        }

        return nearest;
    }

    private static uint CornerOf(ref FlatFeature feature, int corner) =>
        corner < 0 ? ContactFeature.None : ContactFeature.Corner(feature[corner].Id);

    private static uint EdgeOf(ref FlatFeature feature, int edge) =>
        ContactFeature.Edge(feature[feature.Count == 2 ? 0 : edge].Id);

    private static double Sine(ref FlatFeature a, int edgeA, ref FlatFeature b, int edgeB)
    {
        if (a.Count == 2) edgeA = 0;
        if (b.Count == 2) edgeB = 0;
        return Math.Abs(a[edgeA].InwardU * b[edgeB].InwardV - a[edgeA].InwardV * b[edgeB].InwardU);
    }

    /// <summary>Takes away where nearly parallel edges cross, if the outline has no corner there to speak of.</summary>
    private void RemoveFlat()
    {
        for (int i = Count - 1; i >= 0 && Count > 2; i--)
        {
            ref ContactPlace p = ref _places[i > 0 ? i - 1 : Count - 1], q = ref _places[i];
            ref ContactPlace r = ref _places[i + 1 < Count ? i + 1 : 0];
            if (!q.IsFlat) continue;
            double u = r.U - p.U, v = r.V - p.V, area = (q.U - p.U) * v - (q.V - p.V) * u;
            double along = (q.U - p.U) * u + (q.V - p.V) * v, squared = u * u + v * v;
            if (!(area * area <= ReachAround * ReachAround * squared && along >= 0 && along <= squared)) continue;
            for (int k = i; k + 1 < Count; k++) _places[k] = _places[k + 1];
            Count--;
        }
    }

    /// <summary>Two edges that are as good as parallel share a length: its two ends, between both.</summary>
    private void FindAlong(ref FlatFeature a, ref FlatFeature b)
    {
        var shared = new SharedLength(a, 0, b, 0, SlackAround);
        ReachAround = Math.Max(Reach * shared.Length, 2 * SlackAround);
        if (!shared.IsThere || ((a.IsOnSide || b.IsOnSide) && shared.Length <= _least)) return;
        AddEnd(shared, shared.Begin, ref a, ref b);
        if (shared.Length > 2 * ReachAround) AddEnd(shared, shared.End, ref a, ref b);
    }

    private void AddEnd(in SharedLength shared, double along, ref FlatFeature a, ref FlatFeature b)
    {
        if (!shared.TryPlace(along, out ContactPlace place)) return;
        place.Id = ContactFeature.Of(
            CornerOf(ref a, shared.EndOfA(along, ReachAround)), CornerOf(ref b, shared.EndOfB(along, ReachAround)));
        Add(place);
    }
}
