namespace Gjk.Core;

/// <summary>The normal of a flat hull's plane, in double-double, from three vertices that span a large
/// triangle.</summary>
internal static class HullNormal
{
    /// <summary>Relative: how far a vertex may be from the plane of the rounded normal. A computed dot product is no
    /// better.</summary>
    private const double Roundoff = 1.0 / (1L << 52);

    /// <summary>The normal, or 0 where double-double cannot tell it: a polygon 2^-50 times as wide as long.</summary>
    public static VectorDD Of(HullVertices hull, in Double3 extents)
    {
        int far = 0;
        double most = 0;
        for (int i = 1; i < hull.Count; i++)
        {
            Double3 edge = (Double3)Edge(hull, i);
            double size = new Double3(edge.X / extents.X, edge.Y / extents.Y, edge.Z / extents.Z).LengthSquared;
            if (size > most) (most, far) = (size, i);
        }

        VectorDD line = Edge(hull, far), normal = default;
        most = 0;
        for (int i = 1; i < hull.Count; i++)
        {
            // Multiplying the cross product by the extents measures the triangle as if the extents were all the same.
            VectorDD candidate = VectorDD.Cross(line, Edge(hull, i));
            double size = Double3.Multiply((Double3)candidate, extents).LengthSquared;
            if (size > most) (most, normal) = (size, candidate);
        }

        return IsFlat(hull, extents, normal) ? normal : default;
    }

    private static bool IsFlat(HullVertices hull, in Double3 extents, in VectorDD normal)
    {
        var n = (Double3)normal;
        double allowed = Roundoff * (Math.Abs(n.X) * extents.X + Math.Abs(n.Y) * extents.Y + Math.Abs(n.Z) * extents.Z);
        for (int i = 1; i < hull.Count; i++)
        {
            if (!(Math.Abs((double)VectorDD.Dot(normal, Edge(hull, i))) <= allowed)) return false;
        }

        return true;
    }

    /// <summary>From vertex 0 to another, without error.</summary>
    private static VectorDD Edge(HullVertices hull, int to) => new(
        DoubleDouble.Sum(hull.X[to], -hull.X[0]),
        DoubleDouble.Sum(hull.Y[to], -hull.Y[0]),
        DoubleDouble.Sum(hull.Z[to], -hull.Z[0]));
}
