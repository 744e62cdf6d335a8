namespace Gjk.Exact.Meshes;

/// <summary>Surfaces as people and programs make them, of about unit size.</summary>
public static class Surfaces
{
    /// <summary>A grid of cells, two triangles each, bent by a function of its lines; a closed grid's last line is the
    /// first.</summary>
    public static TriangleSoup Sheet(
        int around, int across, Func<int, int, Vector3> at, bool closesAround = false, bool closesAcross = false)
    {
        int rows = closesAround ? around : around + 1, columns = closesAcross ? across : across + 1;
        var points = new Vector3[rows * columns];
        for (int i = 0; i < points.Length; i++) points[i] = at(i / columns, i % columns);
        var indices = new List<int>(6 * around * across);
        for (int i = 0; i < around; i++)
        {
            for (int j = 0; j < across; j++)
            {
                int here = i * columns, next = (i + 1) % rows * columns, right = (j + 1) % columns;
                indices.AddRange([here + j, here + right, next + j, here + right, next + right, next + j]);
            }
        }

        return new TriangleSoup(points, [.. indices]);
    }

    /// <summary>A closed ring about y.</summary>
    public static TriangleSoup Torus(int around, int across, double radius = 1, double tube = 0.35) => Sheet(
        around, across, (i, j) =>
        {
            double a = 2 * Math.PI * i / around, b = 2 * Math.PI * j / across, r = radius + tube * Math.Cos(b);
            return new((float)(r * Math.Cos(a)), (float)(tube * Math.Sin(b)), (float)(r * Math.Sin(a)));
        }, closesAround: true, closesAcross: true);

    /// <summary>2 n n triangles over the unit square of the xz plane.</summary>
    public static TriangleSoup Grid(int n, Func<float, float, float>? height = null) => Sheet(n, n, (i, j) =>
    {
        float x = (float)i / n - 0.5f, z = (float)j / n - 0.5f;
        return new Vector3(x, height?.Invoke(x, z) ?? 0, z);
    });

    /// <summary>A box as a closed mesh.</summary>
    public static TriangleSoup Box(Vector3 half) => new(
        Clouds.Box(-half),
        [
            0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
            2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5,
        ]);

    /// <summary>Triangles at random, some of them degenerate or repeated.</summary>
    public static TriangleSoup Soup(Rng random, int count, double size)
    {
        var points = new List<Vector3>();
        var indices = new List<int>();
        for (int i = 0; i < count; i++)
        {
            Vector3 middle = random.Vector(1);
            for (int k = 0; k < 3; k++)
            {
                points.Add(random.OneIn(20) && points.Count > 0 ? points[^1] : middle + random.Vector(size));
                indices.Add(points.Count - 1);
            }

            if (random.OneIn(10)) indices.AddRange(indices[^3..]);
        }

        return new TriangleSoup([.. points], [.. indices]);
    }

    /// <summary>A ball with dents, closed at poles that are many points in one place.</summary>
    public static TriangleSoup Ball(int around, int across, Func<double, double, double> radius) => Sheet(
        around, across, (i, j) =>
        {
            double a = 2 * Math.PI * i / around, b = Math.PI * j / across;
            double r = j == 0 || j == across ? radius(0, b) : radius(a, b), wide = j % across == 0 ? 0 : Math.Sin(b);
            return new((float)(r * wide * Math.Cos(a)), (float)(r * Math.Cos(b)), (float)(r * wide * Math.Sin(a)));
        }, closesAround: true);

    /// <summary>A ring whose section is a rectangle with round corners: a part with a hole and fillets.</summary>
    public static TriangleSoup Washer(int around, int perFillet, double fillet)
    {
        const double HalfWide = 0.25, HalfHigh = 0.12;
        var section = new List<(double X, double Y)>();
        for (int corner = 0; corner < 4; corner++)
        {
            for (int k = 0; k <= perFillet; k++)
            {
                (double sin, double cos) = Math.SinCos(Math.PI / 2 * (corner + k / (double)perFillet));
                double x = corner is 0 or 3 ? HalfWide - fillet : fillet - HalfWide;
                double y = corner < 2 ? HalfHigh - fillet : fillet - HalfHigh;
                section.Add((0.7 + x + fillet * cos, y + fillet * sin));
            }
        }

        return Sheet(
            around, section.Count, (i, j) =>
            {
                (double sin, double cos) = Math.SinCos(2 * Math.PI * i / around);
                return new((float)(section[j].X * cos), (float)section[j].Y, (float)(section[j].X * sin));
            }, closesAround: true, closesAcross: true);
    }

