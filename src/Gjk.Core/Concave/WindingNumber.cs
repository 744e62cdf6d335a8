namespace Gjk.Core;

/// <summary>Computes how often a closed mesh winds around a point: it counts the triangles that a ray along x crosses,
/// with their sides.</summary>
/// <remarks>Idea: looked at along x, a triangle winds around the point 1, -1 or 0 times; if it does, it counts if it
/// lies ahead (Sunday, "Inclusion of a point in a polygon", 2001, in space). An edge belongs to the side on which its
/// lower end is, so that a ray through edges and corners counts each crossing of the surface once: two triangles at an
/// edge go along it in opposite directions, and ask the same question of it. Exactness: both questions are signs of
/// determinants of the coordinates as given, the scale multiplied in (no rounding in double), and of the point in 106
/// bits. Double decides where its error bound lets it, and <see cref="ExactSum"/> else. A point on the surface has no
/// winding number; callers ask for the distance first. The tree only leaves out triangles whose boxes the ray misses
/// for certain.</remarks>
internal sealed class WindingNumber
{
    /// <summary>Ratio to the sum of the terms' magnitudes: 32 units of 2^-53. Differences, products and sums take 16 at
    /// most (<see cref="HullPredicates"/> counts the same), the point's low half 1 more. More costs time
    /// only.</summary>
    private const double Certain = 32.0 / (1L << 53);

    /// <summary>Ratio to lengths in tree units: 2^-20, some roundings of float. More costs time only.</summary>
    private const double BoxRoom = 1.0 / (1 << 20);

    /// <summary>Count: 42 products of three numbers, each of which may leave four parts.</summary>
    private const int MostParts = 192;

    private readonly ExactSum _sum = new(MostParts);

    /// <summary>The winding number about a point.</summary>
    /// <param name="mesh">Has an inside.</param>
    /// <param name="point">In the mesh's frame, not on the surface.</param>
    public int About(TriangleMesh mesh, in VectorDD point)
    {
        PartTree tree = mesh.Tree;
        return SumBelow(mesh, 0, ((Double3)point - tree.Origin) * (1 / tree.Unit), point);
    }

    /// <summary>The sum of the crossings of the triangles below a node.</summary>
    private int SumBelow(TriangleMesh mesh, int node, in Double3 inTree, in VectorDD point)
    {
        PartTree tree = mesh.Tree;
        int winding = 0;
        for (int lane = 0; lane < PartTree.Lanes; lane++)
        {
            int child = tree.Children[node * PartTree.Lanes + lane];
            if (child == PartTree.Empty || !MayCross(tree.Boxes, node * PartTree.Stride + lane, inTree)) continue;
            if (child >= 0) winding += SumBelow(mesh, child, inTree, point);
            else
            {
                int first = PartTree.FirstOf(child), end = first + PartTree.CountOf(child);
                for (int i = first; i < end; i++) winding += Crossing(mesh, tree.Order[i], point);
            }
        }

        return winding;
    }

    /// <summary>Whether the ray from the point along x may meet a box.</summary>
    private static bool MayCross(float[] boxes, int at, in Double3 p)
    {
        double x = 0, y = 0, z = 0;
        for (int i = 0; i < 3; i++)
        {
            int axis = at + PartTree.Axes + 3 * i * PartTree.Lanes;
            double half = boxes[at + PartTree.Halves + i * PartTree.Lanes];
            x += half * Math.Abs(boxes[axis]);
            y += half * Math.Abs(boxes[axis + PartTree.Lanes]);
            z += half * Math.Abs(boxes[axis + 2 * PartTree.Lanes]);
        }

        double room = BoxRoom * (1 + p.SumOfMagnitudes + x + y + z);
        return boxes[at] + x + room >= p.X && Math.Abs(boxes[at + PartTree.Lanes] - p.Y) <= y + room
            && Math.Abs(boxes[at + 2 * PartTree.Lanes] - p.Z) <= z + room;
    }

    private int Crossing(TriangleMesh mesh, int triangle, in VectorDD p)
    {
        mesh.GetCorners(triangle, out Double3 a, out Double3 b, out Double3 c);
        bool isA = IsAbove(a.Z, p.Z), isB = IsAbove(b.Z, p.Z), isC = IsAbove(c.Z, p.Z);
        if (isA == isB && isB == isC) return 0;
        int turns = EdgeCrossing(a, isA, b, isB, p) + EdgeCrossing(b, isB, c, isC, p) + EdgeCrossing(c, isC, a, isA, p);
        return turns != 0 && PlaneSide(a, b, c, p) * turns < 0 ? turns : 0;
    }

