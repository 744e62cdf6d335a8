namespace Gjk.Core;

/// <summary>The length that two edges share which lie side by side, seen along the contact normal. Edges on round
/// sides, or with margins, need not be parallel for it: where they part, the surfaces still lie over a place between
/// them.</summary>
/// <remarks>Along the direction in the middle of the two both edges are intervals, and what is shared is where these
/// overlap. Two logs that cross at a small angle touch where they cross, and rest on both ends of what they
/// share.</remarks>
internal readonly unsafe struct SharedLength
{
    /// <summary>What is shared, along the middle direction.</summary>
    public readonly double Begin, End;

    /// <summary>Whether the edges are near parallel and have anything in common.</summary>
    public readonly bool IsThere;

    private readonly Line _a, _b;

    /// <summary>The middle direction.</summary>
    private readonly double _u, _v;

    /// <summary>The tangent of half the angle between the edges.</summary>
    private readonly double _tangent;

    /// <summary>Length: how far sharp edges may part.</summary>
    private readonly double _slack;

    /// <param name="a">What A shows.</param>
    /// <param name="edgeA">Which edge of it.</param>
    /// <param name="b">What B shows.</param>
    /// <param name="edgeB">Which edge of it.</param>
    /// <param name="slack">Length: sharp edges that part by less coincide.</param>
    public SharedLength(in FlatFeature a, int edgeA, in FlatFeature b, int edgeB, double slack)
    {
        ref FlatCorner p = ref a[edgeA], q = ref a.After(edgeA), r = ref b[edgeB], s = ref b.After(edgeB);
        double u = q.U - p.U, v = q.V - p.V, length = Math.Sqrt(u * u + v * v);
        double otherU = s.U - r.U, otherV = s.V - r.V;
        double otherLength = Math.Sqrt(otherU * otherU + otherV * otherV);
        (u, v, otherU, otherV) = (u / length, v / length, otherU / otherLength, otherV / otherLength);
        double cosine = u * otherU + v * otherV, sine = u * otherV - v * otherU;
        double sign = cosine < 0 ? -1 : 1;
        _tangent = Math.Abs(sine) / (1 + Math.Abs(cosine));
        u += sign * otherU;
        v += sign * otherV;
        length = Math.Sqrt(u * u + v * v);
        _u = u / length;
        _v = v / length;
        _a = new Line(a, edgeA, _u, _v);
        _b = new Line(b, edgeB, _u, _v);
        _slack = slack;
        Begin = Math.Max(_a.Least, _b.Least);
        End = Math.Min(_a.Most, _b.Most);
        IsThere = Math.Abs(sine) <= FaceTilt.MostSine && End >= Begin - slack;
    }

    /// <summary>How much is shared.</summary>
    public double Length => End - Begin;

    /// <summary>How far A's edge is from B's across them, towards a direction; negative where it lies the other
    /// way.</summary>
    public double ApartTowards(double along, double u, double v)
    {
        double apart = _a.AcrossAt(along) - _b.AcrossAt(along);
        return u * -_v + v * _u < 0 ? -apart : apart;
    }

    /// <summary>The place between the edges at an end of what they share; false where they part too far.</summary>
    public bool TryPlace(double along, out ContactPlace place)
    {
        double apart = _b.AcrossAt(along) - _a.AcrossAt(along);

        // Beside a slanted edge its end is passed sooner.
        double inward = Math.Min(Math.Abs(apart) * _tangent, Math.Max(0, End - Begin) / 2);
        along += along == Begin ? inward : -inward;
        double across = _a.AcrossAt(along), ofA = _a.RoundnessAt(along), roundness = ofA + _b.RoundnessAt(along);
        apart = _b.AcrossAt(along) - across;
        across += apart * (roundness > 0 ? ofA / roundness : 0.5);
        place = new ContactPlace
        {
            U = _u * along - _v * across,
            V = _v * along + _u * across,
            CornerA = -1,
            CornerB = -1,
            Count = 1,
        };
        return Math.Abs(apart) <= Math.Max(FaceTilt.MostSine * roundness, _slack);
    }

    /// <summary>The end of A's edge that is within reach of where the shared length ends; -1 where none is.</summary>
    public int EndOfA(double along, double reach) => _a.EndAt(along, reach);

    /// <summary>The same of B's.</summary>
    public int EndOfB(double along, double reach) => _b.EndAt(along, reach);

    /// <summary>An edge along and across the middle direction.</summary>
    private readonly struct Line
    {
        public readonly double Least, Most;

        private readonly double _across, _slope, _roundness, _taper;
        private readonly int _first, _last;

        public Line(in FlatFeature feature, int edge, double u, double v)
        {
            int next = edge + 1 < feature.Count ? edge + 1 : 0;
            ref FlatCorner p = ref feature[edge], q = ref feature[next];
            double from = u * p.U + v * p.V, to = u * q.U + v * q.V;
            (_first, _last) = from <= to ? (edge, next) : (next, edge);
            Least = Math.Min(from, to);
            Most = Math.Max(from, to);
            _slope = (u * (q.V - p.V) - v * (q.U - p.U)) / (to - from);
            _across = u * p.V - v * p.U + _slope * (Least - from);
            _roundness = feature.RoundnessAt(_first);
            _taper = (feature.RoundnessAt(_last) - _roundness) / (Most - Least);
        }

        public double AcrossAt(double along) => _across + _slope * (along - Least);

        public double RoundnessAt(double along) => _roundness + _taper * (along - Least);

        public int EndAt(double along, double reach)
        {
            double fromLeast = Math.Abs(along - Least), fromMost = Math.Abs(along - Most);
            return !(Math.Min(fromLeast, fromMost) <= reach) ? -1 : fromLeast <= fromMost ? _first : _last;
        }
    }
}
