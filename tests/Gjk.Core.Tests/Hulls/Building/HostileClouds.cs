namespace Gjk.Core.Tests;

/// <summary>Clouds that make an incremental hull slow, in the order in which programs make them; and clouds with faces
/// of many corners and rims of many sides, where no list of candidates is short.</summary>
internal static class HostileClouds
{
    private static readonly Quaternion Turn = Quaternion.Normalize(new Quaternion(0.3f, 0.4f, -0.2f, 0.8f));

    private static readonly Dictionary<string, Func<int, Vector3[]>> Families = new()
    {
        ["ball"] = count => HullClouds.Ball(1, count),
        ["sphere"] = count => HullClouds.Sphere(1, count),
        ["grid"] = count => HullClouds.Grid((int)Math.Cbrt(count)),
        ["turned square"] = count => HullClouds.TurnedSquare(1, count),
        ["log spiral"] = LogSpiral,
        ["moment curve"] = count => Curve(count, t => (t, t * t, t * t * t)),
        ["shrinking moment curve"] = ShrinkingMomentCurve,
        ["helix"] = count => Curve(count, t => (Math.Cos(100 * t), Math.Sin(100 * t), t)),
        ["sphere spiral"] = count => Curve(count, SphereSpiral),
        ["cone"] = Cone,
        ["prism"] = Prism,
        ["turned prism"] = count => Turned(Prism(count)),
        ["far prism"] = count => Moved(Prism(count), new Vector3(200, -100, 300)),
        ["disc"] = count => Disc(count),
        ["turned disc"] = count => Array.ConvertAll(Disc(count), p => new Vector3(p.X, p.X, p.Y)),
        ["dome"] = Dome,
        ["turned dome"] = count => Turned(Dome(count)),
        ["cluster"] = Cluster,
        ["rings"] = count => [.. Disc(count / 3), .. Disc(count / 3, 1e-7f), .. Disc(count / 3, 0.00999f, 0.999f)],
        ["deep facets"] = DeepFacets,
        ["shrinking paraboloid"] = count => Curve(count, ShrinkingParaboloid),
        ["line and one"] = count => [.. Curve(count - 1, t => (t, 3 * t, 5 * t)), Vector3.UnitZ],
        ["powers of two"] = count => Index(count, i => new Vector3(Power(-i), Power(-2 * i), Power(-3 * i))),
        ["any floats"] = count => HullClouds.AnyFloats(1, count),
        ["two clusters"] = count => [.. HullClouds.Sphere(1, count / 2), .. FarCluster(count / 2)],
        ["nested spheres"] = count => Index(count, i => (1 - i % 10 * 1e-6f) * HullClouds.Sphere(i / 10, 1)[0]),
        ["denormals"] = count => HullClouds.SmallIntegers(1, count, 1 << 20, float.Epsilon),
        ["few points"] = count => Index(count, i => HullClouds.Sphere(i % 50, 1)[0]),
    };

    public static IEnumerable<string> Names => Families.Keys;

    public static Vector3[] Create(string family, int count = 3000) => Families[family](count);

    /// <summary>Ten turns, while the radius shrinks from 1 to e^-40 and the height with its square.</summary>
    public static Vector3[] LogSpiral(int count) => Curve(count, t =>
    {
        double r = Math.Exp(-40 * t), angle = 20 * Math.PI * t;
        return (r * Math.Cos(angle), r * Math.Sin(angle), r * r);
    });

    /// <summary>The moment curve at parameters from 1 down to 2^-40, evenly spaced in the exponent.</summary>
    public static Vector3[] ShrinkingMomentCurve(int count) => Curve(count, t =>
    {
        double s = Math.Pow(2, -40 * t);
        return (s, s * s, s * s * s);
    });

    /// <summary>A circle and an apex that is joined to all of it.</summary>
    public static Vector3[] Cone(int count) => [.. Disc(count - 1), Vector3.UnitZ];