    private static bool IsAbove(double z, in DoubleDouble p) => z > p.High || (z == p.High && p.Low < 0);

    /// <summary>Whether the edge crosses the half line from the point along y: 1 upward, -1 downward, 0 not.</summary>
    private int EdgeCrossing(in Double3 u, bool isU, in Double3 v, bool isV, in VectorDD p)
    {
        if (isU == isV) return 0;
        int turn = LineSide(u, v, p);
        return isV ? (turn > 0 ? 1 : 0) : turn < 0 ? -1 : 0;
    }

    /// <summary>On which side of the line from u to v the point lies, seen along x: 1 left, -1 right.</summary>
    private int LineSide(in Double3 u, in Double3 v, in VectorDD p)
    {
        double left = (v.Y - u.Y) * (p.Z.High - u.Z), right = (v.Z - u.Z) * (p.Y.High - u.Y), turn = left - right;
        double lengths = Math.Abs(v.Y - u.Y) * Math.Abs(p.Z.High) + Math.Abs(v.Z - u.Z) * Math.Abs(p.Y.High);
        if (Math.Abs(turn) > Certain * (Math.Abs(left) + Math.Abs(right) + lengths)) return Math.Sign(turn);
        _sum.Clear();
        AddProduct(v.Y, p.Z, 1);
        AddProduct(u.Y, p.Z, -1);
        AddProduct(v.Z, p.Y, -1);
        AddProduct(u.Z, p.Y, 1);
        _sum.AddProduct(v.Z, u.Y, 1);
        _sum.AddProduct(v.Y, u.Z, -1);
        return _sum.Sign;
    }

    private void AddProduct(double a, in DoubleDouble b, double c)
    {
        _sum.AddProduct(a, c, b.High);
        _sum.AddProduct(a, c, b.Low);
    }

    /// <summary>On which side of the triangle's plane the point lies: 1 where the normal points.</summary>
    private int PlaneSide(in Double3 a, in Double3 b, in Double3 c, in VectorDD p)
    {
        Double3 u = b - a, v = c - a, to = (Double3)p - a;
        double yz = u.Y * v.Z, zy = u.Z * v.Y, zx = u.Z * v.X, xz = u.X * v.Z, xy = u.X * v.Y, yx = u.Y * v.X;
        double height = (yz - zy) * to.X + (zx - xz) * to.Y + (xy - yx) * to.Z;
        double largest = (Math.Abs(yz) + Math.Abs(zy)) * (Math.Abs(to.X) + Math.Abs(p.X.High))
            + (Math.Abs(zx) + Math.Abs(xz)) * (Math.Abs(to.Y) + Math.Abs(p.Y.High))
            + (Math.Abs(xy) + Math.Abs(yx)) * (Math.Abs(to.Z) + Math.Abs(p.Z.High));
        if (Math.Abs(height) > Certain * largest) return Math.Sign(height);

        // (b - a) x (c - a) · (p - a) = (a x b + b x c + c x a) · p - a x b · c.
        _sum.Clear();
        AddCross(a, b, p);
        AddCross(b, c, p);
        AddCross(c, a, p);
        AddTriple(a, b, c.X, c.Y, c.Z, -1);
        return _sum.Sign;
    }

    private void AddCross(in Double3 a, in Double3 b, in VectorDD p)
    {
        AddTriple(a, b, p.X.High, p.Y.High, p.Z.High, 1);
        AddTriple(a, b, p.X.Low, p.Y.Low, p.Z.Low, 1);
    }

    private void AddTriple(in Double3 a, in Double3 b, double x, double y, double z, int sign)
    {
        _sum.AddProduct(a.Y, b.Z, sign * x);
        _sum.AddProduct(a.Z, b.Y, -sign * x);
        _sum.AddProduct(a.Z, b.X, sign * y);
        _sum.AddProduct(a.X, b.Z, -sign * y);
        _sum.AddProduct(a.X, b.Y, sign * z);
        _sum.AddProduct(a.Y, b.X, -sign * z);
    }
}
