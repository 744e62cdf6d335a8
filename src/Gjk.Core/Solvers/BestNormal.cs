namespace Gjk.Core;

/// <summary>The direction in which a round side and what another shape shows of itself are furthest apart.</summary>
/// <remarks>
/// <para>Near the line that it shows, a cylinder's or a cone's side is the hull of two balls about its axis; a sharp
/// edge is one of two balls without radius. The gap along a direction is the least of the four gaps between such balls,
/// and each of them is linear in the direction. So it is largest where two or four of them are equal: across the side,
/// towards an end of the other, across the other, towards an end of the side, or across both. A face adds its own
/// normal.</para>
/// <para>All of it is closed form, so the direction depends on the shapes alone and not on where a search began. What
/// the shapes do not show is not looked at: whoever uses the direction asks them how far it separates them.</para>
/// </remarks>
internal ref struct BestNormal
{
    /// <summary>Length: gaps that differ by less are equal, and the earlier direction stays. Rounding turns the axes of
    /// bodies that were placed in parallel by 1e-7, which costs a gap the square of that. Four times more or less turns
    /// the normal by no more than 1e-6.</summary>
    private const double Equal = 1e-12;

    private readonly Double3 _known;
    private readonly double _equal;
    private double _gap;

    /// <summary>Looks for the direction.</summary>
    /// <param name="round">What shows a round side.</param>
    /// <param name="other">What the other shape shows.</param>
    /// <param name="center">The other's centre, for shapes that show nothing.</param>
    /// <param name="known">From the round side to the other, of unit length, as a search found it.</param>
    /// <param name="size">Of the pair.</param>
    public BestNormal(in FaceCorners round, in FaceCorners other, in Double3 center, in Double3 known, double size)
    {
        _known = known;
        _equal = Equal * size;
        _gap = double.NegativeInfinity;
        Normal = known;
        var side = new BallEdge(round, 0, 1, known);
        Axis = side.Axis;
        int first = 0, last = 0;
        if (other.Count > 1) FindEdge(other, out first, out last);
        BallEdge edge = other.Count == 0 ? new BallEdge(center) : new BallEdge(other, first, last, -known);
        Try(side, edge, other, side.Towards(side.MiddleBeside(edge) - side.First));
        Try(side, edge, other, side.Towards(edge.First - side.First));
        if (other.Count < 2) return;
        Try(side, edge, other, side.Towards(edge.Last - side.First));
        Try(side, edge, other, -edge.Towards(side.First - edge.First));
        Try(side, edge, other, -edge.Towards(side.Last - edge.First));
        Try(side, edge, other, side.Across(edge, known));
        if (other.Count > 2) Try(side, edge, other, FaceNormal(other));
    }

    /// <summary>From the round side to the other, of unit length.</summary>
    public Double3 Normal { get; private set; }

    /// <summary>Along the axis of the round side, of unit length.</summary>
    public Double3 Axis { get; }

    private void Try(in BallEdge side, in BallEdge edge, in FaceCorners other, in Double3 direction)
    {
        double gap = other.Count > 2 ? double.PositiveInfinity : -edge.Reach(-direction);
        for (int i = 0; i < other.Count && other.Count > 2; i++)
            gap = Math.Min(gap, Double3.Dot(direction, other[i]));
        gap -= side.Reach(direction);
        if (!(gap > _gap + _equal && Double3.Dot(direction, _known) > 0)) return;
        _gap = gap;
        Normal = direction;
    }

    /// <summary>The nearest corner, and the nearer one of its neighbours.</summary>
    private readonly void FindEdge(in FaceCorners other, out int first, out int last)
    {
        first = 0;
        for (int i = 1; i < other.Count; i++)
            if (Double3.Dot(_known, other[i]) < Double3.Dot(_known, other[first])) first = i;
        int next = (first + 1) % other.Count, before = (first + other.Count - 1) % other.Count;
        last = Double3.Dot(_known, other[next]) <= Double3.Dot(_known, other[before]) ? next : before;
        if (other.Count == 2) (first, last) = (0, 1);
    }

    /// <summary>Towards a face, of unit length (Newell).</summary>
    private readonly Double3 FaceNormal(in FaceCorners face)
    {
        Double3 normal = default;
        for (int i = 1; i + 1 < face.Count; i++)
            normal += Double3.Cross(face[i] - face[0], face[i + 1] - face[0]);
        double length = normal.Length;
        return normal * (Double3.Dot(normal, _known) < 0 ? -1 / length : 1 / length);
    }
}

