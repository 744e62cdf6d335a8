namespace Gjk.Core;

/// <summary>A face or an edge that a core shows along a contact normal, seen along it: its corners in the plane across
/// the normal, and how far each reaches towards the other shape. With its margin it is a surface
/// (<see cref="SurfacePoint"/>).</summary>
internal unsafe struct FlatFeature
{
    /// <summary>Length, as a fraction of the pair's size: an edge that is shorter, or a face that is narrower, has a
    /// direction that is rounding to more than 1e-7, so the edge is a point and the face an edge. Four times more or
    /// less is far from both.</summary>
    private const double Thin = 1e-9;

    /// <summary>Length, as a fraction of the size: tilted by so little that a margin along its normal and one along the
    /// contact normal differ by less, a surface needs no proof. Pinned by MarginContactTests.</summary>
    private const double Level = 1e-7;

    /// <summary>Cosine between the inner sides of two edges that meet at 45 degrees: beyond sharper corners more than
    /// 1e-6 of the size is within a slack of both. A few times sharper ones would do no harm; blunter ones only cost
    /// time.</summary>
    private const double Sharp = -0.7;

    /// <summary>How many corners there are: two are an edge, more a face.</summary>
    public int Count { get; private set; }

    /// <summary>What the core is widened by.</summary>
    public readonly double Margin;

    /// <summary>How far the axis of an edge's round side is from the edge's ends; 0 for sharp edges.</summary>
    private readonly double _firstRadius, _lastRadius;

    private readonly RoundSide _side;

    private readonly FlatCorner* _corners;

    /// <summary>The length of an edge that stands alone.</summary>
    private double _length;

    /// <summary>How fast the feature rises along the plane's axes; an edge does not rise across itself.</summary>
    private double _riseU, _riseV;

    /// <summary>Where it looks, of unit length: along the plane's axes, and along the contact normal.</summary>
    private double _normalU, _normalV, _normalHeight;

    /// <param name="memory">The corners; what they know of their edges is filled in.</param>
    /// <param name="corners">What they are corners of; at least 2.</param>
    /// <param name="margin">What the core is widened by.</param>
    /// <param name="factor">The pair's unit as a multiple of the shape's.</param>
    /// <param name="size">Of the pair.</param>
    public FlatFeature(FlatCorner* memory, in FaceCorners corners, double margin, double factor, double size)
    {
        this = default;
        int count = corners.Count;
        _corners = memory;
        Count = count;
        Margin = margin;
        _side = corners.Side;
        _firstRadius = corners.FirstRadius * factor;
        _lastRadius = corners.SideRadius * factor;
        double thin = Thin * size, area = 0;
        if (count > 2 && !(Math.Abs(area = Tilt()) > thin * (Width = FindWidth()))) KeepLongest();

        IsDisc = corners.IsDisc && Count > 2;
        Judge(area < 0 ? -1 : 1, size);
    }

    /// <summary>Leaves one edge of a face.</summary>
    public void KeepEdge(int edge, double size)
    {
        if (Count > 2) Keep(edge, (edge + 1) % Count);
        Judge(1, size);
    }

    /// <summary>Finds all that the corners say of it.</summary>
    private void Judge(double turn, double size)
    {
        MeasureEdges(turn);
        if (Count == 2) TiltEdge();
        Secant = Math.Sqrt(1 + _riseU * _riseU + _riseV * _riseV);
        FindNormal();
        IsLevel = (Count > 2 || _length > Thin * size) && Secant <= FaceTilt.MostSecant;
        IsSure = Margin * (Secant - 1) <= Level * size && (Count > 2 || !IsOnSide);
    }

    /// <summary>How fast the gap between this and another opens along a direction of unit length.</summary>
    public readonly double OpensTo(in FlatFeature other, double u, double v) =>
        -(_riseU + other._riseU) * u - (_riseV + other._riseV) * v;

    /// <summary>Whether it is what a disc is shown by, whose edges are not the shape's.</summary>
    public readonly bool IsDisc;

    /// <summary>Whether it lies level enough for its heights to say something; a shape that is scaled unevenly may show
    /// another.</summary>
    public bool IsLevel { get; private set; }

    /// <summary>Whether its surface is known without asking the shape: without margin it is the core's own.</summary>
    public bool IsSure { get; private set; }