    public static Vector3[] Disc(int sides, float height = 0, double radius = 1) =>
        Index(sides, i => OnCircle(i, sides, height, radius));

    public static Vector3[] Prism(int count) => Index(count, i => OnCircle(i / 2, count / 2, 2 * (i % 2) - 1));

    public static Vector3[] Turned(Vector3[] cloud) => Array.ConvertAll(cloud, p => Vector3.Transform(p, Turn));

    /// <summary>Parabolas in two planes, z = x exactly, whose points halve their distance from the vertex seventy
    /// times: coplanar points with magnitudes far apart.</summary>
    public static Vector3[] DeepFacets(int count) => Index(count, i =>
    {
        float x = (float)Math.Pow(2, -70.0 * (i / 2) / (count / 2));
        var p = new Vector3(x, x * x, x);
        return i % 2 == 0 ? p : -2 * p - Vector3.UnitX;
    });

    /// <summary>Points with one value of the hash of DistinctPoints, or one of two: y undoes what x did.</summary>
    public static Vector3[] Colliding(int count) => Index(count, i =>
    {
        unchecked
        {
            uint x = 0x3F000000u + 7 * (uint)i, h = x * 0x9E3779B1u;
            uint y = (h ^ h >> 15) & 0xBFFFFFFFu;
            return new Vector3(BitConverter.UInt32BitsToSingle(x), BitConverter.UInt32BitsToSingle(y), 0);
        }
    });

    private static (double X, double Y, double Z) ShrinkingParaboloid(double t)
    {
        double r = Math.Exp(-40 * t);
        return (r * Math.Cos(1e6 * t), r * Math.Sin(1e6 * t), r * r);
    }

    private static (double X, double Y, double Z) SphereSpiral(double t)
    {
        double r = Math.Sin(Math.PI * t);
        return (r * Math.Cos(300 * t), r * Math.Sin(300 * t), Math.Cos(Math.PI * t));
    }

    /// <summary>A box whose upper face bulges a thousandth: all its normals lie in a cell or two.</summary>
    private static Vector3[] Dome(int count)
    {
        int side = (int)Math.Sqrt(count - 4) - 1;
        List<Vector3> points = [new(-1, -1, -1), new(1, -1, -1), new(-1, 1, -1), new(1, 1, -1)];
        for (int i = 0; i <= side; i++)
        {
            for (int j = 0; j <= side; j++)
            {
                double x = 2.0 * i / side - 1, y = 2.0 * j / side - 1;
                points.Add(new Vector3((float)x, (float)y, (float)(1 - 0.001 * (x * x + y * y))));
            }
        }

        return [.. points];
    }

    /// <summary>Most of the points in one place.</summary>
    private static Vector3[] Cluster(int count) =>
    [
        .. Moved(HullClouds.Sphere(5, count - count / 6, 1e-6f), Vector3.One), .. HullClouds.Box(6, count / 6),
    ];

    private static Vector3[] Moved(Vector3[] cloud, Vector3 by) => Array.ConvertAll(cloud, p => p + by);

    private static Vector3 OnCircle(int i, int count, float height, double radius = 1)
    {
        (double sin, double cos) = Math.SinCos(2 * Math.PI * i / count);
        return new Vector3((float)(radius * cos), (float)(radius * sin), height);
    }

    private static Vector3[] FarCluster(int count) =>
        Moved(HullClouds.Sphere(2, count), new Vector3(1e10f, 2e10f, 3e10f));

    private static float Power(int exponent) => (float)Math.Pow(2, exponent % 149);

    private static Vector3[] Curve(int count, Func<double, (double X, double Y, double Z)> at) => Index(count, i =>
    {
        (double x, double y, double z) = at(i / (double)count);
        return new Vector3((float)x, (float)y, (float)z);
    });

    private static Vector3[] Index(int count, Func<int, Vector3> point) =>
        Enumerable.Range(0, count).Select(point).ToArray();
}
