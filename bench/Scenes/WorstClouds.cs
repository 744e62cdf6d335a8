namespace Gjk.Bench.Scenes;

/// <summary>Clouds of points that make an incremental hull slow. They have long thin orders, vertices with many edges,
/// coplanar and nearly coplanar points, repeats, and very different magnitudes. Each cloud is reproduced by its name
/// and its number of points.</summary>
internal static class WorstClouds
{
    private const double Turn = 2 * Math.PI;

    /// <summary>The generators by name. The first two are ordinary clouds for comparison.</summary>
    private static readonly (string Name, Func<int, Vector3[]> Create)[] Families =
    [
        ("ball", count => Random(count, prng => MathF.Cbrt(prng.Range(0, 1)) * prng.Direction())),
        ("sphere", count => Random(count, prng => prng.Direction())),
        ("jittered sphere", JitteredSphere),
        ("sphere of latitudes", Latitudes),
        ("nested spheres", count => Index(count, i => (1 - i % 10 * 1e-6f) * Fibonacci(i / 10, (count + 9) / 10))),
        ("lattice sphere", LatticeSphere),
        ("sphere spiral", count => Curve(count, t => Spiral(Math.Sin(Math.PI * t), 50 * t, Math.Cos(Math.PI * t)))),
        ("helix", count => Curve(count, t => Spiral(1, 100 * t, t))),
        ("short helix", count => Curve(count, t => Spiral(1, 3 * t, t))),
        ("log spiral", count => Curve(count, t => LogSpiral(t, 40))),
        ("slow log spiral", count => Curve(count, t => LogSpiral(t, 3))),
        ("conical spiral", count => Curve(count, t => Spiral(Math.Exp(-10 * t), 400 * t, Math.Exp(-10 * t)))),
        ("moment curve", count => Curve(count, Moments)),
        ("signed moment curve", count => Curve(count, t => Moments(2 * t - 1))),
        ("shrinking moment curve", count => Curve(count, t => Moments(Math.Pow(2, -40 * t)))),
        ("trigonometric curve", count => Curve(count, t => Spiral(1, t, Math.Cos(2 * Turn * t)))),
        ("shrinking paraboloid", count => Curve(count, t => Spiral(Math.Exp(-40 * t), 2e5 * t, Math.Exp(-80 * t)))),
        ("shrinking arcs", count => Index(count, i => ShrinkingArc(Fraction(i, count), i % 2))),
        ("crossed arcs", count => Index(count, i => CrossedArc(Fraction(i, count), i % 2))),
        ("cone", count => [.. Circle(count - 1, 0), Vector3.UnitZ]),
        ("double cone", count => [.. Circle(count - 2, 0), Vector3.UnitZ, -Vector3.UnitZ]),
        ("prism", count => [.. Circle(count / 2, 0), .. Circle(count - count / 2, 1)]),
        ("grid", Grid),
        ("turned grid", count => Turned(Grid(count))),
        ("line and one", count => [.. Curve(count - 1, t => (t, 3 * t, 5 * t)), Vector3.UnitZ]),
        ("one facet", count => [.. Square(count - 1), Vector3.UnitZ]),
        ("turned facet", count => Turned([.. Square(count - 1), Vector3.UnitZ])),
        ("turned square", count => Turned(Square(count))),
        ("points on edges", count => Random(count, OnEdge)),
        ("turned edges", count => Turned(Random(count, OnEdge))),
        ("cap", count => Random(count, prng => Cap(prng, 1e-3))),
        ("flat cap", count => Random(count, prng => Cap(prng, 1e-6))),
        ("paraboloid lattice", ParaboloidLattice),
        ("lifted circle and line", count => Index(count, i => LiftedCircleOrLine(i, count))),
        ("powers of two", count => Index(count, PowersOfTwo)),
        ("any exponents", count => Random(count, AnyExponents)),
        ("deep facet", count => [.. Index(count - 1, i => InDeepPlane(Fraction(i, count))), Vector3.UnitZ]),
        ("deep facets", count => Index(count, i => InDeepPlanes(Fraction(i, count), i % 2))),
        ("two clusters", count => Random(count, InOneOfTwoClusters)),
        ("denormals", count => Random(count, prng => float.Epsilon * Vector3.Round(3000 * prng.Direction()))),
        ("few points", count => Index(count, i => Fibonacci(i * 7 % 50, 50))),
        ("hash collisions", HashCollisions),
    ];