    /// <summary>One over the cosine of its tilt: how much longer a margin is along the contact normal.</summary>
    public double Secant { get; private set; }

    /// <summary>Whether it is a line of a round side.</summary>
    public readonly bool IsOnSide => _side != RoundSide.None;

    /// <summary>How far a surface round an end of an edge reaches to its sides, with margin and round side.</summary>
    public readonly double RoundnessAt(int end) => Margin + (end == 0 ? _firstRadius : _lastRadius);

    /// <summary>A corner.</summary>
    public readonly ref FlatCorner this[int index] => ref _corners[index];

    /// <summary>The corner after another.</summary>
    public readonly ref FlatCorner After(int index) => ref _corners[index + 1 < Count ? index + 1 : 0];

    /// <summary>The end of an edge that is nearer to a place; of two as near, the edge's first.</summary>
    public readonly int NearerEnd(int edge, double u, double v)
    {
        int next = edge + 1 < Count ? edge + 1 : 0;
        return _corners[edge].SquaredTo(u, v) <= _corners[next].SquaredTo(u, v) ? edge : next;
    }

    /// <summary>How many edges there are; each begins at the corner of its number.</summary>
    public readonly int EdgeCount => Count > 2 ? Count : 1;

    /// <summary>The largest distance of a corner from the first one.</summary>
    public double Width { get; private set; }

    /// <summary>Whether more corners of a disc can be put between those that are there.</summary>
    public readonly bool CanBeRefined => IsDisc && Count < FaceCorners.Capacity;

    /// <summary>Puts a corner of the disc between each two.</summary>
    public void Refine()
    {
        DiscCorners.Double(_corners, Count);
        Count *= 2;
        MeasureEdges(Tilt() < 0 ? -1 : 1);
        FindNormal();
        Width = FindWidth();
    }

    /// <summary>Gives neighbours that are nearer than a length one name.</summary>
    public readonly void JoinCorners(double length)
    {
        for (int i = 0; i < Count && Count > 2; i++)
        {
            ref FlatCorner p = ref _corners[i], q = ref After(i);
            if (p.SquaredTo(q.U, q.V) <= length * length) q.Id = p.Id = Math.Min(p.Id, q.Id);
        }
    }

    /// <summary>How far a place lies on the inner side of a face's edge.</summary>
    public readonly double Inside(int edge, double u, double v)
    {
        ref FlatCorner p = ref _corners[edge];
        return p.InwardU * (u - p.U) + p.InwardV * (v - p.V);
    }

    /// <summary>Whether a place is beside an edge, not beyond its ends by more than a slack.</summary>
    public readonly bool IsBeside(int edge, double u, double v, double slack)
    {
        ref FlatCorner p = ref _corners[edge], q = ref After(edge);
        bool isAlongU = Math.Abs(p.InwardV) > Math.Abs(p.InwardU);
        double along = isAlongU ? u - p.U : v - p.V, whole = isAlongU ? q.U - p.U : q.V - p.V;
        if (along * whole > 0 && Math.Abs(along) <= Math.Abs(whole)) return true;
        double part = slack / Math.Sqrt(q.SquaredTo(p.U, p.V));
        along /= whole;
        return along >= -part && along <= 1 + part;
    }

    /// <summary>Whether edges meet so sharply that what is near both may lie far beyond their tip.</summary>
    public bool IsSharp { get; private set; }

    /// <summary>Whether a place is in the face or on the edge, or beside it by no more than a slack.</summary>
    public readonly bool Holds(double u, double v, double slack)
    {
        for (int i = 0; i < EdgeCount; i++)
            if (!(Inside(i, u, v) >= -slack)) return false;
        if (Count > 2) return true;
        ref FlatCorner p = ref _corners[0];
        double along = p.InwardV * (u - p.U) - p.InwardU * (v - p.V);
        return Inside(0, u, v) <= slack && along >= -slack && along <= _length + slack;
    }

