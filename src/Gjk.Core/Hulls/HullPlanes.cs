namespace Gjk.Core;

/// <summary>The planes of a solid hull's facets, measured from its centre: the hull is where no plane is exceeded.
/// Immutable.</summary>
/// <remarks>
/// A normal is computed in double-double and rounded once, so that even the plane of a sliver supports the hull to
/// within rounding; each is proved to do so when it is made. Triangles that lie in one plane share it.
/// <para>Planes that support a hull need not tell where it ends: those of a disc that was turned by 90 degrees in
/// double are parallel but for rounding, and meet anywhere. What rounding adds to them, e, they add to the hull up to
/// the ratio of its size to the depth of a point inside: the hull grown about that point by 1 + e / depth holds all of
/// it. So a hull without a point that is deep enough has no planes.</para>
/// </remarks>
internal sealed class HullPlanes(double[] blocks)
{
    /// <summary>Planes in a block: the lanes of a 256-bit register of doubles.</summary>
    public const int Lanes = 4;

    /// <summary>Doubles in a block: the normals' x, y and z, and the offsets, of four planes.</summary>
    public const int BlockDoubles = 4 * Lanes;

    /// <summary>Count: up to this many triangles, to clip a ray by all planes is taken to be faster than to cast it.
    /// Estimated from the price of a plane and of a support, not measured; pinned by RayHullTests.</summary>
    private const int MostTriangles = 512;

    /// <summary>Length, as a fraction of the hull's radius: how far above a plane a corner may seem to be. Rounding
    /// makes it 4 u. Pinned by RayHullTests.</summary>
    private const double Above = 8 * RoundOff.Unit;

    /// <summary>Ratio to the hull's radius: how far a hull's inner point must be from all planes. A plane and its
    /// evaluation are off by 11 u of the radius, and the hull reaches two radii from the point: so the planes' hull is
    /// within 1.2e-9 of the radius, which is the 1e-9 of the size that a ray is promised. Pinned by
    /// RayHullTests.</summary>
    private const double LeastDepth = 2e-6;

    /// <summary>Ratio: normals whose components differ by less, and whose planes do, are one plane's. Two facets that
    /// truly differ by so little cannot be told apart in double. Pinned by RayHullTests.</summary>
    private const double SamePlane = 4 * RoundOff.Unit;

    /// <summary>Blocks of four: x, x, x, x, y, y, y, y, z, z, z, z and the offsets. The normals are of unit length. The
    /// last block is filled up with copies of its first plane.</summary>
    public readonly double[] Blocks = blocks;

    /// <summary>The planes of a hull.</summary>
    /// <returns>Null where it is flat or nearly so, has too many, or one of them is not certain.</returns>
    public static HullPlanes? Of(ConvexHull hull)
    {
        if (hull.Dimension < 3 || hull.TriangleCount > MostTriangles) return null;
        var normals = new List<Double3>();
        var offsets = new List<double>();
        Double3 inside = MeanCorner(hull);
        for (int i = 0; i < hull.TriangleCount; i++)
        {
            if (!TryGetPlane(hull, i, out Double3 normal, out double offset)) return null;
            if (!(offset - Double3.Dot(normal, inside) >= LeastDepth * hull.BoundingRadius)) return null;
            if (IsKnown(normals, offsets, normal, offset, hull.BoundingRadius)) continue;
            normals.Add(normal);
            offsets.Add(offset);
        }

        return new HullPlanes(Pack(normals, offsets));
    }

    /// <summary>A point inside, measured from the centre: of n corners the mean is 1/n of the hull's width below any
    /// plane.</summary>
    private static Double3 MeanCorner(ConvexHull hull)
    {
        Double3 sum = default;
        for (int i = 0; i < hull.VertexCount; i++)
        {
            hull.GetVertex(i, out Double3 corner);
            sum += corner - hull.Center;
        }

        return sum * (1.0 / hull.VertexCount);
    }

    /// <summary>The plane of a triangle, through the hull's highest corner over it.</summary>
    private static bool TryGetPlane(ConvexHull hull, int triangle, out Double3 normal, out double offset)
    {
        normal = Normal(hull, triangle, out Double3 corner);
        normal *= 1 / normal.Length;
        double own = Double3.Dot(normal, corner);
        offset = own;
        for (int i = 0; i < hull.VertexCount; i++)
        {
            hull.GetVertex(i, out Double3 other);
            offset = Math.Max(offset, Double3.Dot(normal, other - hull.Center));
        }

        return offset - own <= Above * hull.BoundingRadius;
    }

    /// <summary>The normal of a triangle, rounded once; its length has no meaning.</summary>
    /// <param name="hull">Has the triangle.</param>
    /// <param name="triangle">Its index.</param>
    /// <param name="corner">Its first corner, measured from the hull's centre.</param>
    public static Double3 Normal(ConvexHull hull, int triangle, out Double3 corner)
    {
        hull.GetTriangle(triangle, out int a, out int b, out int c);
        hull.GetVertex(a, out Double3 first);
        hull.GetVertex(b, out Double3 second);
        hull.GetVertex(c, out Double3 third);
        double unit = 1 / PowerOfTwo.AtMost(hull.BoundingRadius);
        corner = first - hull.Center;
        return VectorDD.Normal(first * unit, second * unit, third * unit);
    }

    private static bool IsKnown(
        List<Double3> normals, List<double> offsets, in Double3 normal, double offset, double radius)
    {
        for (int i = 0; i < normals.Count; i++)
        {
            if (Math.Abs(offsets[i] - offset) <= SamePlane * radius
                && (normals[i] - normal).SumOfMagnitudes <= SamePlane)
            {
                return true;
            }
        }

        return false;
    }

    private static double[] Pack(List<Double3> normals, List<double> offsets)
    {
        int blocks = (normals.Count + Lanes - 1) / Lanes;
        double[] packed = new double[blocks * BlockDoubles];
        for (int i = 0; i < blocks * Lanes; i++)
        {
            int plane = i < normals.Count ? i : i - i % Lanes, at = i / Lanes * BlockDoubles + i % Lanes;
            packed[at] = normals[plane].X;
            packed[at + Lanes] = normals[plane].Y;
            packed[at + 2 * Lanes] = normals[plane].Z;
            packed[at + 3 * Lanes] = offsets[plane];
        }

        return packed;
    }
}
