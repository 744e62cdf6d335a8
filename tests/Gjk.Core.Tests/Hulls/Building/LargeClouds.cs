namespace Gjk.Core.Tests;

/// <summary>Clouds with faces of many corners and rims of many sides, where no list of candidates is short.</summary>
internal static class LargeClouds
{
    private static readonly Quaternion Turn = Quaternion.Normalize(new Quaternion(0.3f, 0.4f, -0.2f, 0.8f));

    public static Vector3[] Make(string kind) => kind switch
    {
        "prism" => Prism(1500),
        "turned prism" => Turned(Prism(1500)),
        "cone" => [.. Disc(2000), new Vector3(0, 0, 1)],
        "disc" => Disc(10000),
        "turned disc" => Array.ConvertAll(Disc(10000), p => new Vector3(p.X, p.X, p.Y)),
        "dome" => Dome(60),
        "turned dome" => Turned(Dome(60)),
        "cluster" => [.. Moved(HullClouds.Sphere(5, 1500, 1e-6f), Vector3.One), .. HullClouds.Box(6, 300)],
        "rings" => [.. Disc(800), .. Disc(800, 1e-7f), .. Array.ConvertAll(Disc(800, 0.01f), p => 0.999f * p)],
        "far prism" => Moved(Prism(1500), new Vector3(200, -100, 300)),
        _ => throw new ArgumentException(kind),
    };

    public static Vector3[] Turned(Vector3[] cloud) => Array.ConvertAll(cloud, p => Vector3.Transform(p, Turn));

    public static Vector3[] Moved(Vector3[] cloud, Vector3 by) => Array.ConvertAll(cloud, p => p + by);

    public static Vector3[] Disc(int sides, float height = 0)
    {
        var points = new Vector3[sides];
        for (int i = 0; i < sides; i++)
        {
            (double sin, double cos) = Math.SinCos(2 * Math.PI * i / sides);
            points[i] = new Vector3((float)cos, (float)sin, height);
        }

        return points;
    }

    public static Vector3[] Prism(int sides) => [.. Disc(sides, 1), .. Disc(sides, -1)];

    /// <summary>A box whose upper face bulges a thousandth: all its normals lie in a cell or two.</summary>
    private static Vector3[] Dome(int side)
    {
        var points = new List<Vector3> { new(-1, -1, -1), new(1, -1, -1), new(-1, 1, -1), new(1, 1, -1) };
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
}