    /// <summary>A thread around y, two turns of it; a nut's is wider by the clearance.</summary>
    public static TriangleSoup Thread(int around, int along, double clearance) => Sheet(
        around, along, (i, j) =>
        {
            double a = 2 * Math.PI * i / around, y = 2.0 * j / along - 1;
            double phase = a / (2 * Math.PI) + y, r = 0.4 + clearance + 0.2 * Math.Abs(phase - Math.Round(phase));
            return new((float)(r * Math.Cos(a)), (float)y, (float)(r * Math.Sin(a)));
        }, closesAround: true);

    /// <summary>A wheel's rim with teeth, open at both ends.</summary>
    public static TriangleSoup Gear(int teeth, double depth) => Sheet(
        4 * teeth, 1, (i, j) =>
        {
            double a = 2 * Math.PI * i / (4 * teeth), r = i % 4 < 2 ? 1 : 1 - depth;
            return new((float)(r * Math.Cos(a)), 0.4f * j - 0.2f, (float)(r * Math.Sin(a)));
        }, closesAround: true);

    /// <summary>A band with one side and one border.</summary>
    public static TriangleSoup Moebius(int around, int across) => Sheet(around, across, (i, j) =>
    {
        double a = 2 * Math.PI * i / around, b = Math.PI * i / around, w = 0.8 * j / across - 0.4;
        if (i == around) (a, b, w) = (0, 0, -w);
        double r = 1 + w * Math.Cos(b);
        return new((float)(r * Math.Cos(a)), (float)(w * Math.Sin(b)), (float)(r * Math.Sin(a)));
    });

    /// <summary>Square teeth along x, up along y: rectangles whose corners lie on their neighbours' edges.</summary>
    public static TriangleSoup Comb(int teeth, float height)
    {
        var comb = new TriangleSoup([], []);
        float step = 1f / teeth;
        Vector3 back = Vector3.UnitZ * 0.3f, up = Vector3.UnitY * height, along = Vector3.UnitX * (step / 2);
        for (int i = 0; i < teeth; i++)
        {
            Vector3 low = new(i * step, 0, 0), high = low + along + up;
            foreach (Vector3 side in new[] { low, low + along })
                comb = comb.And(Rectangle(side, up, back));
            comb = comb.And(Rectangle(low + up, along, back)).And(Rectangle(high - up, along, back));
            comb = comb.And(Rectangle(low, along, up)).And(Rectangle(low + back, along, up));
        }

        return comb.And(Rectangle(-up, Vector3.UnitX, up)).And(Rectangle(-up, Vector3.UnitX, back));
    }

    /// <summary>Leaves that share a spine, some of them twice or the other way round.</summary>
    public static TriangleSoup Book(Rng random, int leaves)
    {
        Vector3[] points = [default, Vector3.UnitY, .. Enumerable.Range(0, leaves).Select(_ => random.Vector(1))];
        var indices = new List<int>();
        for (int i = 0; i < leaves; i++)
        {
            int[] leaf = random.OneIn(2) ? [0, 1, i + 2] : [i + 2, 1, 0];
            indices.AddRange(leaf);
            if (random.OneIn(5)) indices.AddRange(random.OneIn(2) ? leaf : [leaf[1], leaf[0], leaf[2]]);
        }

        return new TriangleSoup(points, [.. indices]);
    }

    private static TriangleSoup Rectangle(Vector3 at, Vector3 u, Vector3 v) =>
        new([at, at + u, at + u + v, at + v], [0, 1, 2, 0, 2, 3]);
}