    public static IEnumerable<string> Names => Families.Select(f => f.Name);

    public static Vector3[] Create(string name, int count) => Families.Single(f => f.Name == name).Create(count);

    private static double Fraction(int i, int count) => i / (double)count;

    private static Vector3[] Index(int count, Func<int, Vector3> point)
    {
        var points = new Vector3[count];
        for (int i = 0; i < count; i++) points[i] = point(i);
        return points;
    }

    private static Vector3[] Random(int count, Func<Prng, Vector3> point)
    {
        var prng = new Prng(1);
        return Index(count, _ => point(prng));
    }

    private static Vector3[] Curve(int count, Func<double, (double X, double Y, double Z)> at) => Index(count, i =>
    {
        (double x, double y, double z) = at(Fraction(i, count));
        return new Vector3((float)x, (float)y, (float)z);
    });

    private static (double X, double Y, double Z) Spiral(double radius, double turns, double z) =>
        (radius * Math.Cos(Turn * turns), radius * Math.Sin(Turn * turns), z);

    private static (double X, double Y, double Z) LogSpiral(double t, double growth)
    {
        double r = Math.Exp(-growth * t);
        return Spiral(r, 10 * t, r * r);
    }

    private static (double X, double Y, double Z) Moments(double t) => (t, t * t, t * t * t);

    /// <summary>Points of two parabolas in perpendicular planes. The parabolas shrink towards a common
    /// vertex.</summary>
    private static Vector3 ShrinkingArc(double t, int which)
    {
        float r = (float)Math.Exp(-60 * t);
        return which == 0 ? new Vector3(r, r * r, 0) : new Vector3(0, -r, r * r);
    }

    /// <summary>Points of two perpendicular arcs. Every point of one arc is joined to the ends of the other.</summary>
    private static Vector3 CrossedArc(double t, int which)
    {
        float x = (float)(0.5 * (t - 0.5)), z = (float)(1 - 0.25 * (t - 0.5) * (t - 0.5));
        return which == 0 ? new Vector3(x, 0, z) : new Vector3(0, x, -z);
    }

    private static Vector3[] Circle(int count, double z) => Curve(count, t => Spiral(1, t, z));

    private static Vector3[] Square(int count) =>
        Random(count, prng => new Vector3(prng.Range(-1, 1), prng.Range(-1, 1), 0));

    private static Vector3 PowersOfTwo(int i) =>
        new(Power(i, 1), Power(i, 2), Power(i, 3) * (1 + i / 277 % 4));

    private static float Power(int i, int step) => (float)Math.Pow(2, -(step * i % 277) % 149);

    private static Vector3 AnyExponents(Prng prng) => new(AnyExponent(prng), AnyExponent(prng), AnyExponent(prng));

    private static float AnyExponent(Prng prng) => (float)(prng.Range(-1, 1) * Math.Pow(2, -prng.Index(120)));

    /// <summary>Points of a parabola that lies exactly in the plane z = x. They halve their distance from its vertex
    /// seventy times.</summary>
    private static Vector3 InDeepPlane(double t)
    {
        float x = (float)Math.Pow(2, -70 * t);
        return new Vector3(x, x * x, x);
    }

    private static Vector3 InDeepPlanes(double t, int which) =>
        which == 0 ? InDeepPlane(t) : -2 * InDeepPlane(t) - Vector3.UnitX;

    private static Vector3[] Grid(int count)
    {
        int side = (int)Math.Ceiling(Math.Cbrt(count));
        return Index(count, i => new Vector3(i % side, i / side % side, i / side / side));
    }

    private static Vector3[] Turned(Vector3[] points)
    {
        var turn = Quaternion.CreateFromYawPitchRoll(0.7f, 0.4f, 0.9f);
        return Array.ConvertAll(points, p => Vector3.Transform(p, turn));
    }

