namespace Gjk.Core;

/// <summary>What a surface makes of a contact with one of its triangles: the greater, the further off it is.</summary>
internal enum ContactFit : byte
{
    /// <summary>The direction is one in which the surface ends where the contact is.</summary>
    Stays,

    /// <summary>The surface goes on there, but the direction is near the triangle's normal.</summary>
    Leans,

    /// <summary>The surface goes on there, and another triangle is nearer.</summary>
    Ghost,
}

/// <summary>Whether the direction of a contact lies in a surface's normal cone: whether no triangle around the corner
/// or edge that is furthest along it reaches further. A solid's cone is that part of it which looks out.</summary>
/// <remarks>At the inside of a triangle the cone is both its normals, of a solid the one that looks out. At an edge or
/// corner it is where no triangle with that edge, or that corner, reaches further, however many there are. Triangles
/// without area (<see cref="Flat"/>) say nothing of the surface, but what is joined to them is joined to what they
/// fill.</remarks>
internal readonly ref struct ContactCone
{
    /// <summary>Angle: 2^-20, a few times what rounding to float makes of the poses of two bodies.</summary>
    public const double Slack = 1.0 / (1 << 20);

    /// <summary>Ratio of a triangle's least height to its size and its place, 2^-20: a corner put on the line between
    /// two others is off it by 2^-24 of these. Less makes walls of such triangles, more hides thin ones, as
    /// FloorTests shows.</summary>
    public const double Flat = 1.0 / (1 << 20);

    /// <summary>Cosine of 26 degrees: a contact that is tilted by less is measured along the normal instead.</summary>
    public const float LeastCosine = 0.9f;

    /// <summary>Count: through so many triangles without area, in all, what an edge is joined to is looked for. Without
    /// a bound each of a fan of them doubles the work. Pinned by FloorTests.</summary>
    private const int MostFlattened = 32;

    private readonly TriangleMesh _mesh;
    private readonly Double3 _direction;
    private readonly int _triangle, _outward;

    /// <param name="side">With the surface.</param>
    /// <param name="triangle">The triangle that the contact is of.</param>
    /// <param name="direction">From the surface to the other shape, in its frame; of unit length.</param>
    public ContactCone(PartSide side, int triangle, in Double3 direction)
    {
        (_mesh, _triangle, _direction) = (side.Mesh!, triangle, direction);
        _outward = side.IsSolid ? _mesh.OutwardOf(triangle) : 0;
    }

    /// <summary>A triangle's normal, of a solid outward; 0 where it has none.</summary>
    public static Double3 NormalOf(PartSide side, int triangle)
    {
        side.GetCorners(triangle, out Double3 a, out Double3 b, out Double3 c);
        if (IsFlat(a, b, c)) return default;
        return side.OutwardOf(triangle) < 0 ? -FaceOf(a, b, c) : FaceOf(a, b, c);
    }

    /// <summary>The unit normal of a triangle with area.</summary>
    public static Double3 FaceOf(in Double3 a, in Double3 b, in Double3 c) =>
        UnitOrZero(Double3.Cross(DirectionRange.ToUnit(b - a), DirectionRange.ToUnit(c - a)));

    public static double LongestSide(in Double3 a, in Double3 b, in Double3 c) => Math.Sqrt(
        Math.Max(Math.Max((b - a).LengthSquared, (c - b).LengthSquared), (a - c).LengthSquared));

    /// <summary>Whether a triangle is a line, but for rounding.</summary>
    public static bool IsFlat(in Double3 a, in Double3 b, in Double3 c)
    {
        double longest = LongestSide(a, b, c), height = Double3.Cross(b - a, c - a).Length / longest;
        return !(height > Flat * (longest + a.Length));
    }

    public static int After(int side) => side % 3 == 2 ? side - 2 : side + 1;

    public static int Before(int side) => side % 3 == 0 ? side + 2 : side - 1;

    /// <summary>Whether a triangle of a solid is there as often one way as the other: it bounds nothing.</summary>
    public static bool IsInnerWall(PartSide side, int triangle)
    {
        if (!side.IsSolid) return false;
        TriangleMesh mesh = side.Mesh!;
        mesh.GetCorners(triangle, out _, out Double3 b, out Double3 c);
        int ways = 0;
        for (CornerRing ring = mesh.SidesAt(3 * triangle); ring.MoveNext();)
        {
            Double3 after = mesh.GetCorner(After(ring.Current));
            Double3 before = mesh.GetCorner(Before(ring.Current));
            if (after == b && before == c) ways++;
            else if (after == c && before == b) ways--;
        }

        return ways == 0;
    }

    /// <summary>What becomes of the contact.</summary>
    public ContactFit Judge()
    {
        int first = 3 * _triangle;
        _mesh.GetCorners(_triangle, out Double3 a, out Double3 b, out Double3 c);
        Double3 normal = IsFlat(a, b, c) ? default : FaceOf(a, b, c);
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

    /// <summary>Whether all of a side is as far along the direction.</summary>
    private bool IsLevel(int side)
    {
        Double3 edge = UnitOrZero(_mesh.GetCorner(After(side)) - _mesh.GetCorner(side));
        if (Math.Abs(Double3.Dot(edge, _direction)) > Slack) return false;
        Double3 to = DirectionRange.ToUnit(_mesh.GetCorner(Before(side)) - _mesh.GetCorner(side));
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
        Double3 start = _mesh.GetCorner(side), end = _mesh.GetCorner(After(side));
        Double3 edge = UnitOrZero(end - start);
        for (CornerRing ring = _mesh.SidesAt(side); ring.MoveNext();)
        {
            int at = ring.Current;
            if (at / 3 == from) continue;
            Double3 after = _mesh.GetCorner(After(at)), before = _mesh.GetCorner(Before(at));
            bool isAlong = after == end;
            if (!isAlong && before != end) continue;
            Double3 third = isAlong ? before : after;
            if (third == start || third == end) continue;
            if (IsFlat(start, end, third))
            {
                // From a short side it leads on along its long ones.
                double onward = Double3.Dot(third - start, _direction);
                if (onward > Flat * (LongestSide(start, end, third) + start.Length)) return false;
                if (left == 0) continue;
                left--;
                int mine = isAlong ? at : Before(at);
                if (!EndsAt(After(mine), at / 3, ref left, ref sum)
                    || !EndsAt(Before(mine), at / 3, ref left, ref sum))
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
            Double3 after = UnitOrZero(_mesh.GetCorner(After(at)) - corner);
            Double3 before = UnitOrZero(_mesh.GetCorner(Before(at)) - corner);
            if (Double3.Dot(after, _direction) > Slack || Double3.Dot(before, _direction) > Slack) return false;
            bool isMiddle = Double3.Dot(after, before) < 0;
            if (IsFlat(at))
            {
                // A corner on a longer edge: what is joined to that edge is around the corner too.
                Double3 ignored = default;
                int left = MostFlattened;
                if (isMiddle && !EndsAt(After(at), at / 3, ref left, ref ignored)) return false;
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
