namespace Gjk.Core;

/// <summary>The faces, edges and corners that the primitives show in a direction, measured from the local origin, each
/// written once for the shape struct and for <see cref="ConvexShape"/>.</summary>
internal static class PrimitiveFaces
{
    /// <summary>Cosines of a sixteenth, an eighth and three sixteenths of a turn.</summary>
    private const double Cosine1 = 0.92387953251128674, HalfRoot = 0.70710678118654752, Cosine3 = 0.38268343236508977;

    /// <summary>The ids, after the disc's, of the ends of a line on a round side.</summary>
    private const int UpperEnd = FaceCorners.Capacity, LowerEnd = UpperEnd + 1;

    /// <summary>A segment, or the end of it that lies further.</summary>
    public static void Segment(in Double3 a, in Double3 b, in Double3 direction, ref FaceCorners corners)
    {
        bool isEdge = FaceTilt.IsLevelEdge(corners.ToOuter(b - a), corners.OuterDirection(direction));
        int id = PrimitiveSupport.Segment(a, b, direction, out _);
        if (isEdge || id == 0) corners.Add(a, 0);
        if (isEdge || id == 1) corners.Add(b, 1);
    }

    /// <summary>A cylinder's cap, or the line of its side that lies furthest.</summary>
    public static void Cylinder(double radius, double halfHeight, in Double3 direction, ref FaceCorners corners)
    {
        Double3 d = DirectionRange.ToUnit(direction);
        double radial = Math.Sqrt(d.X * d.X + d.Z * d.Z);
        if (IsCap(d, radial, corners))
        {
            Disc(radius, d.Y < 0 ? -halfHeight : halfHeight, ref corners);
            return;
        }

        double x = radius * d.X / radial, z = radius * d.Z / radial;
        corners.Add(new Double3(x, halfHeight, z), UpperEnd);
        if (halfHeight == 0) return;
        corners.Add(new Double3(x, -halfHeight, z), LowerEnd);
        corners.Side = RoundSide.Cylinder;
        corners.SideRadius = radius;
    }

    /// <summary>Whether a cylinder's cap lies more level than the furthest line of its side.</summary>
    private static bool IsCap(in Double3 d, double radial, in FaceCorners corners) => radial == 0
        || Math.Abs(corners.OuterCosine(new Double3(0, 1, 0), d))
            >= corners.OuterCosine(new Double3(d.X / radial, 0, d.Z / radial), d);

    /// <summary>A cone's base, or the line of its side that lies furthest.</summary>
    public static void Cone(double radius, double halfHeight, in Double3 direction, ref FaceCorners corners)
    {
        if (halfHeight == 0)
        {
            Cylinder(radius, 0, direction, ref corners);
            return;
        }

        Double3 d = DirectionRange.ToUnit(direction);
        d *= 1 / d.Length;
        double radial = Math.Sqrt(d.X * d.X + d.Z * d.Z), height = 2 * halfHeight;
        double slant = Math.Sqrt(radius * radius + height * height);
        if (-d.Y * slant >= radial * height + d.Y * radius)
        {
            Disc(radius, -halfHeight, ref corners);
            return;
        }

        // Where the direction hardly leaves the axis it does not tell one line of the side from another.
        corners.Add(new Double3(0, halfHeight, 0), UpperEnd);
        if (radial * slant < FaceTilt.LeastCosine * height) return;
        var rim = new Double3(radius * d.X / radial, -halfHeight, radius * d.Z / radial);
        if (!FaceTilt.IsLevelEdge(new Double3(rim.X, -height, rim.Z), d)) return;
        corners.Add(rim, LowerEnd);
        corners.Side = RoundSide.Cone;
        corners.SideRadius = radius * slant / height;
    }

    /// <summary>A polygon in a disc, at fixed angles, so that its ids stay; contacts that share little of the disc put
    /// more corners between these, which take the ids between theirs.</summary>
    private static void Disc(double radius, double y, ref FaceCorners corners)
    {
        if (radius == 0)
        {
            corners.Add(new Double3(0, y, 0), 0);
            return;
        }

        double a = radius * Cosine1, b = radius * HalfRoot, c = radius * Cosine3;
        AddQuarter(radius, a, b, c, 0, new Double3(1, 0, 0), new Double3(0, 0, 1), y, ref corners);
        AddQuarter(radius, a, b, c, 4, new Double3(0, 0, 1), new Double3(-1, 0, 0), y, ref corners);
        AddQuarter(radius, a, b, c, 8, new Double3(-1, 0, 0), new Double3(0, 0, -1), y, ref corners);
        AddQuarter(radius, a, b, c, 12, new Double3(0, 0, -1), new Double3(1, 0, 0), y, ref corners);
        corners.IsDisc = true;
    }

    /// <summary>A quarter of a disc's corners, from one axis towards the next.</summary>
    private static void AddQuarter(
        double radius, double a, double b, double c, int first, in Double3 from, in Double3 to, double y,
        ref FaceCorners corners)
    {
        var middle = new Double3(0, y, 0);
        corners.Add(from * radius + middle, first * FaceCorners.DiscStep);
        corners.Add(from * a + to * c + middle, (first + 1) * FaceCorners.DiscStep);
        corners.Add(from * b + to * b + middle, (first + 2) * FaceCorners.DiscStep);
        corners.Add(from * c + to * a + middle, (first + 3) * FaceCorners.DiscStep);
    }
}
