namespace Gjk.Exact.Meshes;

/// <summary>Surfaces of revolution as programs make them: rings of a profile curve, the first point of each ring
/// repeated at its end (the seam of the texture).</summary>
public static class Lathe
{
    /// <summary>One ring for each radius and height, with or without the seam.</summary>
    public static Vector3[] Turned(
        Trigonometry trigonometry, IEnumerable<(double Radius, double Height)> profile, int count, bool seam) =>
        [.. profile.SelectMany(p => Ring(trigonometry, p.Radius, p.Height, count, seam))];

    /// <summary>A UV sphere: the rings at the poles are as wide as the sine of pi in the arithmetic used.</summary>
    public static Vector3[] Sphere(Rng random)
    {
        var t = Trigonometry.Any(random);
        return Sphere(t, Count(random), Count(random), !random.OneIn(3));
    }

    /// <inheritdoc cref="Sphere(Rng)"/>
    public static Vector3[] Sphere(Trigonometry t, int rings, int count, bool seam) =>
        Turned(t, Arc(t, rings, 0, rings, 1), count, seam);

    /// <summary>A sphere drawn out towards one pole.</summary>
    public static Vector3[] Egg(Rng random)
    {
        var t = Trigonometry.Any(random);
        int rings = Count(random);
        double length = random.Range(1, 2), waist = random.Range(0.1, 0.4);
        return Turned(
            t, Arc(t, rings, 0, rings, 1).Select(p => (p.Radius * (1 - waist * p.Height), p.Height * length)),
            Count(random), !random.OneIn(3));
    }

    /// <summary>The upper half of a sphere, with or without the middle of its base.</summary>
    public static Vector3[] Hemisphere(Rng random)
    {
        var t = Trigonometry.Any(random);
        int rings = 2 * (1 + Count(random) / 2);
        Vector3[] half = Turned(t, Arc(t, rings, 0, rings / 2, 1), Count(random), !random.OneIn(3));
        return random.OneIn(2) ? half : [.. half, Vector3.Zero];
    }

    /// <summary>Two half spheres apart, in the way of a sphere whose rings were moved up and down; the middle ring is
    /// there twice.</summary>
    public static Vector3[] Capsule(Rng random)
    {
        var t = Trigonometry.Any(random);
        int rings = 2 * (1 + Count(random) / 2);
        double half = random.OneIn(4) ? random.Magnitude(1e-7, 1e-1) : random.Range(0.2, 2);
        double radius = random.Range(0.3, 1);
        IEnumerable<(double, double)> profile = Arc(t, rings, 0, rings / 2, radius).Select(
            p => (p.Radius, p.Height + half))
            .Concat(Arc(t, rings, rings / 2, rings, radius).Select(p => (p.Radius, p.Height - half)));
        return Turned(t, profile, Count(random), !random.OneIn(3));
    }

    /// <summary>Body, shoulder and neck; the convex hull bridges the shoulder.</summary>
    public static Vector3[] Bottle(Rng random)
    {
        var t = Trigonometry.Any(random);
        double body = random.Range(0.3, 0.6), neck = body * random.Range(0.2, 0.5);
        (double, double)[] profile =
        [
            (0, -1), (body, -1), (body, 0.2), (0.5 * (body + neck), 0.5), (neck, 0.6), (neck, 1), (0, 1),
        ];
        return Turned(t, profile, Count(random), !random.OneIn(3));
    }

    /// <summary>Rings along a curve of sines, as a turner's tool would follow it.</summary>
    public static Vector3[] Vase(Rng random)
    {
        var t = Trigonometry.Any(random);
        int rings = Count(random);
        double wave = random.Range(0.5, 6), depth = random.Range(0, 0.4);
        return Turned(
            t,
            Enumerable.Range(0, rings + 1).Select(j => (0.5 + depth * Math.Sin(wave * j / rings), 2.0 * j / rings - 1)),
            Count(random), !random.OneIn(3));
    }

    /// <summary>A cone of rings: all points of the slope are on the hull or within rounding of it, and the apex is a
    /// ring of no width.</summary>
    public static Vector3[] Cone(Rng random)
    {
        var t = Trigonometry.Any(random);
        int rings = random.OneIn(2) ? 1 : Count(random);
        double radius = random.Range(0.2, 1), height = random.Range(0.3, 2);
        IEnumerable<(double, double)> slope = Enumerable.Range(0, rings + 1).Select(
            j => (radius * (rings - j) / rings, height * j / rings));
        return Turned(t, random.OneIn(2) ? slope : slope.Prepend((0, 0)), Count(random), !random.OneIn(3));
    }

    /// <summary>From 3 to 40, mostly few.</summary>
    public static int Count(Rng random) => (int)random.Magnitude(3, random.OneIn(8) ? 41 : 14);

    private static IEnumerable<Vector3> Ring(Trigonometry t, double radius, double height, int count, bool seam) =>
        Enumerable.Range(0, seam ? count + 1 : count).Select(i => t.OnRing(radius, height, i, count));

    /// <summary>Radius and height of rings i = first..last of a sphere that is cut into so many from pole to
    /// pole.</summary>
    private static IEnumerable<(double Radius, double Height)> Arc(
        Trigonometry t, int rings, int first, int last, double radius) =>
        Enumerable.Range(first, last - first + 1).Select(j => t.OfHalfTurns(j, rings)).Select(
            a => (radius * a.Sin, radius * a.Cos));
}