    /// <summary>How far the shape reaches at a place, margin included.</summary>
    /// <param name="u">The place: in the face, or beside the edge by less than it is round.</param>
    /// <param name="v">Its other coordinate.</param>
    /// <param name="corner">The corner that the place is exactly at, or -1: no face of a mesh is quite flat.</param>
    public readonly SurfacePoint SurfaceAt(double u, double v, int corner)
    {
        ref FlatCorner p = ref _corners[Math.Max(corner, 0)];
        if (Count == 2) return SurfacePoint.OfEdge(
            _corners[0], _corners[1], u, v, Margin, _firstRadius, _lastRadius);
        var surface = new SurfacePoint(
            p.Height + _riseU * (u - p.U) + _riseV * (v - p.V) + Margin * Secant, _normalU, _normalV, _normalHeight);
        if (Margin == 0) return surface;

        // The core's point that belongs to this place; near the upper rim it lies beyond, and the rim is round.
        double footU = u - Margin * surface.NormalU, footV = v - Margin * surface.NormalV;
        double height = double.NegativeInfinity;
        for (int i = 0; i < Count; i++)
        {
            if (Inside(i, footU, footV) >= 0) continue;
            var rim = SurfacePoint.OfEdge(_corners[i], After(i), u, v, Margin, 0, 0);
            if (!(rim.Height > height)) continue;
            height = rim.Height;
            surface = rim;
        }

        return surface;
    }

    /// <summary>Where the face's own part of the surface begins that belongs to a place of the core.</summary>
    public readonly void ToFlatPart(ref double u, ref double v)
    {
        u -= Margin * _riseU / Secant;
        v -= Margin * _riseV / Secant;
    }

    private void FindNormal()
    {
        _normalU = -_riseU / Secant;
        _normalV = -_riseV / Secant;
        _normalHeight = 1 / Secant;
    }

    private readonly double FindWidth()
    {
        double most = 0;
        for (int i = 1; i < Count; i++) most = Math.Max(most, _corners[i].SquaredTo(_corners[0].U, _corners[0].V));
        return Math.Sqrt(most);
    }

    /// <summary>Finds the inner side of each edge.</summary>
    private void MeasureEdges(double turn)
    {
        for (int i = 0; i < EdgeCount; i++)
        {
            ref FlatCorner p = ref _corners[i], q = ref After(i);
            double u = q.U - p.U, v = q.V - p.V;
            _length = Math.Sqrt(u * u + v * v);
            p.InwardU = -v * turn / _length;
            p.InwardV = u * turn / _length;
        }

        IsSharp = false;
        for (int i = 0; i < Count && Count > 2; i++)
        {
            ref FlatCorner p = ref _corners[i], q = ref After(i);
            IsSharp |= p.InwardU * q.InwardU + p.InwardV * q.InwardV < Sharp;
        }
    }

    /// <summary>Finds the plane through a face's corners, by the areas of its projections (Newell); returns twice the
    /// area that is seen, positive where the corners run counter-clockwise.</summary>
    private double Tilt()
    {
        double u = 0, v = 0, h = 0;
        ref FlatCorner o = ref _corners[0];
        for (int i = 1; i + 1 < Count; i++)
        {
            ref FlatCorner p = ref _corners[i], q = ref _corners[i + 1];
            double pu = p.U - o.U, pv = p.V - o.V, ph = p.Height - o.Height;
            double qu = q.U - o.U, qv = q.V - o.V, qh = q.Height - o.Height;
            u += pv * qh - ph * qv;
            v += ph * qu - pu * qh;
            h += pu * qv - pv * qu;
        }

        _riseU = -u / h;
        _riseV = -v / h;
        return h;
    }

    private void TiltEdge()
    {
        ref FlatCorner p = ref _corners[0], q = ref _corners[1];
        double rise = (q.Height - p.Height) / (_length * _length);
        _riseU = rise * (q.U - p.U);
        _riseV = rise * (q.V - p.V);
        Width = _length;
    }

    /// <summary>Leaves of a narrow face its two ends.</summary>
    private void KeepLongest()
    {
        int first = Furthest(0), second = Furthest(first);
        Keep(Math.Min(first, second), Math.Max(first, second));
    }

    private void Keep(int first, int last) => (_corners[0], _corners[1], Count) = (_corners[first], _corners[last], 2);

    private readonly int Furthest(int from)
    {
        int furthest = from;
        ref FlatCorner p = ref _corners[from];
        for (int i = 0; i < Count; i++)
            if (_corners[i].SquaredTo(p.U, p.V) > _corners[furthest].SquaredTo(p.U, p.V)) furthest = i;
        return furthest;
    }
}
