using System;

namespace Gjk.Core;

/// <summary>
/// The faces, edges and corners that the primitives show in a direction, measured from the local origin, each written
/// once for the shape struct and for <see cref="ConvexShape"/>.
/// </summary>
internal static class PrimitiveFaces
{
    /// <summary>Count: a disc is shown by an octagon in it, at fixed angles, so that its ids stay.</summary>
    private const int DiscCorners = 8;

    private const double HalfRoot = 0.70710678118654752;

    /// <summary>The ids, after the disc's, of the ends of a line on a round side.</summary>
    private const int UpperEnd = DiscCorners, LowerEnd = DiscCorners + 1;

    /// <summary>A box's face, its corners by their signs as in <see cref="BoxSupport"/>.</summary>
    public static void Box(in Vector3D half, in Vector3D direction, ref FaceCorners corners)
    {
        double x = Math.Abs(direction.X), y = Math.Abs(direction.Y), z = Math.Abs(direction.Z);
        int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
        double along = axis == 0 ? direction.X : axis == 1 ? direction.Y : direction.Z;
        int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
        int first = along < 0 ? 1 << axis : 0;
        bool hasU = HalfOf(half, u) > 0, hasV = HalfOf(half, v) > 0;
        AddBoxCorner(half, first, ref corners);
        if (hasU) AddBoxCorner(half, first | u, ref corners);
        if (hasU && hasV) AddBoxCorner(half, first | u | v, ref corners);
        if (hasV) AddBoxCorner(half, first | v, ref corners);
    }

    /// <summary>A segment, or the end of it that lies further.</summary>
    public static void Segment(in Vector3D a, in Vector3D b, in Vector3D direction, ref FaceCorners corners)
    {
        bool isEdge = FaceTilt.IsLevelEdge(b - a, direction);
        int id = PrimitiveSupport.Segment(a, b, direction, out _);
        if (isEdge || id == 0) corners.Add(a, 0);
        if (isEdge || id == 1) corners.Add(b, 1);
    }

    /// <summary>A triangle, from either side, or one of its edges or corners.</summary>
    public static void Triangle(
        in Vector3D a, in Vector3D b, in Vector3D c, in Vector3D direction, ref FaceCorners corners)
    {
        Vector3D normal = Vector3D.Cross(b - a, c - a);
        if (FaceTilt.IsLevelFace(normal, direction) || FaceTilt.IsLevelFace(-normal, direction))
        {
            corners.Add(a, 0);
            corners.Add(b, 1);
            corners.Add(c, 2);
            return;
        }

        // The corner opposite the edge that is left lies lowest.
        double ha = Vector3D.Dot(a, direction), hb = Vector3D.Dot(b, direction), hc = Vector3D.Dot(c, direction);
        int lowest = ha <= hb && ha <= hc ? 0 : hb <= hc ? 1 : 2;
        Vector3D from = lowest == 0 ? b : a, to = lowest == 2 ? b : c;
        bool isEdge = FaceTilt.IsLevelEdge(to - from, direction);
        int id = PrimitiveSupport.Triangle(a, b, c, direction, out _);
        if (lowest != 0 && (isEdge || id == 0)) corners.Add(a, 0);
        if (lowest != 1 && (isEdge || id == 1)) corners.Add(b, 1);
        if (lowest != 2 && (isEdge || id == 2)) corners.Add(c, 2);
    }

    /// <summary>A cylinder's cap, or the line of its side that lies furthest.</summary>
    public static void Cylinder(double radius, double halfHeight, in Vector3D direction, ref FaceCorners corners)
    {
        Vector3D d = DirectionRange.ToUnit(direction);
        double radial = Math.Sqrt(d.X * d.X + d.Z * d.Z);
        if (Math.Abs(d.Y) >= radial)
        {
            Disc(radius, d.Y < 0 ? -halfHeight : halfHeight, ref corners);
            return;
        }

        double x = radius * d.X / radial, z = radius * d.Z / radial;
        corners.Add(new Vector3D(x, halfHeight, z), UpperEnd);
        if (halfHeight > 0) corners.Add(new Vector3D(x, -halfHeight, z), LowerEnd);
    }

    /// <summary>A cone's base, or the line of its side that lies furthest.</summary>
    public static void Cone(double radius, double halfHeight, in Vector3D direction, ref FaceCorners corners)
    {
        if (halfHeight == 0)
        {
            Cylinder(radius, 0, direction, ref corners);
            return;
        }

        Vector3D d = DirectionRange.ToUnit(direction);
        d *= 1 / d.Length;
        double radial = Math.Sqrt(d.X * d.X + d.Z * d.Z), height = 2 * halfHeight;
        double slant = Math.Sqrt(radius * radius + height * height);
        if (-d.Y * slant >= radial * height + d.Y * radius)
        {
            Disc(radius, -halfHeight, ref corners);
            return;
        }

        // Where the direction hardly leaves the axis it does not tell one line of the side from another.
        corners.Add(new Vector3D(0, halfHeight, 0), UpperEnd);
        if (radial * slant < FaceTilt.LeastCosine * height) return;
        var rim = new Vector3D(radius * d.X / radial, -halfHeight, radius * d.Z / radial);
        if (FaceTilt.IsLevelEdge(new Vector3D(rim.X, -height, rim.Z), d)) corners.Add(rim, LowerEnd);
    }

    private static void Disc(double radius, double y, ref FaceCorners corners)
    {
        double half = radius * HalfRoot;
        corners.Add(new Vector3D(radius, y, 0), 0);
        if (radius == 0) return;
        corners.Add(new Vector3D(half, y, half), 1);
        corners.Add(new Vector3D(0, y, radius), 2);
        corners.Add(new Vector3D(-half, y, half), 3);
        corners.Add(new Vector3D(-radius, y, 0), 4);
        corners.Add(new Vector3D(-half, y, -half), 5);
        corners.Add(new Vector3D(0, y, -radius), 6);
        corners.Add(new Vector3D(half, y, -half), 7);
    }

    private static double HalfOf(in Vector3D half, int bit) => bit == 1 ? half.X : bit == 2 ? half.Y : half.Z;

    private static void AddBoxCorner(in Vector3D half, int signs, ref FaceCorners corners)
    {
        BoxSupport.TryGetVertex(half, signs, out Vector3D point);
        corners.Add(point, signs);
    }
}
