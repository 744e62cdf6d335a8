namespace Gjk.Core.Tests;

/// <summary>Is this the hull of that cloud? Checked against exact arithmetic; the label, with the seed in it, opens
/// every failure message.</summary>
internal static class HullCheck
{
    public static void All(ConvexHull hull, Vector3[] cloud, string label)
    {
        Assert.True(HullOracle.Dimension(cloud) == hull.Dimension, $"{label}: dimension {hull.Dimension}");
        Sources(hull, cloud, label);
        Measures(hull, cloud, label);
        Adjacency(hull, label);
        if (hull.Dimension == 3) Solid(hull, cloud, label);
        else Flat(hull, cloud, label);
    }

    /// <summary>In a direction the highest corner is exactly as high as the highest point of the cloud.</summary>
    public static void Support(ConvexHull hull, Vector3[] cloud, Vector3 direction, string label)
    {
        Vector3 highest = Highest(cloud, direction);
        Vector3 corner = Highest(Corners(hull), direction);
        Assert.True(
            HullOracle.CompareAlong(direction, highest, corner) == 0,
            $"{label}: direction {direction}: corner {corner} is lower than point {highest}");
    }

    public static void NoneAbove(Vector3 a, Vector3 b, Vector3 c, Vector3[] cloud, string label)
    {
        foreach (Vector3 p in cloud)
        {
            if (HullOracle.QuickSide(a, b, c, p) > 0) Assert.Fail($"{label}: point {p} is above {a} {b} {c}");
        }
    }

    public static Vector3[] Corners(ConvexHull hull) =>
        Enumerable.Range(0, hull.VertexCount).Select(hull.GetVertex).ToArray();

    private static Vector3 Highest(Vector3[] points, Vector3 direction)
    {
        // Rounded heights choose the candidates, exact ones the best of them.
        const double WideBound = 1e-12;
        double best = double.NegativeInfinity, reach = 0;
        double[] heights = new double[points.Length];
        for (int i = 0; i < points.Length; i++)
        {
            Vector3 p = points[i];
            double x = (double)direction.X * p.X, y = (double)direction.Y * p.Y, z = (double)direction.Z * p.Z;
            heights[i] = x + y + z;
            best = Math.Max(best, heights[i]);
            reach = Math.Max(reach, Math.Abs(x) + Math.Abs(y) + Math.Abs(z));
        }

        Vector3? highest = null;
        for (int i = 0; i < points.Length; i++)
        {
            if (heights[i] < best - WideBound * reach) continue;
            if (highest is null || HullOracle.CompareAlong(direction, points[i], highest.Value) > 0)
                highest = points[i];
        }

        return highest!.Value;
    }

    private static void Sources(ConvexHull hull, Vector3[] cloud, string label)
    {
        var first = new Dictionary<Vector3, int>();
        for (int i = 0; i < cloud.Length; i++) first.TryAdd(cloud[i] + Vector3.Zero, i);
        int last = -1;
        for (int i = 0; i < hull.VertexCount; i++)
        {
            int source = hull.SourceIndex(i);
            Assert.True(hull.GetVertex(i) == cloud[source], $"{label}: corner {i} is not point {source}");
            Assert.True(first[hull.GetVertex(i)] == source, $"{label}: corner {i} occurs before point {source}");
            Assert.True(source > last, $"{label}: corner {i} is out of order");
            last = source;
        }
    }

    private static void Measures(ConvexHull hull, Vector3[] cloud, string label)
    {
        Vector3 min = cloud.Aggregate(Vector3.Min), max = cloud.Aggregate(Vector3.Max);
        Assert.True(hull.Bounds == new Aabb(min, max), $"{label}: bounds {hull.Bounds.Min} {hull.Bounds.Max}");

        // decimal cannot hold the range, so the radius is compared in whole numbers of 2^-149 / 2^60.
        foreach (Vector3 p in Corners(hull))
        {
            BigInteger squared = Square(p.X, hull.Center.X) + Square(p.Y, hull.Center.Y) + Square(p.Z, hull.Center.Z);
            BigInteger radius = Scaled(hull.BoundingRadius);
            Assert.True(
                squared <= radius * radius, $"{label}: corner {p} is outside the radius {hull.BoundingRadius:R}");
        }

        double tight = Corners(hull).Max(p => (p - hull.Center).Length);
        Assert.True(
            hull.BoundingRadius <= tight * (1 + 1e-14), $"{label}: radius {hull.BoundingRadius:R} is not tight");
    }

    private static BigInteger Square(float x, double center)
    {
        BigInteger difference = Scaled(x) - Scaled(center);
        return difference * difference;
    }

    /// <summary>A double as a whole number of 2^-1074, exactly.</summary>
    private static BigInteger Scaled(double x)
    {
        long bits = BitConverter.DoubleToInt64Bits(x);
        int exponent = (int)(bits >> 52 & 0x7FF);
        BigInteger magnitude = bits & 0xFFFFFFFFFFFFF;
        if (exponent > 0) magnitude = magnitude + (1L << 52) << exponent - 1;
        return bits < 0 ? -magnitude : magnitude;
    }

