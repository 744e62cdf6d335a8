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
/// or edge that is furthest along it reaches further.</summary>
/// <remarks>
/// At the inside of a triangle the cone is both its normals. At an edge it is what lies between the normals of its two
/// triangles where these bend away from it, a single direction where they are flat, nothing where they bend towards it:
/// so the cone tells convex, flat and concave edges apart, seen from the side of the contact. Edges with one triangle
/// or more than two do not restrict it. A corner's cone is that of all triangles around it that are joined by edges.
///
/// Tolerance: a direction is rounded to float at least once, and so are the poses that should make two faces parallel.
/// So an angle of <see cref="Slack"/> is none. It is taken of unit directions: of what a neighbour reaches beyond, by
/// its own length, so that slivers count like all others.
/// </remarks>
internal readonly ref struct ContactCone
{
    /// <summary>Angle: 2^-20, a few times what rounding to float makes of the poses of two bodies. More lets normals
    /// tilt, as SeamContactTests shows; less takes contacts of bodies at rest for leaning ones, which costs time
    /// only.</summary>
    public const double Slack = 1.0 / (1 << 20);

    /// <summary>Cosine of 26 degrees: a contact that is tilted by less is measured along the triangle's normal instead.
    /// A body that rocks tilts by a few; more or less makes no difference to one at rest.</summary>
    public const float LeastCosine = 0.9f;

    /// <summary>Count: over so many triangles without area the neighbour of an edge is looked for.</summary>
    private const int MostFlattened = 8;

    private readonly TriangleMesh _mesh;
    private readonly Double3 _direction;

    /// <param name="mesh">The surface.</param>
    /// <param name="direction">From the surface to the other shape, in its frame; of unit length.</param>
    public ContactCone(TriangleMesh mesh, in Double3 direction)
    {
        _mesh = mesh;
        _direction = direction;
    }

    /// <summary>What becomes of a contact.</summary>
    /// <param name="triangle">The triangle that it is of.</param>
    /// <param name="normal">The triangle's normal on the side of the contact, where it leans.</param>
    public ContactFit Judge(int triangle, out Double3 normal)
    {
        int first = 3 * triangle;
        _mesh.GetCorners(triangle, out Double3 a, out Double3 b, out Double3 c);
        normal = UnitOrZero(Double3.Cross(DirectionRange.ToUnit(b - a), DirectionRange.ToUnit(c - a)));
        double along = Double3.Dot(normal, _direction);
        if (along < 0) (along, normal) = (-along, -normal);
        if ((_direction - normal * along).LengthSquared <= Slack * Slack) return ContactFit.Stays;
        double heightB = Double3.Dot(_direction, b - a), heightC = Double3.Dot(_direction, c - a);
        int top = heightB > 0 ? (heightC > heightB ? 2 : 1) : heightC > 0 ? 2 : 0;
        int next = first + top, last = first + (top + 2) % 3;
        bool isNext = IsLevel(next), isLast = IsLevel(last);
        bool stays = isNext || isLast
            ? (!isNext || EndsAt(next, MostFlattened)) && (!isLast || EndsAt(last, MostFlattened))
            : EndsAround(next);
        return stays ? ContactFit.Stays : along >= LeastCosine ? ContactFit.Leans : ContactFit.Ghost;
    }

    private static int After(int side) => side % 3 == 2 ? side - 2 : side + 1;

    private static int Before(int side) => side % 3 == 0 ? side + 2 : side - 1;

    private static Double3 UnitOrZero(in Double3 v)
    {
        Double3 unit = DirectionRange.ToUnit(v);
        double length = unit.Length;
        return length > 0 ? unit * (1 / length) : default;
    }

    /// <summary>Whether all of a side is as far along the direction, and the triangle is not further.</summary>
    private bool IsLevel(int side)
    {
        Double3 edge = UnitOrZero(_mesh.GetCorner(After(side)) - _mesh.GetCorner(side));
        return Math.Abs(Double3.Dot(edge, _direction)) <= Slack && !ReachesBeyond(side, edge, out _);
    }

    /// <summary>Whether the triangle at a side reaches further than the side.</summary>
    /// <param name="side">The side.</param>
    /// <param name="edge">Along it, of unit length.</param>
    /// <param name="isFlattened">Whether the triangle has no area, so that it tells nothing.</param>
    private bool ReachesBeyond(int side, in Double3 edge, out bool isFlattened)
    {
        Double3 to = DirectionRange.ToUnit(_mesh.GetCorner(Before(side)) - _mesh.GetCorner(side));
        Double3 inward = UnitOrZero(to - edge * Double3.Dot(edge, to));
        isFlattened = inward.LengthSquared == 0;
        return Double3.Dot(inward, _direction) > Slack;
    }

    /// <summary>Whether what is joined to a side does not reach beyond it.</summary>
    private bool EndsAt(int side, int most)
    {
        int twin = _mesh.TwinOf(side);
        if (twin < 0 || most == 0) return true;
        Double3 edge = UnitOrZero(_mesh.GetCorner(After(side)) - _mesh.GetCorner(side));
        if (ReachesBeyond(twin, edge, out bool isFlattened)) return false;
        return !isFlattened || (EndsAt(After(twin), most - 1) && EndsAt(Before(twin), most - 1));
    }

    /// <summary>Whether no triangle around the corner at which a side begins reaches beyond it.</summary>
    private bool EndsAround(int side)
    {
        Double3 corner = _mesh.GetCorner(side);
        return EndsAround(side, side, corner, out bool isBorder)
            && (!isBorder || EndsAround(Before(side), side, corner, out _));
    }

    /// <summary>As the other, one way round.</summary>
    private bool EndsAround(int side, int start, in Double3 corner, out bool isBorder)
    {
        isBorder = false;
        for (int steps = 0; steps < _mesh.TriangleCount; steps++)
        {
            int twin = _mesh.TwinOf(side);
            isBorder = twin < 0;
            if (isBorder || twin / 3 == start / 3) return true;
            Double3 to = UnitOrZero(_mesh.GetCorner(Before(twin)) - corner);
            if (Double3.Dot(to, _direction) > Slack) return false;

            // On to the other side at the corner.
            side = _mesh.GetCorner(twin) == corner ? Before(twin) : After(twin);
        }

        return true;
    }
}
