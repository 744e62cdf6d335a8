namespace Gjk.Core;

/// <summary>How a contact's direction fits a surface, at one of its triangles. Larger values fit worse.</summary>
internal enum ContactFit : byte
{
    /// <summary>The surface ends in this direction, where the contact is.</summary>
    Stays,

    /// <summary>The surface goes on there, but the direction is near the triangle's normal.</summary>
    Leans,

    /// <summary>The surface goes on there, and another triangle is nearer.</summary>
    Ghost,
}

/// <summary>Whether the direction of a contact lies in a surface's normal cone: no triangle around the corner or edge
/// that is furthest along it reaches further. The cone of a solid is only the part that looks out.</summary>
/// <remarks>Inside a triangle the cone is its two normals; of a solid, the one that looks out. At an edge or corner it
/// is where no triangle with that edge, or that corner, reaches further, however many there are. Triangles without area
/// (<see cref="Flat"/>) say nothing of the surface; triangles joined to one count as joined to each other.</remarks>
internal readonly ref struct ContactCone
{
    /// <summary>Angle: 2^-20, a few times the rounding of two bodies' poses to float.</summary>
    public const double Slack = 1.0 / (1 << 20);

    /// <summary>Ratio of a triangle's least height to its size and its distance from the origin: 2^-20. A corner put on
    /// the line between two others is off it by 2^-24 of these. With less, such triangles become walls; with more, thin
    /// ones are hidden, as FloorTests shows.</summary>
    public const double Flat = 1.0 / (1 << 20);

    /// <summary>Cosine of 26 degrees: a contact that is tilted by less is measured along the normal instead.</summary>
    public const float LeastCosine = 0.9f;

    /// <summary>Count: the search for what is joined to an edge goes through at most so many triangles without area.
    /// Without a bound each of a fan of them doubles the work. Pinned by FloorTests.</summary>
    private const int MostFlattened = 32;

    private readonly TriangleMesh _mesh;
    private readonly Double3 _direction;
    private readonly int _triangle, _outward;

    /// <param name="side">The side with the surface.</param>
    /// <param name="triangle">The triangle of the contact.</param>
    /// <param name="direction">From the surface to the other shape, in its frame; of unit length.</param>
    public ContactCone(PartSide side, int triangle, in Double3 direction)
    {
        (_mesh, _triangle, _direction) = (side.Mesh!, triangle, direction);
        _outward = side.IsSolid ? _mesh.OutwardOf(triangle) : 0;
    }

    /// <summary>A triangle's normal, outward for a solid; 0 where it has no area.</summary>
    public static Double3 NormalOf(PartSide side, int triangle)
    {
        side.GetCorners(triangle, out Double3 a, out Double3 b, out Double3 c);
        if (IsFlat(a, b, c)) return default;
        return side.OutwardOf(triangle) < 0 ? -UnitNormalOf(a, b, c) : UnitNormalOf(a, b, c);
    }

    /// <summary>The unit normal of a triangle with area.</summary>
    public static Double3 UnitNormalOf(in Double3 a, in Double3 b, in Double3 c) =>
        UnitOrZero(Double3.Cross(DirectionRange.ToUnit(b - a), DirectionRange.ToUnit(c - a)));

    public static double LongestSide(in Double3 a, in Double3 b, in Double3 c) => Math.Sqrt(
        Math.Max(Math.Max((b - a).LengthSquared, (c - b).LengthSquared), (a - c).LengthSquared));

    /// <summary>Whether a triangle is a line, but for rounding.</summary>
    public static bool IsFlat(in Double3 a, in Double3 b, in Double3 c)
    {
        double longest = LongestSide(a, b, c), height = Double3.Cross(b - a, c - a).Length / longest;
        return !(height > Flat * (longest + a.Length));
    }

    /// <summary>Whether a solid's triangle appears equally often in both orientations, so that it bounds
    /// nothing.</summary>
    public static bool IsInnerWall(PartSide side, int triangle)
    {
        if (!side.IsSolid) return false;
        TriangleMesh mesh = side.Mesh!;
        mesh.GetCorners(triangle, out _, out Double3 b, out Double3 c);
        int ways = 0;
        for (CornerRing ring = mesh.SidesAt(3 * triangle); ring.MoveNext();)
        {
            Double3 after = mesh.GetCorner(TriangleList.NextSide(ring.Current));
            Double3 before = mesh.GetCorner(TriangleList.PreviousSide(ring.Current));
            if (after == b && before == c) ways++;
            else if (after == c && before == b) ways--;
        }

        return ways == 0;
    }

    /// <summary>How the contact fits the surface.</summary>
    public ContactFit Judge()
    {
        int first = 3 * _triangle;
        _mesh.GetCorners(_triangle, out Double3 a, out Double3 b, out Double3 c);
        Double3 normal = IsFlat(a, b, c) ? default : UnitNormalOf(a, b, c);
        double along = Double3.Dot(normal, _direction);
        bool isFace = along != 0 && (_direction - normal * along).LengthSquared <= Slack * Slack;
        along = _outward == 0 ? Math.Abs(along) : along * _outward;
        if (isFace) return along > 0 ? ContactFit.Stays : ContactFit.Ghost;
        double heightB = Double3.Dot(_direction, b - a), heightC = Double3.Dot(_direction, c - a);
        int top = heightB > 0 ? (heightC > heightB ? 2 : 1) : heightC > 0 ? 2 : 0;
        int next = first + top, last = first + (top + 2) % 3;
        bool isNext = IsLevel(next), isLast = IsLevel(last);
        bool stays = isNext || isLast
            ? (!isNext || EndsAt(next)) && (!isLast || EndsAt(last))
            : EndsAround(next);
        return stays ? ContactFit.Stays : along >= LeastCosine ? ContactFit.Leans : ContactFit.Ghost;
    }

    private static Double3 UnitOrZero(in Double3 v)
    {
        Double3 unit = DirectionRange.ToUnit(v);
        double length = unit.Length;
        return length > 0 ? unit * (1 / length) : default;
    }

    /// <summary>Whether the whole side is level: it reaches equally far along the direction.</summary>
    private bool IsLevel(int side)
    {
        Double3 edge = UnitOrZero(_mesh.GetCorner(TriangleList.NextSide(side)) - _mesh.GetCorner(side));
        if (Math.Abs(Double3.Dot(edge, _direction)) > Slack) return false;
        Double3 to = DirectionRange.ToUnit(_mesh.GetCorner(TriangleList.PreviousSide(side)) - _mesh.GetCorner(side));
        return !(Double3.Dot(UnitOrZero(to - edge * Double3.Dot(edge, to)), _direction) > Slack) || IsFlat(side);
    }

    private bool IsFlat(int side)
    {
        _mesh.GetCorners(side / 3, out Double3 a, out Double3 b, out Double3 c);
        return IsFlat(a, b, c);
    }

    private bool EndsAt(int side)
    {
        Double3 sum = default;
        int left = MostFlattened;
        return EndsAt(side, -1, ref left, ref sum) && IsOutward(sum);
    }

    private bool IsOutward(in Double3 sum) => _outward == 0 || Double3.Dot(sum, _direction) * _outward > -Slack;

    /// <summary>Whether no triangle at a side, or joined to it, reaches beyond it.</summary>
    private bool EndsAt(int side, int from, ref int left, ref Double3 sum)
    {
        Double3 start = _mesh.GetCorner(side), end = _mesh.GetCorner(TriangleList.NextSide(side));
        Double3 edge = UnitOrZero(end - start);
        for (CornerRing ring = _mesh.SidesAt(side); ring.MoveNext();)
        {
            int at = ring.Current;
            if (at / 3 == from) continue;
            Double3 after = _mesh.GetCorner(TriangleList.NextSide(at));
            Double3 before = _mesh.GetCorner(TriangleList.PreviousSide(at));
            bool isAlong = after == end;
            if (!isAlong && before != end) continue;
            Double3 third = isAlong ? before : after;
            if (third == start || third == end) continue;
            if (IsFlat(start, end, third))
            {
                // The search goes on along the triangle's long sides.
                double onward = Double3.Dot(third - start, _direction);
                if (onward > Flat * (LongestSide(start, end, third) + start.Length)) return false;
                if (left == 0) continue;
                left--;
                int mine = isAlong ? at : TriangleList.PreviousSide(at);
                if (!EndsAt(TriangleList.NextSide(mine), at / 3, ref left, ref sum)
                    || !EndsAt(TriangleList.PreviousSide(mine), at / 3, ref left, ref sum))
                {
                    return false;
                }

                continue;
            }

            Double3 to = DirectionRange.ToUnit(third - start);
            Double3 inward = UnitOrZero(to - edge * Double3.Dot(edge, to));
            if (Double3.Dot(inward, _direction) > Slack) return false;
            if (_outward != 0) sum += isAlong ? Double3.Cross(edge, inward) : Double3.Cross(inward, edge);
        }

        return true;
    }

    /// <summary>Whether no triangle around the corner at which a side begins reaches beyond it.</summary>
    private bool EndsAround(int side)
    {
        Double3 corner = _mesh.GetCorner(side), sum = default;
        for (CornerRing ring = _mesh.SidesAt(side); ring.MoveNext();)
        {
            int at = ring.Current;
            Double3 after = UnitOrZero(_mesh.GetCorner(TriangleList.NextSide(at)) - corner);
            Double3 before = UnitOrZero(_mesh.GetCorner(TriangleList.PreviousSide(at)) - corner);
            if (Double3.Dot(after, _direction) > Slack || Double3.Dot(before, _direction) > Slack) return false;
            bool isMiddle = Double3.Dot(after, before) < 0;
            if (IsFlat(at))
            {
                // A corner on a longer edge: triangles joined to that edge are around the corner too.
                Double3 ignored = default;
                int left = MostFlattened;
                if (isMiddle && !EndsAt(TriangleList.NextSide(at), at / 3, ref left, ref ignored)) return false;
            }
            else if (_outward != 0)
            {
                Double3 cross = Double3.Cross(after, before);
                double sine = cross.Length;
                if (sine > 0) sum += cross * (ArcTangent.Atan2(sine, Double3.Dot(after, before)) / sine);
            }
        }

        return IsOutward(sum);
    }
}