    private static void Adjacency(ConvexHull hull, string label)
    {
        var edges = new HashSet<(int, int)>();
        for (int t = 0; t < hull.TriangleCount; t++)
        {
            hull.GetTriangle(t, out int a, out int b, out int c);
            foreach ((int from, int to) in new[] { (a, b), (b, c), (c, a) })
            {
                edges.Add((from, to));
                edges.Add((to, from));
            }
        }

        if (hull.Dimension == 1) edges = [(0, 1), (1, 0)];
        int count = 0;
        for (int i = 0; i < hull.VertexCount; i++)
        {
            for (int k = 0; k < hull.NeighborCount(i); k++, count++)
            {
                Assert.True(
                    edges.Contains((i, hull.GetNeighbor(i, k))),
                    $"{label}: {i} and {hull.GetNeighbor(i, k)} share no edge");
                Assert.True(
                    k == 0 || hull.GetNeighbor(i, k - 1) < hull.GetNeighbor(i, k),
                    $"{label}: neighbours of {i} do not ascend");
            }
        }

        Assert.True(count == edges.Count, $"{label}: {count} neighbours, {edges.Count} edges");
    }

    private static void Solid(ConvexHull hull, Vector3[] cloud, string label)
    {
        var edges = new HashSet<(int, int)>();
        var normals = new List<BigInteger[]>[hull.VertexCount];
        for (int i = 0; i < normals.Length; i++) normals[i] = [];
        for (int t = 0; t < hull.TriangleCount; t++)
        {
            hull.GetTriangle(t, out int a, out int b, out int c);
            Assert.True(
                edges.Add((a, b)) && edges.Add((b, c)) && edges.Add((c, a)), $"{label}: triangle {t} repeats an edge");
            Vector3 pa = hull.GetVertex(a), pb = hull.GetVertex(b), pc = hull.GetVertex(c);
            BigInteger[] normal = HullOracle.Normal(pa, pb, pc);
            Assert.False(HullOracle.IsZero(normal), $"{label}: triangle {t} has no area");
            normals[a].Add(normal);
            normals[b].Add(normal);
            normals[c].Add(normal);
            NoneAbove(pa, pb, pc, cloud, $"{label}, triangle {t}");
        }

        foreach ((int from, int to) in edges)
            Assert.True(edges.Contains((to, from)), $"{label}: edge {from} {to} is open");
        Assert.True(
            hull.VertexCount - edges.Count / 2 + hull.TriangleCount == 2,
            $"{label}: Euler, {hull.VertexCount} - {edges.Count / 2} + {hull.TriangleCount}");
        for (int i = 0; i < normals.Length; i++)
            Assert.True(IsRankThree(normals[i]), $"{label}: corner {i} {hull.GetVertex(i)} is not strict");
    }

    private static bool IsRankThree(List<BigInteger[]> normals)
    {
        BigInteger[] first = normals[0];
        BigInteger[]? axis = normals.Select(n => HullOracle.Cross(first, n)).FirstOrDefault(c => !HullOracle.IsZero(c));
        return axis is not null && normals.Any(n => !HullOracle.Dot(axis, n).IsZero);
    }

    /// <summary>Below dimension 3: a corner is a point that is not between two others and not inside a triangle of
    /// others, by trying all.</summary>
    private static void Flat(ConvexHull hull, Vector3[] cloud, string label)
    {
        Vector3[] distinct = cloud.Distinct().ToArray();
        Vector3[] expected = distinct.Where(p => IsCorner(p, distinct)).ToArray();
        Assert.True(
            expected.SequenceEqual(Corners(hull)), $"{label}: {hull.VertexCount} corners, expected {expected.Length}");
        Assert.True(
            hull.TriangleCount == (hull.Dimension < 2 ? 0 : 2 * (hull.VertexCount - 2)),
            $"{label}: {hull.TriangleCount} triangles");
        var all = new HashSet<(int, int, int)>();
        for (int t = 0; t < hull.TriangleCount; t++)
        {
            hull.GetTriangle(t, out int a, out int b, out int c);
            Assert.False(
                HullOracle.IsZero(HullOracle.Normal(hull.GetVertex(a), hull.GetVertex(b), hull.GetVertex(c))),
                $"{label}: triangle {t} has no area");
            Assert.True(all.Add((a, b, c)), $"{label}: triangle {t} is there twice");
        }

        foreach ((int a, int b, int c) in all)
            Assert.True(
                all.Contains((a, c, b)) || all.Contains((c, b, a)) || all.Contains((b, a, c)),
                $"{label}: triangle {a} {b} {c} has no other side");
    }

    /// <summary>In a plane p is a corner when the others fit into less than a half turn around it: some line through p
    /// and another point has all of them on one side, none opposite.</summary>
    private static bool IsCorner(Vector3 p, Vector3[] points)
    {
        BigInteger[] origin = HullOracle.Exact(p);
        BigInteger[][] others = points.Where(q => q != p).Select(
            q => HullOracle.Minus(HullOracle.Exact(q), origin)).ToArray();
        if (others.Length == 0) return true;
        BigInteger[]? normal = null;
        foreach (BigInteger[] q in others)
        {
            foreach (BigInteger[] r in others)
            {
                BigInteger[] cross = HullOracle.Cross(q, r);
                if (normal is null && !HullOracle.IsZero(cross)) normal = cross;
            }

            if (normal is not null) break;
        }

        return others.Any(axis => others.All(q =>
        {
            BigInteger[] cross = HullOracle.Cross(axis, q);
            return HullOracle.IsZero(cross)
                ? HullOracle.Dot(axis, q).Sign > 0
                : HullOracle.Dot(cross, normal!).Sign > 0;
        }));
    }
}
