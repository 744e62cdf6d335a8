namespace Gjk.Core.Tests.Support;

/// <summary>Shapes as a user writes them: centred, with a generous bounding radius.</summary>
internal enum PlainKind
{
    Octahedron,
    Box,
    Segment,
    Point,
    Sphere,
    Ball,
    FloatBall,
    Disc,
}

/// <summary>One of <see cref="PlainKind"/>, in a few lines each.</summary>
/// <param name="kind">Which.</param>
/// <param name="size">Its radius or half side.</param>
/// <param name="hasIds">Whether corners are named.</param>
internal readonly struct PlainShape(PlainKind kind, double size, bool hasIds) : ISupportMap
{
    private const int XBit = 1, YBit = 2, ZBit = 4;

    public Double3 Center => default;

    public double Margin => kind == PlainKind.Sphere ? size : 0;

    public double BoundingRadius => kind == PlainKind.Point ? 0 : 2 * size;

    private bool IsCurved => kind >= PlainKind.Ball;

    public int Support(in Double3 d, out Double3 point)
    {
        int id = IdTowards(d);
        point = kind switch
        {
            PlainKind.Ball => Unit(d) * size,
            PlainKind.FloatBall => (Vector3)(Unit(d) * size),
            PlainKind.Disc => d.X == 0 && d.Z == 0 ? default : Unit(new(d.X, 0, d.Z)) * size,
            _ => Corner(id),
        };
        return IsCurved || !hasIds ? -1 : id;
    }

    public void GetFace(in Double3 direction, ref FaceCorners corners)
    {
    }

    public bool TryGetVertex(int id, out Double3 point)
    {
        bool isCorner = id >= 0 && id <= (XBit | YBit | ZBit) && !IsCurved && hasIds;
        point = isCorner ? Corner(id) : default;
        return isCorner;
    }

    /// <summary>The signs of the components that count.</summary>
    private int IdTowards(in Double3 d)
    {
        double x = Math.Abs(d.X), y = Math.Abs(d.Y), z = Math.Abs(d.Z);
        return kind switch
        {
            PlainKind.Octahedron => x >= y && x >= z ? (d.X < 0 ? 1 : 0) : y >= z ? (d.Y < 0 ? 3 : 2) : d.Z < 0 ? 5 : 4,
            PlainKind.Box => (d.X < 0 ? XBit : 0) | (d.Y < 0 ? YBit : 0) | (d.Z < 0 ? ZBit : 0),
            PlainKind.Segment => d.Y < 0 ? YBit : 0,
            _ => 0,
        };
    }

    private Double3 Corner(int id)
    {
        double x = (id & XBit) != 0 ? -size : size, y = (id & YBit) != 0 ? -size : size;
        return kind switch
        {
            PlainKind.Octahedron => id / 2 == 0 ? new(x, 0, 0) : id / 2 == 1 ? new(0, x, 0) : new(0, 0, x),
            PlainKind.Box => new(x, 0.5 * y, (id & ZBit) != 0 ? -0.25 * size : 0.25 * size),
            PlainKind.Segment => new(0, y, 0),
            _ => default,
        };
    }

    private static Double3 Unit(in Double3 d)
    {
        Double3 unit = DirectionRange.ToUnit(d);
        return unit * (1 / unit.Length);
    }
}
