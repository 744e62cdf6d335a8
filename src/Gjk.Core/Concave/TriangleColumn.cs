namespace Gjk.Core;

/// <summary>The column of space over and under a triangle, along its normal.</summary>
internal readonly struct TriangleColumn
{
    private readonly Double3 _a, _b, _c, _face;

    /// <param name="side">Of which it is a part.</param>
    /// <param name="triangle">Its number.</param>
    /// <param name="face">Its normal, to either side.</param>
    public TriangleColumn(PartSide side, int triangle, in Double3 face)
    {
        side.GetCorners(triangle, out _a, out _b, out _c);
        _face = Double3.Dot(Double3.Cross(_b - _a, _c - _a), face) < 0 ? -face : face;
    }

    /// <summary>A corner of the triangle.</summary>
    public Double3 Corner => _a;

    /// <summary>Whether a point is in the column, or beside it by no more than a seam may bend without counting as
    /// bent.</summary>
    public bool Holds(in Double3 point) =>
        IsInside(_a, _b, point) && IsInside(_b, _c, point) && IsInside(_c, _a, point);

    /// <summary>Whether a ball is wholly beside the column.</summary>
    public bool IsBeside(in Double3 middle, double radius) =>
        !IsInside(_a, _b, middle, radius) || !IsInside(_b, _c, middle, radius) || !IsInside(_c, _a, middle, radius);

    /// <summary>Whether a ball reaches the inner side of an edge.</summary>
    private bool IsInside(in Double3 from, in Double3 to, in Double3 middle, double radius = 0)
    {
        Double3 edge = to - from;
        double room = ContactCone.Slack * edge.LengthSquared + radius * edge.Length;
        return Double3.Dot(Double3.Cross(_face, edge), middle - from) >= -room;
    }
}