/// <summary>The hull of two balls: a round side near the line that it shows, or a sharp edge.</summary>
internal readonly struct BallEdge
{
    /// <summary>Sine: what leans more than this against the plane across the axis is what rounding left of a vector
    /// along it. A direction made of it is off by as much, a tenth of what a normal may be. Four times more or less
    /// only moves where the search's own direction stays. Pinned by ConeAboutCentreTests.</summary>
    private const double Leaning = 1e-7;

    /// <summary>The balls' centres.</summary>
    public readonly Double3 First, Last;

    /// <summary>From the first to the last, of unit length.</summary>
    public readonly Double3 Axis;

    private readonly double _firstRadius, _lastRadius;

    /// <summary>How far a direction in which both balls reach equally far leans along the axis.</summary>
    private readonly double _sine;

    /// <param name="corners">What a shape shows.</param>
    /// <param name="first">One end.</param>
    /// <param name="last">The other.</param>
    /// <param name="outward">The direction in which the shape shows it.</param>
    public BallEdge(in FaceCorners corners, int first, int last, in Double3 outward)
    {
        First = corners[first];
        Last = corners[last];
        _firstRadius = corners.FirstRadius;
        _lastRadius = corners.SideRadius;
        if (_lastRadius > 0)
        {
            Double3 line = (Last - First) * (1 / (Last - First).Length);
            Double3 across = outward - line * Double3.Dot(line, outward);
            across *= 1 / across.Length;
            First -= across * _firstRadius;
            Last -= across * _lastRadius;
        }

        double length = (Last - First).Length;
        if (!(length > 0)) return;
        Axis = (Last - First) * (1 / length);
        _sine = (_firstRadius - _lastRadius) / length;
    }

    /// <summary>A point.</summary>
    public BallEdge(in Double3 point) => First = Last = point;

    /// <summary>How far it reaches in a direction.</summary>
    public double Reach(in Double3 direction) =>
        Math.Max(Double3.Dot(direction, First) + _firstRadius, Double3.Dot(direction, Last) + _lastRadius);

    /// <summary>The middle of the part of another that lies beside this, at least of its nearer end.</summary>
    public Double3 MiddleBeside(in BallEdge other)
    {
        double length = Double3.Dot(Axis, Last - First), most = Double3.Dot(Axis, other.Last - other.First);
        double from = Double3.Dot(Axis, other.First - First), to = from + most;
        from = Math.Max(0, Math.Min(length, from));
        to = Math.Max(0, Math.Min(length, to));
        double part = ((from + to) / 2 - Double3.Dot(Axis, other.First - First)) / most;
        return part >= 0 && part <= 1 ? other.First + (other.Last - other.First) * part : other.First;
    }

    /// <summary>Across it, as near as can be to another direction; of unit length. Zero where that is along the
    /// axis, and what is left across it is rounding.</summary>
    public Double3 Towards(in Double3 other)
    {
        Double3 across = other - Axis * Double3.Dot(Axis, other);
        double along = Double3.Dot(Axis, across);
        if (!(Math.Abs(along) <= Leaning * across.Length)) return default;
        return Axis * _sine + across * (Math.Sqrt(1 - _sine * _sine) / across.Length);
    }

    /// <summary>From this to another, across both, on the side where a known direction is; of unit length.</summary>
    public Double3 Across(in BallEdge other, in Double3 known)
    {
        Double3 cross = Double3.Cross(Axis, other.Axis);
        double cosine = Double3.Dot(Axis, other.Axis), squared = cross.LengthSquared;
        double along = (_sine + cosine * other._sine) / squared, otherAlong = (-other._sine - cosine * _sine) / squared;
        double rest = Math.Sqrt((1 - along * _sine + otherAlong * other._sine) / squared);
        return Axis * along + other.Axis * otherAlong + cross * (Double3.Dot(cross, known) < 0 ? -rest : rest);
    }
}
