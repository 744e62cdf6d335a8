namespace Gjk.Exact.Meshes;

/// <summary>A subdivided icosahedron whose points are brought to the sphere in float, step by step, or in double at the
/// end. Points of shared edges are there twice.</summary>
public static class Icosphere
{
    private static readonly int[] Faces =
    [
        0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4, 11, 10, 2, 10, 7, 6, 7, 1, 8,
        3, 9, 4, 3, 4, 2, 3, 2, 6, 3, 6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11, 6, 2, 10, 8, 6, 7, 9, 8, 1,
    ];

    public static Vector3[] Any(Rng random)
    {
        int times = random.OneIn(8) ? 2 : random.Below(2);
        return random.OneIn(2) ? InFloat(times) : InDouble(times);
    }

    /// <summary>Every new point is the normalised middle of an edge, all in float.</summary>
    public static Vector3[] InFloat(int times)
    {
        List<Vector3> triangles = Corners(v => Vector3.Normalize((Vector3)v));
        for (int i = 0; i < times; i++) triangles = Split(triangles, (a, b) => Vector3.Normalize((a + b) * 0.5f));
        return [.. triangles];
    }

    private static Vector3[] InDouble(int times)
    {
        List<Double3> triangles = Corners(Unit);
        for (int i = 0; i < times; i++) triangles = Split(triangles, (a, b) => Unit(a + b));
        return [.. triangles.ConvertAll(v => (Vector3)v)];
    }

    private static List<T> Corners<T>(Func<Double3, T> make)
    {
        double g = (1 + Math.Sqrt(5)) / 2;
        Double3[] twelve =
        [
            new(-1, g, 0), new(1, g, 0), new(-1, -g, 0), new(1, -g, 0), new(0, -1, g), new(0, 1, g),
            new(0, -1, -g), new(0, 1, -g), new(g, 0, -1), new(g, 0, 1), new(-g, 0, -1), new(-g, 0, 1),
        ];
        var corners = new List<T>();
        foreach (int i in Faces) corners.Add(make(twelve[i]));
        return corners;
    }

    /// <summary>Four triangles for each one.</summary>
    private static List<T> Split<T>(List<T> triangles, Func<T, T, T> middle)
    {
        var smaller = new List<T>();
        for (int i = 0; i < triangles.Count; i += 3)
        {
            T a = triangles[i];
            T b = triangles[i + 1];
            T c = triangles[i + 2];
            T ab = middle(a, b);
            T bc = middle(b, c);
            T ca = middle(c, a);
            smaller.AddRange([a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca]);
        }

        return smaller;
    }

    private static Double3 Unit(Double3 v) => v * (1 / v.Length);
}