    /// <summary>Point i of a spiral from pole to pole with even density.</summary>
    private static Vector3 Fibonacci(int i, int count, double jitter = 0)
    {
        const double GoldenAngle = 2.399963229728653;
        double z = 1 - (2 * i + 1.0) / count, r = Math.Sqrt(Math.Max(0, 1 - z * z)) * (1 + jitter);
        return new Vector3((float)(r * Math.Cos(i * GoldenAngle)), (float)(r * Math.Sin(i * GoldenAngle)), (float)z);
    }

    private static Vector3[] JitteredSphere(int count)
    {
        var prng = new Prng(2);
        return Index(count, i => Fibonacci(i, count, prng.Range(-1e-7f, 1e-7f)));
    }

    /// <summary>Integer points with the same sum of squares. They lie exactly on a sphere, and many of them on one
    /// circle.</summary>
    private static Vector3[] LatticeSphere(int count)
    {
        // 5 * 13 * 17 * 29 has many representations as a sum of squares.
        for (long square = 32045; ; square = square * 5 / 4)
        {
            List<Vector3> points = LatticePoints(square);
            if (points.Count >= count) return Index(count, i => points[(int)((long)i * points.Count / count)]);
        }
    }

    private static List<Vector3> LatticePoints(long square)
    {
        long root = (long)Math.Sqrt(square);
        var points = new List<Vector3>();
        for (long x = -root; x <= root; x++)
        {
            for (long y = -root; y <= root; y++)
            {
                long rest = square - x * x - y * y, z = (long)Math.Round(Math.Sqrt(Math.Max(0, rest)));
                if (z * z != rest) continue;
                points.Add(new Vector3(x, y, z));
                if (z > 0) points.Add(new Vector3(x, y, -z));
            }
        }

        return points;
    }

    private static Vector3[] Latitudes(int count)
    {
        int rings = (int)Math.Sqrt(count / 2.0), perRing = count / rings;
        return Index(count, i =>
        {
            double polar = Math.PI * (i / perRing + 0.5) / (rings + 1), angle = Turn * (i % perRing) / perRing;
            double x = Math.Sin(polar) * Math.Cos(angle), z = Math.Sin(polar) * Math.Sin(angle);
            return new Vector3((float)x, (float)Math.Cos(polar), (float)z);
        });
    }

    private static Vector3 Cap(Prng prng, double width)
    {
        double r = width * Math.Sqrt(prng.Range(0, 1)), angle = Turn * prng.Range(0, 1);
        return new Vector3((float)(r * Math.Cos(angle)), (float)(r * Math.Sin(angle)), (float)Math.Sqrt(1 - r * r));
    }

    private static Vector3 InOneOfTwoClusters(Prng prng) =>
        prng.Index(2) * new Vector3(1e10f, 2e10f, 3e10f) + prng.Direction();

    private static Vector3 OnEdge(Prng prng)
    {
        float along = prng.Range(-1, 1);
        float a = prng.Index(2) * 2 - 1, b = prng.Index(2) * 2 - 1;
        return prng.Index(3) switch
        {
            0 => new Vector3(along, a, b),
            1 => new Vector3(a, along, b),
            _ => new Vector3(a, b, along),
        };
    }

    private static Vector3[] ParaboloidLattice(int count)
    {
        int side = (int)Math.Ceiling(Math.Sqrt(count));
        return Index(count, i => Lifted(i % side - side / 2, i / side - side / 2));
    }

    private static Vector3 LiftedCircleOrLine(int i, int count) =>
        i % 2 == 0 ? Lifted(Fraction(i, count), 0) : Lifted(Math.Cos(i), Math.Sin(i));

    /// <summary>The point of the paraboloid above (x, y). The hull of such points is a Delaunay
    /// triangulation.</summary>
    private static Vector3 Lifted(double x, double y) => new((float)x, (float)y, (float)(x * x + y * y));

    /// <summary>Points with one or two values of the hash of DistinctPoints. In the hash, y cancels the effect of
    /// x.</summary>
    private static Vector3[] HashCollisions(int count) => Index(count, i =>
    {
        uint x = 0x3F000000u + (uint)i * 7, h = x * 0x9E3779B1u, y = (h ^ h >> 15) & 0xBFFFFFFFu;
        return new Vector3(BitConverter.UInt32BitsToSingle(x), BitConverter.UInt32BitsToSingle(y), 0);
    });
}
